// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The role of a player in its team.
enum class Role { kNone, kGoalie, kDefender, kSupporter, kStriker };

/// The role in words, as team messages have it: "striker"; empty for kNone.
const char* name(Role role);
/// The role of such a word; kNone if there is none.
Role roleOf(const std::string& word);

/// Another robot of the team, by its own report.
struct Mate {
  int number = 0;
  Role role = Role::kNone;
  /// In the team's frame.
  robotlink::Pose2 pose;
  /// Estimated time until it has the ball, s.
  double secondsToBall = 0;
  bool knowsBall = false;
};

/// The knowledge of a player about itself, the game and the world at one instant. The team's frame is that of
/// the field, turned so that the team plays toward +x; the robot's frame has x to its front. Meters, seconds.
/// A plain value.
struct GameSituation {
  enum class Phase { kInitial, kReady, kSet, kPlaying, kFinished };

  /// The present time by any clock.
  double time = 0;

  /// Without a referee the robot plays.
  Phase phase = Phase::kPlaying;
  bool penalized = false;
  /// Whether the own team has the kick-off, or there is no referee.
  bool ownKickOff = true;
  /// In the team, from 1.
  int number = 1;
  /// Given by the scene; kNone: the team decides.
  Role givenRole = Role::kNone;

  bool fallen = false;
  /// Lifted from the ground.
  bool pickedUp = false;
  /// The motion that is played can be left now.
  bool stable = true;
  /// A key-frame motion is being played.
  bool playsMotion = false;
  /// The camera shows colors of the field, so it is not blind.
  bool seesField = true;

  /// Since it saw a beacon or a goal, s; 0 if there is no such sense.
  double landmarkAge = 0;

  /// The robot in the team's frame; empty while it does not know where it is.
  std::optional<robotlink::Pose2> pose;

  /// Whether the robot knows where the ball is from what it saw itself, or from its team.
  bool knowsBall = false;
  /// The ball's position comes from teammates, not from the robot's own percepts.
  bool ballFromTeam = false;
  /// In the robot's frame; the velocity is over ground.
  robotlink::Vector2 ball = robotlink::Vector2::Zero();
  robotlink::Vector2 ballVelocity = robotlink::Vector2::Zero();
  /// Since the robot saw it itself, or the one of its team that reported it.
  double ballAge = 0;

  std::vector<Mate> mates;
  /// Other robots of either team, in the robot's frame.
  std::vector<robotlink::Vector2> robots;
  /// Opponents among them, in the team's frame.
  std::vector<robotlink::Vector2> opponents;

  /// The ball in the team's frame; empty if ball or pose are unknown.
  std::optional<robotlink::Vector2> ballInTeam() const {
    if (!knowsBall || !pose) return std::nullopt;
    return *pose * ball;
  }
  /// Whether the ball is visible now.
  bool seesBall() const { return knowsBall && !ballFromTeam && ballAge < 0.35; }
};

}  // namespace modules
