// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modules/RollingBall.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// The ball as one robot of a team knows it, in the field.
struct BallReport {
  /// The robot that saw it.
  std::string robot;
  /// m and m/s.
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  robotlink::Vector2 velocity = robotlink::Vector2::Zero();
  /// The covariance of the position, m^2.
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  /// Since the robot saw the ball, s.
  double age = 0;
};

/// The ball as a team knows it, in the field.
struct FusedBall {
  /// m and m/s.
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  robotlink::Vector2 velocity = robotlink::Vector2::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  /// The robots whose reports are in it.
  std::vector<std::string> robots;
  /// Standard deviation of the position, m.
  double deviation() const;
};

/// The covariance of a ball in the field, m^2, that a robot knows with this deviation (m), while its own pose
/// has deviations of its place (m) and of its heading (rad), which moves far balls across.
Eigen::Matrix2d ballCovariance(const robotlink::Vector2& ballInField, double ballDeviation,
                               const robotlink::Pose2& robotInField, double positionDeviation,
                               double headingDeviation);

/// Fuses what the robots of a team know of the ball by covariance intersection (Julier, Uhlmann: A
/// non-divergent estimation algorithm in the presence of unknown correlations, 1997). That is right even
/// where reports are based on one another, as those of robots that localize by the same landmarks are.
///
/// Where reports contradict each other, the largest group of those that agree wins, by the sum of their
/// information. Immutable; any thread.
class TeamBallFusion {
 public:
  struct Options {
    /// Older reports are ignored, s.
    double memory = 4;
    /// The loss of certainty of a report, m after one second, growing with time.
    double drift = 0.15;
    /// Reports farther from each other than this many standard deviations contradict each other.
    double gate = 3;
    RollingBall roll;
  };
  explicit TeamBallFusion(const Options& options) : options_(options) {}

  /// Empty if no report is recent enough.
  std::optional<FusedBall> fuse(std::span<const BallReport> reports) const;

 private:
  /// A report as it is now.
  BallReport predicted(const BallReport& report) const;
  bool agree(const BallReport& a, const BallReport& b) const;

  Options options_;
};

}  // namespace modules
