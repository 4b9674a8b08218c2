// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/core/pioneer/PioneerBattery.h"
#include "robotlink/arcos/server/ServerSession.h"
#include "robotlink/base/Error.h"

namespace simcore {
class Simulation;
}

namespace app {

/// A Pioneer of a simulation with its microcontroller: what the simulated robot senses goes to it, what it
/// says goes to the wheels.
///
/// One client at a time, whose packets go in and out as values: a program that runs here, or one that came
/// through the robot's TCP port (ArcosPorts), before which the first one steps back. The simulation must
/// outlive it; one thread at a time.
class SimulatedPioneer final : private robotlink::arcos::RangeFinders {
 public:
  /// The controller that a model's drive names to have this microcontroller.
  static constexpr const char* kController = "arcos";

  struct Options {
    robotlink::arcos::ServerSettings settings;
    /// Standard deviation of the shares by which each side's tires are larger or smaller than the encoders'
    /// ticks suppose. They are drawn once, from the seed and the robot's name: the odometry errs as that of a
    /// real robot does.
    double tireError = 0.003;
    std::uint64_t seed = 1;
  };

  /// Fails if the simulated robot has no drive.
  static robotlink::Result<std::unique_ptr<SimulatedPioneer>> create(simcore::Simulation& simulation,
                                                                     std::string robot, Options options);
  const std::string& robot() const { return robot_; }

  /// After each step of the world; tells the wheels what to do in the next one.
  void step(robotlink::Instant now);
  /// The simulation was reset, and its time with it. A client stays connected; the robot stands, its odometry
  /// is 0.
  void reset(std::uint64_t seed);

  /// From and to whoever is its client now.
  void take(const robotlink::arcos::Packet& packet, robotlink::Instant now);
  std::vector<robotlink::arcos::Packet> takeOutgoing();
  /// The present client is gone; the robot stops and waits for the next one.
  void clientGone(robotlink::Instant now);

  /// STOP: its stop button is held; the motors are off, whatever any client says.
  void setStopButton(bool held) { stopButton_ = held; }

  /// While a client is connected from outside (its address, else empty), the program that runs here only
  /// listens.
  void setOutsideClient(const std::string& address) { outsideClient_ = address; }
  const std::string& outsideClient() const { return outsideClient_; }
  /// Is told of every packet that goes between the robot and the client from outside.
  using Listener =
      std::function<void(const robotlink::arcos::Packet& packet, bool fromRobot, robotlink::Instant now)>;
  void setListener(Listener listener) { listener_ = std::move(listener); }

  const robotlink::arcos::ServerSession& session() const { return session_; }
  /// What clients asked of the simulator that concerns more than this robot: messages, exit, maps.
  std::vector<robotlink::arcos::SimulatorRequest> takeRequests();
  void mapLoaded(const std::string& file, bool loaded, bool byUser) {
    session_.mapLoaded(file, loaded, byUser);
  }

 private:
  struct Ports;
  SimulatedPioneer(simcore::Simulation& simulation, std::string robot, Options options, Ports ports);
  double sonar(int number) override;
  std::span<const double> laser() override;
  robotlink::arcos::RobotSensing sense();
  void senseTruth(robotlink::arcos::RobotSensing& sensing) const;
  void readBumpers(robotlink::arcos::RobotSensing& sensing) const;
  void drawTires();
  void fulfilRequests();
  void place(const robotlink::Pose2& pose);
  robotlink::Pose2 truePose() const;

  /// The indices of what the simulation calls its ports.
  struct Ports {
    std::size_t drive = 0;
    std::optional<std::size_t> gyroscope;
    std::vector<std::size_t> frontBumpers, rearBumpers;  ///< from left to right
    std::vector<std::optional<std::size_t>> sonars;      ///< by number
    std::optional<std::size_t> laser;
  };

  simcore::Simulation& simulation_;
  const std::string robot_;
  Options options_;
  const Ports ports_;
  robotlink::arcos::ServerSession session_;
  PioneerBattery battery_;
  robotlink::Pose2 start_;
  double leftTire_ = 1, rightTire_ = 1;  ///< what the encoders count for a meter
  bool driveOn_ = true;
  bool stopButton_ = false;
  std::string outsideClient_;
  Listener listener_;
  std::vector<robotlink::arcos::SimulatorRequest> requests_;
  std::vector<double> scan_;
  robotlink::Instant now_;  ///< of the simulation
  robotlink::Duration
      timeBefore_{};  ///< of the simulation's before it was reset: the session's time never goes back
};

}  // namespace app
