// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/arcos/StateDecoder.h"
#include "robotlink/arcos/codec/LaserScan.h"
#include "robotlink/base/Clock.h"
#include "robotlink/config/RobotDescription.h"

namespace app {

/// Turns what a Pioneer says over its line into packages: the state of its base, the readings of its sonars
/// and its laser. The description says where its sensors are. One thread.
class PioneerPackages {
 public:
  PioneerPackages(std::string robot, const robotlink::RobotDescription& description);

  /// What kind of Pioneer it says to be: the units of its packets.
  void setSubclass(const std::string& subclass);
  /// How many bumper segments it has, as its configuration says.
  void setBumpers(int front, int rear);
  /// Whatever comes next is of another connection: the odometry goes on from where it was.
  void restart();
  /// The odometry is to begin at 0 again; it is for the owner to tell the robot, if it shall know.
  void resetOdometry();

  std::shared_ptr<const robotcontrol::DriveState> state(
      const robotlink::arcos::StandardInformation& information, robotlink::Instant now);
  /// Of the packet that state() was asked for last. Null if there are none in it, as in those that come while
  /// the sonars are off.
  std::shared_ptr<const robotcontrol::SonarReadings> sonars(
      const robotlink::arcos::StandardInformation& information, robotlink::Instant now) const;
  /// A part of a scan: the whole of it once the last part has come, else null.
  std::shared_ptr<const foxglove::LaserScan> laser(const robotlink::arcos::LaserPacket& part,
                                                   robotlink::Instant now);

 private:
  void followOdometry();

  const std::string robot_;
  const robotlink::RobotDescription& description_;
  int frontBumpers_ = 0, rearBumpers_ = 0;
  robotlink::arcos::StateDecoder decoder_;  // of this connection
  std::optional<robotlink::Pose2> last_;    // by the robot's own odometry, in this connection
  robotlink::Pose2 odometry_;               // over all connections
  robotlink::arcos::LaserScanAssembler assembler_;
};

}  // namespace app
