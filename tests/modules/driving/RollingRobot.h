// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "modules/navigation/RangeBeam.h"
#include "robotlink/base/Random.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/modules/driving/FlatWorld.h"

namespace modules {

/// A Pioneer on the plane of a FlatWorld, as its modules meet it: it speeds up and brakes slowly, its
/// odometry is wrong by what its wheels skid, its sonars fire in turn, one of each side every 40 ms, and what
/// they measure is noisy.
class RollingRobot {
 public:
  struct Options {
    robotlink::Pose2 start;
    bool laser = true;
    double skid = 0.02;  ///< share of turns, and of ways, that the odometry misses, by chance more or less
    std::uint64_t seed = 1;
  };
  static constexpr double kCycle = 0.1;  ///< s

  RollingRobot(const FlatWorld& world, const Options& options);

  /// Drives for one cycle.
  void drive(const DriveVelocity& request);
  /// What its sensors measured in the last cycle.
  const std::vector<RangeBeam>& beams() const { return beams_; }
  const robotlink::Pose2& pose() const { return pose_; }          ///< the true one
  const robotlink::Pose2& odometry() const { return odometry_; }  ///< begins at 0
  const DriveVelocity& velocity() const { return velocity_; }
  robotlink::Instant now() const { return now_; }
  double time() const { return robotlink::seconds(now_); }
  const robotlink::RobotDescription& description() const { return description_; }
  DriveLimits limits() const;
  Outline outline() const;
  /// m, the nearest that it came to a wall; 0: it touched one, and does not move on.
  double nearest() const { return nearest_; }
  double way() const { return way_; }  ///< m, that it drove
  /// Carries it to another place; its odometry does not notice.
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
