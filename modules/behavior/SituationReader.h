// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "modules/behavior/GameSituation.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/GamePackages.h"

namespace modules {

/// Reads the packages of which a player's situation is made; its solution must declare them by
/// declareInputs(). Used by its process's thread; the context must outlive it.
class SituationReader {
 public:
  struct Options {
    /// Deviations of the pose above which the robot does not know where it is, m and rad.
    double positionDeviation = 0.5, headingDeviation = 0.4;
    /// Share of the image that must be in the field's colors, or the robot is blind.
    double minimumColored = 0.03;
    /// Age of the own ball from which on that of the team is used, s.
    double teamBallAfter = 2;
    /// Age of a message after which its sender counts no more, s.
    double mateTimeout = 5;
    /// Confidence from which on another robot counts.
    double robotConfidence = 0.3;
  };

  /// Declares in the builder of a solution that it needs the ball model and uses the others.
  template <typename S>
  static robotlink::SolutionBuilder<S>& declareInputs(robotlink::SolutionBuilder<S>& solution) {
    return solution.needs(robotlink::kBallModel)
        .uses(robotlink::kRobotPose)
        .uses(robotlink::kPlayersModel)
        .uses(robotlink::kTeamBall)
        .uses(robotlink::kTeamMessages)
        .uses(robotlink::kGameState)
        .uses(robotlink::kRobotState)
        .uses(robotlink::kColorRegions)
        .uses(robotlink::kLandmarkPercepts)
        .uses(robotlink::kMotionStatus);
  }
  explicit SituationReader(robotlink::SolutionContext& context);

  /// Call it once a frame.
  GameSituation read(const Options& options);
  /// The pose of the team's frame in the field's.
  robotlink::Pose2 teamInField() const;
  const std::string& team() const { return team_; }

 private:
  void readGame(GameSituation& now) const;
  void readBody(GameSituation& now) const;
  void readLandmarks(GameSituation& now);
  void readBall(GameSituation& now, const Options& options) const;
  /// The time since one of the mates whose observations are in the team's ball saw it, s; empty if it is this
  /// robot's alone.
  std::optional<double> secondsSinceMatesSawBall(double now) const;
  void readRobots(GameSituation& now, const Options& options) const;
  void readMates(GameSituation& now, const Options& options) const;
  bool seesField(double minimumColored) const;

  const robotlink::Clock& clock_;
  std::string name_, team_;
  int number_ = 1;
  std::shared_ptr<const robotlink::FieldDescription> field_;
  robotlink::Input<robotcontrol::BallModel> ball_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  robotlink::Input<robotcontrol::PlayersModel> players_;
  robotlink::Input<robotcontrol::TeamBall> teamBall_;
  robotlink::Input<robotcontrol::TeamMessages> messages_;
  robotlink::Input<robotcontrol::GameState> game_;
  robotlink::Input<robotcontrol::RobotState> robotState_;
  robotlink::Input<robotcontrol::ColorRegions> regions_;
  robotlink::Input<robotcontrol::MotionStatus> status_;
  robotlink::Input<robotcontrol::LandmarkPercepts> landmarks_;
  /// The time at which one was last seen, s.
  std::optional<double> landmarkSeenAt_;
};

}  // namespace modules
