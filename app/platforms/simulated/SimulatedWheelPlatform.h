// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/simulated/SimulatedPlatform.h"
#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"

namespace app {

/// The platform of a simulated robot on wheels without a microcontroller between program and motors;
/// SimulatedDrivePlatform is for Pioneers, which have one.
///
/// It sends drive/state ten times per second, range/laser and range/sonar at the rates of the sensors, and
/// drives as drive/request asks, within the speeds and accelerations of the description. If the program sends
/// no request for kSilence, or STOP is engaged, the robot stops. Sensors are found by their kind, whatever
/// their names. World and description must outlive it.
class SimulatedWheelPlatform final : public SimulatedPlatform {
 public:
  /// Period of drive/state, and of range sensors that have no rate of their own.
  static constexpr robotlink::Duration kCycle = std::chrono::milliseconds(100);
  /// The time for which a drive request is valid.
  static constexpr robotlink::Duration kSilence = std::chrono::seconds(1);

  /// Fails if the simulated robot lacks the drive, laser or sonars of the description.
  static robotlink::Result<std::unique_ptr<SimulatedPlatform>> create(
      SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description);

  bool rebind() override;
  /// Sets the wheels' speeds as requested.
  void actuate() override;
  std::vector<robotlink::AnySender*> onRequest() override { return {&state_, &sonar_, &laser_}; }
  /// Switches motors and sonars, and resets the odometry. Fails for packets, and for motors while STOP is
  /// engaged.
  robotlink::Result<void> control(const robotcontrol::ControlDrive& details) override;

 protected:
  /// Sends the readings that are due.
  void execute() override;

 private:
  /// A range sensor: its index in the simulation, and when it measures next.
  struct Ranger {
    std::size_t port = 0;
    robotlink::Duration period{};
    robotlink::Instant due;
  };
  SimulatedWheelPlatform(SimulatedWorld& world, std::string robot,
                         const robotlink::RobotDescription& description);
  /// Finds drive and sensors in the simulation.
  robotlink::Result<void> bind();
  /// The error that the model lacks something that the description names.
  robotlink::Error lacks(const std::string& what) const;
  /// A range sensor that measures at once.
  Ranger rangerAt(std::size_t port) const;
  /// Changes forward_ and rotation_ toward these speeds by one step, within the accelerations of the
  /// description.
  void approach(double forward, double rotation);
  /// Adds the motion of the last step to odometry_.
  void followOdometry();
  void sendState();
  void sendSonars();
  void sendLaser();

  const robotlink::RobotDescription& description_;
  /// Index of the drive in the simulation.
  std::size_t drive_ = 0;
  std::optional<std::size_t> gyroscope_;
  std::optional<Ranger> laserRanger_;
  /// Indexed by the number of the sonar.
  std::vector<Ranger> sonarRangers_;
  /// The memory of laser scans.
  std::vector<double> scan_;

  bool motorsOn_ = true, sonarsOn_ = true;
  /// Speeds that are sent to the wheels, m/s and rad/s.
  double forward_ = 0, rotation_ = 0;
  robotlink::Instant requestCame_, stateDue_;
  /// Distances that the wheels had rolled at the last step, m.
  double leftTravel_ = 0, rightTravel_ = 0;
  /// The pose according to the encoders, since the platform was made or the odometry was reset.
  robotlink::Pose2 odometry_;

  robotlink::Sender<robotcontrol::DriveState> state_;
  robotlink::Sender<robotcontrol::SonarReadings> sonar_;
  robotlink::Sender<foxglove::LaserScan> laser_;
  robotlink::Receiver<robotcontrol::DriveRequest> request_;
};

}  // namespace app
