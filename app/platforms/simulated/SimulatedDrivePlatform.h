// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/platforms/pioneer/PioneerDriver.h"
#include "app/platforms/simulated/SimulatedPlatform.h"

namespace app {

class SimulatedPioneer;

/// The platform of a simulated Pioneer. The driver of real ones speaks ARCOS with the simulated
/// microcontroller, packet by packet, without a line in between. While an external client drives the robot
/// through its port, the driver only listens. World and description must outlive it.
class SimulatedDrivePlatform final : public SimulatedPlatform {
 public:
  /// Fails if the simulated robot has no microcontroller.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  /// Takes the microcontroller over. Not done earlier, since another platform may drive the robot until it is
  /// known that this one can be run.
  void initialize() override;
  /// Stops listening to the packets of external clients.
  void shutDown() override;
  /// Passes the driver's packets to the microcontroller, unless an external client drives the robot.
  void actuate() override;
  std::vector<robotlink::AnySender*> onRequest() override { return driver_.senders(); }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;

 protected:
  /// Passes the microcontroller's packets to the driver, and sends the packages.
  void execute() override;

 private:
  SimulatedDrivePlatform(SimulatedWorld& world, SimulatedPioneer& pioneer, std::string robot,
                         const robotlink::RobotDescription& description);

  /// Owned by the world.
  SimulatedPioneer& pioneer_;
  PioneerDriver driver_;
  /// Whether the listener of pioneer_ is this platform's.
  bool listens_ = false;
};

}  // namespace app
