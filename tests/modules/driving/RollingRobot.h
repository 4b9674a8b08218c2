// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/navigation/RangeBeam.h"
#include "robotlink/base/Random.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/modules/driving/FlatWorld.h"

namespace modules {

/// A Pioneer in a FlatWorld as its modules perceive it: it accelerates and brakes slowly, its odometry drifts
/// by wheel slip, its sonars fire in turn, one on each side every 40 ms, and measurements are noisy.
class RollingRobot {
 public:
  struct Options {
    robotlink::Pose2 start;
    bool laser = true;
    /// Mean share of rotations and distances that the odometry misses.
    double skid = 0.02;
    std::uint64_t seed = 1;
  };
  static constexpr double kCycle = 0.1;  ///< s

  RollingRobot(const FlatWorld& world, const Options& options);

  /// Drives for one cycle.
  void drive(const DriveVelocity& request);
  /// The measurements of the last cycle.
  const std::vector<RangeBeam>& beams() const { return beams_; }
  /// The true pose.
  const robotlink::Pose2& pose() const { return pose_; }
  /// Starts at 0.
  const robotlink::Pose2& odometry() const { return odometry_; }
  const DriveVelocity& velocity() const { return velocity_; }
  robotlink::Instant now() const { return now_; }
  double time() const { return robotlink::seconds(now_); }
  const robotlink::RobotDescription& description() const { return description_; }
  DriveLimits limits() const;
  Outline outline() const;
  /// The minimum distance to a wall so far, m; 0: it has touched one and does not move any more.
  double nearest() const { return nearest_; }
  /// Distance driven, m.
  double way() const { return way_; }
  /// Moves the robot to another place unnoticed by its odometry.
  void carry(const robotlink::Pose2& pose) { pose_ = pose; }

 private:
  void fireSonars();
  void scan();

  const FlatWorld& world_;
  Options options_;
  robotlink::RobotDescription description_;
  robotlink::Random random_;
  robotlink::Pose2 pose_, odometry_;
  DriveVelocity velocity_;
  robotlink::Instant now_;
  std::vector<RangeBeam> beams_;
  double turnError_, wayError_;
  double nearest_ = 1;
  double way_ = 0;
  int ticks_ = 0;
  std::size_t fired_ = 0;
};

}  // namespace modules
