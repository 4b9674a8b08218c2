// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "app/core/simulated/SimulatedWorld.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/process/Platform.h"

namespace foxglove {
class RawImage;
}
namespace robotcontrol {
class ControlDrive;
class OracleWorld;
}  // namespace robotcontrol

namespace app {

/// The platform of one robot of a simulated world, whatever it moves by: sends its sensors' readings as
/// packages, and what is truly so, and moves it as requested. The world must outlive it.
class SimulatedPlatform : public robotlink::Platform {
 public:
  /// One for what the robot moves by: joints (SimulatedJointPlatform), wheels that a microcontroller turns
  /// (SimulatedDrivePlatform), or wheels that obey the program directly (SimulatedWheelPlatform).
  /// Fails if the simulated robot lacks what its description names.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  using LabeledListener =
      std::function<void(const foxglove::RawImage& image, const foxglove::RawImage& classes)>;
  /// Robots with a camera send the true classes with every image from now on, whether or not somebody
  /// receives them; the listener, which may be empty, is told of both.
  virtual void alwaysSendClasses(LabeledListener listener) { (void)listener; }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;

  void engageStop(bool engaged) override { stopEngaged_.store(engaged); }
  bool stopEngaged() const override { return stopEngaged_.load(); }

 protected:
  SimulatedPlatform(SimulatedWorld& world, std::string robot);
  SimulatedWorld& world() const { return world_; }
  const std::string& robot() const { return robot_; }
  void sendOracle();

 private:
  SimulatedWorld& world_;
  const std::string robot_;
  std::atomic<bool> stopEngaged_{false};
  robotlink::Sender<robotcontrol::OracleWorld> oracle_;
};

}  // namespace app
