// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/LaserScan.h"
#include "robotlink/base/Clock.h"
#include "robotlink/config/RobotDescription.h"

namespace app {

/// Turns what a Pioneer says over its line into packages: the state of its base, the readings of its sonars and its laser.
/// The description says where its sensors are. One thread.
class PioneerPackages {
 public:
  PioneerPackages(std::string robot, const robotlink::RobotDescription& description)
      : robot_(std::move(robot)), description_(description) {}

  /// How many bumper segments it has, as its configuration says.
  void setBumpers(int front, int rear);
  /// Whatever comes next is of another connection: the odometry goes on from where it was.
  void restart() { last_.reset(); }
  /// The odometry is to begin at 0 again; it is for the owner to tell the robot, if it shall know.
  void resetOdometry();

  std::shared_ptr<const robotcontrol::DriveState> state(const robotlink::arcos::StandardInformation& information,
                                                        robotlink::Instant now);
  /// Null if there are none in the packet, as in those that come while the sonars are off.
  std::shared_ptr<const robotcontrol::SonarReadings> sonars(const robotlink::arcos::StandardInformation& information,
                                                            robotlink::Instant now) const;
  /// A part of a scan: the whole of it once the last part has come, else null.
  std::shared_ptr<const foxglove::LaserScan> laser(const robotlink::arcos::LaserPacket& part, robotlink::Instant now);

 private:
  struct Raw {
    std::int16_t x = 0, y = 0, heading = 0;
  };
  void follow(const robotlink::arcos::StandardInformation& information);

  const std::string robot_;
  const robotlink::RobotDescription& description_;
  int frontBumpers_ = 0, rearBumpers_ = 0;
  std::optional<Raw> last_;
  robotlink::Pose2 odometry_;  // of this robot's own counting, unwrapped
  robotlink::arcos::LaserScanAssembler assembler_;
};

}  // namespace app
