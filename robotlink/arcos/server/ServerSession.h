// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/arcos/codec/SensorPackets.h"
#include "robotlink/arcos/server/AuxiliarySerial.h"
#include "robotlink/arcos/server/GripperControl.h"
#include "robotlink/arcos/server/LaserService.h"
#include "robotlink/arcos/server/MotionController.h"
#include "robotlink/arcos/server/RobotSensing.h"
#include "robotlink/arcos/server/ServerSettings.h"
#include "robotlink/arcos/server/SonarFiring.h"

namespace robotlink::arcos {

/// Requests of a client to the simulator itself, which the session's owner fulfills.
namespace simulator_request {
/// Move the robot.
struct SetPose {
  /// The true pose in the field; the odometry does not change.
  Pose2 pose;
};
/// Move the robot to its initial pose; its odometry is 0 already.
struct Reset {};
/// Load a map.
struct LoadMap {
  /// The file name as the client wrote it; the owner answers with mapLoaded().
  std::string file;
};
/// Show a text to the user.
struct Message {
  std::string text;
};
/// End the simulator.
struct Exit {
  int status = 0;
};
}  // namespace simulator_request
using SimulatorRequest =
    std::variant<simulator_request::SetPose, simulator_request::Reset, simulator_request::LoadMap,
                 simulator_request::Message, simulator_request::Exit>;

/// The microcontroller of a Pioneer, the robot's end of ARCOS: handshake, commands, information packets,
/// watchdog. A state machine fed with packets and sensor readings; it moves no bytes and reads no clock. See
/// ARCOS.md.
///
/// One client at a time. Anything a client sends is safe; memory is bounded as long as the owner takes the
/// outgoing packets. Outgoing packets are never longer than clients can read, and never have the ids 0xFE and
/// 0xFF, which clients take for a restart. Not thread-safe.
class ServerSession {
 public:
  enum class State : std::uint8_t {
    /// Waiting for SYNC0, or in the middle of a handshake.
    kWaiting,
    /// The handshake is complete; waiting for OPEN.
    kIdentified,
    /// Information packets are being sent.
    kOpen,
  };
  /// When this many packets wait in takeOutgoing(), further ones are dropped.
  static constexpr std::size_t kMaxOutgoing = 1024;

  explicit ServerSession(ServerSettings settings = {});

  /// Processes a client's packet; resets the watchdog.
  void take(const Packet& packet, Instant now);
  /// The client has disconnected: the robot stops, parameters are reset, and the session waits for the next
  /// client.
  void clientGone(Instant now);
  /// The robot was moved and its encoders start again: it stops, and its odometry is 0.
  void robotReset();
  /// Call this when the encoders continue from other numbers, which does not affect the odometry.
  void encodersJumped() { motion_.encodersJumped(); }
  /// Advances to `now`; call it every few milliseconds. The returned command for the wheels holds until the
  /// next call.
  WheelCommand step(const RobotSensing& sensing, RangeFinders& ranges, Instant now);

  /// Removes and returns the packets for the client, oldest first.
  std::vector<Packet> takeOutgoing();
  /// Removes and returns the client's requests to the simulator.
  std::vector<SimulatorRequest> takeRequests();
  /// Informs the client which map is loaded now; `byUser` if the user rather than the client requested it.
  void mapLoaded(const std::string& file, bool loaded, bool byUser);

  State state() const { return state_; }
  const ServerSettings& settings() const { return settings_; }
  const MotionController& motion() const { return motion_; }
  /// Returns the command to the gripper's motors until the next step, if the robot has a gripper.
  const GripperCommand& gripperCommand() const { return gripperCommand_; }
  /// Whether the next information packet will be followed by the true pose; otherwise sensing need not
  /// contain it.
  bool publishesTruth() const;
  /// Whether the watchdog has stopped the robot until the next packet.
  bool starved() const { return starved_; }
  /// Packets dropped because they were too long, had a reserved id, or were not taken in time.
  std::uint64_t droppedPackets() const { return dropped_; }

 private:
  /// Packets that the client requests once or with every information packet: the command's argument is 0 for
  /// never, 1 for once, more for always.
  struct Subscription {
    bool once = false, always = false;
    void ask(int argument);
    /// Whether to send the packet with this information packet.
    bool take();
  };
  /// The packets that can be subscribed to.
  enum Subscribable : std::uint8_t {
    kEncoder,
    kIo,
    kImu,
    kGyro,
    kJoystick,
    kBattery,
    kGripper,
    kStatus,
    kSubscribables
  };
  /// Settings of the current client, reset for the next one.
  struct ClientState {
    std::array<Subscription, kSubscribables> subscriptions{};
    /// Ranges measured since the last information packet, m, by sonar.
    std::map<int, double> newSonars;
    /// Readings for the next gyroscope packet.
    std::vector<GyroPacket::Reading> gyroReadings;
    Instant nextGyroReading;
    /// Whether a robot with its own gyroscope uses it.
    bool gyroUsed = true;
    /// Bit 0: front bumpers count as stalls; bit 1: rear bumpers do.
    int bumpStall = 0;
    std::uint8_t digitalOut = 0;
    /// V, reported instead of the real voltage.
    std::optional<double> testedBattery;
    /// The next GRIPPERVAL is for the gripper, not for the laser.
    bool gripperValueNext = false;
  };

  /// Packets while waiting for a client.
  void takeWaiting(const Packet& packet);
  /// Packets after the handshake.
  void takeConnected(const Packet& packet);
  void open();
  void close();
  /// Executes a command; the obey...() functions return false if the command is of another group.
  void obey(const Command& command);
  bool obeyTranslation(const Command& command);
  bool obeyRotation(const Command& command);
  bool obeyLimits(const Command& command);
  bool obeySubscription(const Command& command);
  bool obeySonar(const Command& command);
  bool obeyLaser(const Command& command);
  bool obeyDevices(const Command& command);
  bool obeySimulator(const Packet& packet);
  void obeySimulatorControl(const Packet& packet);
  /// Adds a request to the simulator; dropped if there are too many.
  void ask(SimulatorRequest request);
  /// Adds an outgoing packet; dropped if it is not allowed or if there are too many.
  void send(Packet packet);
  Subscription& subscription(Subscribable which) { return client_.subscriptions[which]; }

  /// Stops the robot if the client has been silent for too long.
  void checkWatchdog(Instant now);
  void checkBumpers(const RobotSensing& sensing);
  /// The encoders and, if the robot uses it, the gyroscope.
  MotionController::Wheels wheelsOf(const RobotSensing& sensing) const;
  /// Receives a position of the GPS receiver once a second, and sends what was asked of its line.
  void serveAuxiliary(const RobotSensing& sensing, Instant now);
  void fireSonars(RangeFinders& ranges, Instant now);
  void readGyroscope(const RobotSensing& sensing, Instant now);
  /// Sends the packets of a cycle in the order that clients expect.
  void sendCycle(const RobotSensing& sensing, RangeFinders& ranges);
  /// Sends the subscribed packets that come after the information packet.
  void sendRequested(const RobotSensing& sensing);

  const ServerSettings settings_;
  State state_ = State::kWaiting;
  /// How many SYNCs of the handshake have arrived.
  int syncs_ = 0;
  MotionController motion_;
  SonarFiring sonars_;
  LaserService laser_;
  AuxiliarySerial auxiliary_;
  /// When the GPS receiver sends its next position.
  Instant nextPosition_;
  GripperControl gripper_;
  GripperCommand gripperCommand_;
  ClientState client_;
  /// Empty before the first step.
  std::optional<Instant> lastStep_;
  Instant lastHeard_, nextCycle_;
  bool starved_ = false;
  std::vector<Packet> outgoing_;
  std::uint64_t dropped_ = 0;
  std::vector<SimulatorRequest> requests_;
};

}  // namespace robotlink::arcos
