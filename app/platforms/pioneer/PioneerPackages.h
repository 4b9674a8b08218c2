// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/RobotState.h"
#include "robotlink/arcos/codec/RangeScan.h"
#include "robotlink/arcos/codec/StandardInformation.h"
#include "robotlink/base/Clock.h"
#include "robotlink/config/RobotDescription.h"

namespace app {

/// Converts what a Pioneer's client has decoded to packages: the state of its base and the readings of its
/// sonars and laser, in SI units, radians and the robot's frame. The robot description says where the sensors
/// are. One thread.
class PioneerPackages {
 public:
  /// The description must outlive this object. `robot` is the frame of laser scans.
  PioneerPackages(std::string robot, const robotlink::RobotDescription& description);

  /// Sets the numbers of bumper segments that the robot reports in its configuration.
  void setBumpers(int front, int rear);
  /// Sets what the robot says about its battery in its configuration, V; 0: it says nothing.
  void setBattery(double low, double empty);
  /// Call this when a connection ends. The odometry of the next connection continues that of this one.
  void restart();
  /// Sets the odometry to 0. The robot's own odometry does not change.
  void resetOdometry();

  /// Returns the state of the base, with the odometry over all connections. `state` was decoded from the
  /// packet.
  std::shared_ptr<const robotcontrol::DriveState> state(
      const robotlink::arcos::RobotState& state, const robotlink::arcos::StandardInformation& information,
      robotlink::Instant now);
  /// Returns the sonar readings in a packet, whose ranges have this unit, m. Null if it has none, as while
  /// the sonars are off, or if the description has no sonars.
  std::shared_ptr<const robotcontrol::SonarReadings> sonars(
      const robotlink::arcos::StandardInformation& information, double unit, robotlink::Instant now) const;
  /// Returns a scan as a package; null if the description has no laser.
  std::shared_ptr<const foxglove::LaserScan> laser(const robotlink::arcos::RangeScan& scan) const;

 private:
  /// Adds the motion since the last packet to odometry_.
  void followOdometry(const robotlink::Pose2& now);

  const std::string robot_;
  const robotlink::RobotDescription& description_;
  int frontBumpers_ = 0, rearBumpers_ = 0;
  double batteryLow_ = 0, batteryEmpty_ = 0;
  /// The last pose by the robot's own odometry; unset at the beginning of a connection.
  std::optional<robotlink::Pose2> last_;
  /// The pose over all connections.
  robotlink::Pose2 odometry_;
};

}  // namespace app
