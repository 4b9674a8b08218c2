// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/platforms/pioneer/PioneerBattery.h"
#include "app/platforms/simulated/world/PioneerGripper.h"
#include "robotlink/arcos/server/ServerSession.h"
#include "robotlink/base/Error.h"

namespace simcore {
class Simulation;
}

namespace app {

/// A simulated Pioneer's microcontroller: its inputs are the sensors of the simulated robot, its outputs the
/// wheels.
///
/// It has one client at a time, with which it exchanges packets as values: a program that runs here, or an
/// external one at the robot's TCP port (ArcosPorts), to which the other one gives way. One thread at a time;
/// the simulation must outlive it.
class SimulatedPioneer final : private robotlink::arcos::RangeFinders {
 public:
  /// The name of this controller in a model's drive.
  static constexpr const char* kController = "arcos";

  /// Settings of a simulated Pioneer.
  struct Options {
    /// The settings of the microcontroller; create() adapts them to the sensors of the model.
    robotlink::arcos::ServerSettings settings;
    /// Standard deviation of the relative error of the tires' size on each side. The errors are drawn once,
    /// from the seed and the robot's name, so that the odometry drifts as that of a real robot does.
    double tireError = 0.003;
    std::uint64_t seed = 1;
  };

  /// Fails if the simulated robot has no drive.
  static robotlink::Result<std::unique_ptr<SimulatedPioneer>> create(simcore::Simulation& simulation,
                                                                     std::string robot, Options options);
  const std::string& robot() const { return robot_; }
  /// Finds its wheels and sensors again after the simulation continued in another scene, in which they have
  /// other numbers. False, changing nothing, if they are others than before.
  bool rebind();

  /// Call this after each step of the physics; sets the wheels' speeds for the next one.
  void step(robotlink::Instant now);
  /// Call this after a reset of the simulation and its time. A client stays connected; the robot stops,
  /// and its odometry is 0.
  void reset(std::uint64_t seed);

  /// Call this when the simulation was put back or on to another instant, while the time continues: the
  /// robot was carried there, which its odometry does not notice.
  void worldJumped();

  /// Processes a packet of the present client.
  void take(const robotlink::arcos::Packet& packet, robotlink::Instant now);
  /// Removes and returns the packets for the present client.
  std::vector<robotlink::arcos::Packet> takeOutgoing();
  /// Ends the connection of the present client: the robot stops and waits for the next one.
  void clientGone(robotlink::Instant now);

  /// STOP: while the stop button is held, the motors are off, whatever clients request.
  void setStopButton(bool held) { stopButton_ = held; }

  /// Sets the address of an external client, empty if there is none. While there is one, the program that
  /// runs here only listens.
  void setOutsideClient(const std::string& address) { outsideClient_ = address; }
  const std::string& outsideClient() const { return outsideClient_; }
  /// Called with every packet between the robot and an external client.
  using Listener =
      std::function<void(const robotlink::arcos::Packet& packet, bool fromRobot, robotlink::Instant now)>;
  void setListener(Listener listener) { listener_ = std::move(listener); }

  const robotlink::arcos::ServerSession& session() const { return session_; }
  /// Removes and returns what clients requested of the simulator beyond this robot: messages, exit, maps.
  std::vector<robotlink::arcos::SimulatorRequest> takeRequests();
  /// Reports the outcome of a requested map to the client.
  void mapLoaded(const std::string& file, bool loaded, bool byUser) {
    session_.mapLoaded(file, loaded, byUser);
  }

 private:
  struct Ports;
  SimulatedPioneer(simcore::Simulation& simulation, std::string robot, Options options, Ports ports);
  /// Measures with a sonar, m. Called by the session.
  double sonar(int number) override;
  /// Measures a laser scan, m. Called by the session.
  std::span<const double> laser() override;
  /// Reads all sensors that the microcontroller has.
  robotlink::arcos::RobotSensing sense();
  /// Adds the ground truth, which simulators publish on request.
  void senseTruth(robotlink::arcos::RobotSensing& sensing) const;
  /// Reads the bumper segments as bits.
  void readBumpers(robotlink::arcos::RobotSensing& sensing) const;
  /// Draws the errors of the tires.
  void drawTires();
  /// Fulfills requests to place the robot; keeps the others for takeRequests().
  void fulfilRequests();
  /// Places the robot; if there is no room, the client gets a message.
  void place(const robotlink::Pose2& pose);
  /// The robot's pose in the field's frame.
  robotlink::Pose2 truePose() const;

  /// Indices of the robot's ports in the simulation.
  struct Ports {
    std::size_t drive = 0;
    std::optional<std::size_t> gyroscope;
    /// From left to right, as they are numbered.
    std::vector<std::size_t> frontBumpers, rearBumpers;
    /// In the order of their numbers; unset for sonars that the model lacks.
    std::vector<std::optional<std::size_t>> sonars;
    std::optional<std::size_t> laser;
    std::optional<PioneerGripper> gripper;
    std::optional<std::size_t> gps;
  };
  /// Fails if the robot has no drive.
  static robotlink::Result<Ports> findPorts(const simcore::Simulation& simulation, const std::string& robot,
                                            int sonars);

  simcore::Simulation& simulation_;
  const std::string robot_;
  Options options_;
  Ports ports_;
  robotlink::arcos::ServerSession session_;
  PioneerBattery battery_;
  /// The robot's pose at the start; a client can put it back there.
  robotlink::Pose2 start_;
  /// The distance that the encoders count per meter.
  double leftTire_ = 1, rightTire_ = 1;
  /// Whether the drive in the simulation is switched on.
  bool driveOn_ = true;
  bool stopButton_ = false;
  std::string outsideClient_;
  Listener listener_;
  /// For takeRequests().
  std::vector<robotlink::arcos::SimulatorRequest> requests_;
  /// The memory of laser scans.
  std::vector<double> scan_;
  /// The simulation's time of the last step.
  robotlink::Instant now_;
  /// The sum of the simulation's times before resets, since the session's time must not go back.
  robotlink::Duration timeBefore_{};
};

}  // namespace app
