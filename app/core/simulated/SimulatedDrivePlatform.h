// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/pioneer/PioneerDriver.h"
#include "app/core/simulated/SimulatedPlatform.h"

namespace app {

class SimulatedPioneer;

/// The platform of a simulated robot on wheels: the same driver that a real one has speaks ARCOS with the
/// simulated microcontroller, packet by packet, without a line between them. While a client from outside
/// drives the robot through its port, the driver listens. The world must outlive it.
class SimulatedDrivePlatform final : public SimulatedPlatform {
 public:
  /// Fails if the simulated robot has no drive.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  /// Only now the driver takes the microcontroller over: another platform may have driven the robot until it
  /// was known that this one can be run.
  void initialize() override;
  void shutDown() override;
  void actuate() override;
  std::vector<robotlink::AnySender*> onRequest() override { return driver_.senders(); }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;

 protected:
  void execute() override;

 private:
  SimulatedDrivePlatform(SimulatedWorld& world, SimulatedPioneer& pioneer, std::string robot,
                         const robotlink::RobotDescription& description);

  SimulatedPioneer& pioneer_;
  PioneerDriver driver_;
  bool listens_ = false;
};

}  // namespace app
