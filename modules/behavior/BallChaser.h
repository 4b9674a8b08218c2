// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "modules/behavior/Intention.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// The inputs of a behavior at one instant: its robot and the world, in the robot's frame unless noted
/// otherwise.
struct Situation {
  /// The present time by any clock, s.
  double time = 0;
  /// The ball was seen recently enough to be of use.
  bool ballKnown = false;
  /// Position of the ball's center on the ground, m.
  robotlink::Vector2 ball = robotlink::Vector2::Zero();
  /// Time since the ball was seen, s.
  double ballAge = 0;
  /// Position of the opponent's goal, m; empty while the robot does not know its own pose.
  std::optional<robotlink::Vector2> goal;
  /// The camera shows colors of the field, so it is not blind.
  bool fieldSeen = false;
  bool fallen = false;
  /// The motion task is playing key frames.
  bool kicking = false;
  /// The current motion can be left now.
  bool stable = true;
};

/// Walks to the ball and kicks it: a state machine on plain values.
///
/// Search: looks around while standing, then turns on the spot. It walks elsewhere only after a whole turn,
/// for a limited time, and only if it sees the field: a blind robot stands still. Chase: turns to the ball
/// and walks to a position behind it (as seen from the goal, if that is known), circles the ball until the
/// goal is behind it, then covers the last centimeters to where the kicking paw reaches the ball. The kick is
/// one key-frame motion; then the ball is searched again. A robot that fell gets up. Not thread-safe.
class BallChaser {
 public:
  /// The states; kBlind to kWander are the search, kApproach to kPosition the chase.
  enum class State {
    /// Stands still, since nothing of the field is seen.
    kBlind,
    /// Stands and moves its head.
    kLookAbout,
    /// Turns on the spot for a whole turn.
    kTurn,
    /// Walks ahead for a while to search in other places.
    kWander,
    /// Walks to a position behind the ball.
    kApproach,
    /// Stands near the ball and looks for beacons and goals.
    kGlance,
    /// Circles the ball until the goal is behind it.
    kAlign,
    /// Walks the last centimeters, until the kicking paw can reach the ball.
    kPosition,
    /// Plays the kick.
    kKick,
    /// Gets up after a fall.
    kGetUp
  };
  /// Speeds, times and tolerances.
  struct Options {
    /// Meters per second.
    double forwardSpeed = 0.15, sidewardSpeed = 0.10;
    /// Radians per second.
    double turnSpeed = 0.9;
    /// Seconds.
    double lookAboutTime = 2.5;
    double turnTime = 9;  ///< s, for slightly more than a whole turn
    /// Seconds.
    double wanderTime = 4;
    /// Meters per second.
    double wanderSpeed = 0.1;
    /// Time without colors of the field, s.
    double blindAfter = 1.0;
    /// Time without the ball, s.
    double lostAfter = 4;
    double glanceTime = 2.5;  ///< s, for beacons and goals
    /// Minimum time between glances, s.
    double glanceAgain = 12;
    /// Distance from the ball's center while circling it, m.
    double alignDistance = 0.32;
    /// Angle between ball and goal, rad.
    double alignTolerance = 0.35;
    /// The time after which it kicks in any direction, s.
    double alignTime = 8;
    /// The position of the ball for a kick, m.
    double kickX = 0.155, kickY = 0.0;
    double kickToleranceX = 0.02, kickToleranceY = 0.03;
    /// The time after which it approaches again, s.
    double positionTime = 8;
    /// Seconds.
    double kickTimeout = 5;
  };
  explicit BallChaser(const Options& options) : options_(options) {}
  /// Takes effect with the next decide().
  void setOptions(const Options& options) { options_ = options; }

  /// Updates the state and returns the request; call it once a frame.
  Intention decide(const Situation& now);
  State state() const { return state_; }
  /// The reason for entering the state, for logs.
  const std::string& reason() const { return reason_; }
  /// Whether the last decide() entered the state.
  bool changed() const { return changed_; }
  /// The position that it walks to, in the robot's frame; for drawings.
  const std::optional<robotlink::Vector2>& target() const { return target_; }

 private:
  void enter(State state, const char* reason, double time);
  // The transitions by group of states; each may enter another state.
  void transit(const Situation& now);
  void transitSearch(const Situation& now);
  void transitChase(const Situation& now);
  void transitKick(const Situation& now);
  /// Stricter than `ballKnown`: the ball is visible now.
  bool seesBall(const Situation& now) const { return now.ballKnown && now.ballAge < 0.3; }
  /// The angle between the ball and the goal behind it, seen from the robot; empty if the goal is unknown.
  std::optional<double> misalignment(const Situation& now) const;

  // The requests in the present state.
  Intention act(const Situation& now);
  Intention approach(const Situation& now);
  Intention align(const Situation& now) const;
  Intention position(const Situation& now) const;
  /// A walk in the direction `way`, at most at a fraction of the maximal speeds, keeping the direction.
  Intention walk(const robotlink::Vector2& way, double turn, double speedShare) const;

  Options options_;
  State state_ = State::kLookAbout;
  double enteredAt_ = 0;
  /// False before the first decide().
  bool started_ = false;
  double fieldSeenAt_ = 0;
  /// The motion task has confirmed that the kick is being played.
  bool kickBegan_ = false;
  double glancedAt_ = -1e9;
  /// 1 to the left, -1 to the right.
  double turnDirection_ = 1;
  std::string reason_;
  bool changed_ = false;
  std::optional<robotlink::Vector2> target_;
};

/// The state in words: "look about", "kick", ...
const char* name(BallChaser::State state);

}  // namespace modules
