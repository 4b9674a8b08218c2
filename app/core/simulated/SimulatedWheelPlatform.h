// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/simulated/SimulatedPlatform.h"
#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"

namespace app {

/// The platform of a simulated robot on wheels whose motors obey the program directly: no microcontroller
/// stands between them, as it does in a Pioneer (SimulatedDrivePlatform).
///
/// Sends drive/state ten times a second, range/laser and range/sonar at their sensors' rates, and drives as
/// drive/request wants, within the speeds and accelerations of its description. A program that says nothing
/// for kSilence leaves the robot standing; while STOP is engaged it stands, too. Sensors are found by their
/// kind, whatever they are called. The world must outlive it.
class SimulatedWheelPlatform final : public SimulatedPlatform {
 public:
  static constexpr robotlink::Duration kCycle = std::chrono::milliseconds(100);
  static constexpr robotlink::Duration kSilence = std::chrono::seconds(1);

  /// Fails if the simulated robot lacks the drive, laser or sonars that its description names.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  void actuate() override;
  std::vector<robotlink::AnySender*> onRequest() override { return {&state_, &sonar_, &laser_}; }
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;

 protected:
  void execute() override;

 private:
  /// A range sensor of the simulation, and when it measures next.
  struct Ranger {
    std::size_t port = 0;
    robotlink::Duration period{};
    robotlink::Instant due;
  };
  SimulatedWheelPlatform(SimulatedWorld& world, std::string robot,
                         const robotlink::RobotDescription& description);
  robotlink::Result<void> bind();
  robotlink::Error lacks(const std::string& what) const;
  Ranger rangerAt(std::size_t port) const;
  void approach(double forward, double rotation);
  void followOdometry();
  void sendState();
  void sendSonars();
  void sendLaser();

  const robotlink::RobotDescription& description_;
  std::size_t drive_ = 0;
  std::optional<std::size_t> gyroscope_;
  std::optional<Ranger> laserRanger_;
  std::vector<Ranger> sonarRangers_;  // by number
  std::vector<double> scan_;

  bool motorsOn_ = true, sonarsOn_ = true;
  double forward_ = 0, rotation_ = 0;  // m/s, rad/s, that the wheels are told
  robotlink::Instant requestCame_, stateDue_;
  double leftTravel_ = 0, rightTravel_ = 0;  // m, at the last step
  robotlink::Pose2 odometry_;

  robotlink::Sender<robotcontrol::DriveState> state_;
  robotlink::Sender<robotcontrol::SonarReadings> sonar_;
  robotlink::Sender<foxglove::LaserScan> laser_;
  robotlink::Receiver<robotcontrol::DriveRequest> request_;
};

}  // namespace app
