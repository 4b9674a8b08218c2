// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/core/team/GameEnds.h"
#include "app/platforms/simulated/world/SimulatedWorld.h"
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

/// The platform of one robot of a simulated world, whatever it moves by: sends the readings of its sensors
/// and the ground truth (oracle/world) as packages, and moves it as requested. The world must outlive it.
class SimulatedPlatform : public robotlink::Platform {
 public:
  /// Makes the platform that fits what the robot moves by: joints (SimulatedJointPlatform), wheels with a
  /// microcontroller (SimulatedDrivePlatform), or wheels without one (SimulatedWheelPlatform). Fails if the
  /// simulated robot lacks what its description names. The description must outlive the platform.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  /// Finds the robot's motors and sensors again after the simulation continued in another scene, where they
  /// have other numbers. False if they are others than before, so that the robot needs another platform.
  virtual bool rebind() { return true; }

  /// Lets the robot play: from now on it offers and takes the packages of games. Call this before its
  /// program is made.
  void joinGame(std::shared_ptr<GameMail> mail) { game_.emplace(*this, std::move(mail)); }

  /// Called with an image and its true classes.
  using LabeledListener =
      std::function<void(const foxglove::RawImage& image, const foxglove::RawImage& classes)>;
  /// Makes a robot with cameras send the true classes with every image from now on, even without a receiver.
  /// The listener may be empty.
  virtual void alwaysSendClasses(LabeledListener listener) { (void)listener; }
  /// Refused by default, since the robot has no wheels.
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;

  void engageStop(bool engaged) override { stopEngaged_.store(engaged); }
  bool stopEngaged() const override { return stopEngaged_.load(); }

 protected:
  SimulatedPlatform(SimulatedWorld& world, std::string robot);
  SimulatedWorld& world() const { return world_; }
  const std::string& robot() const { return robot_; }
  /// Exchanges what concerns the game, if the robot plays. Call this in each frame.
  void exchangeGame() {
    if (game_) game_->exchange();
  }
  /// Sends oracle/world: the true poses of the robot, the ball and the other robots in the field's frame, and
  /// that of its camera.
  void sendOracle();

 private:
  SimulatedWorld& world_;
  const std::string robot_;
  std::atomic<bool> stopEngaged_{false};
  robotlink::Sender<robotcontrol::OracleWorld> oracle_;
  std::optional<GameEnds> game_;
};

}  // namespace app
