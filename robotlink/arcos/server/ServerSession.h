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
#include "robotlink/arcos/server/LaserService.h"
#include "robotlink/arcos/server/MotionController.h"
#include "robotlink/arcos/codec/Packet.h"
#include "robotlink/arcos/codec/SensorPackets.h"
#include "robotlink/arcos/server/RobotSensing.h"
#include "robotlink/arcos/server/ServerSettings.h"
#include "robotlink/arcos/server/SonarFiring.h"

namespace robotlink::arcos {

/// What a client asks of the simulator itself; to be fulfilled by the session's owner.
namespace simulator_request {
struct SetPose {
  Pose2 pose;  ///< true one, in the field; the odometry stays
};
/// Back to where the robot stood at the start; the odometry is 0 already.
struct Reset {};
struct LoadMap {
  std::string file;  ///< as the client wrote it; to be answered by mapLoaded()
};
struct Message {
  std::string text;  ///< to be shown
};
struct Exit {
  int status = 0;
};
}  // namespace simulator_request
using SimulatorRequest =
    std::variant<simulator_request::SetPose, simulator_request::Reset, simulator_request::LoadMap,
                 simulator_request::Message, simulator_request::Exit>;

/// The microcontroller of a Pioneer, the robot's side of ARCOS: handshake, commands, information packets,
/// watchdog. A state machine fed with packets and with what the robot senses; it moves no bytes and asks no
/// clock.
///
/// One client at a time. Whatever a client sends is harmless; memory is bounded as long as its owner takes
/// what goes out. Packets that go out are never longer than clients read, and never have the numbers 0xFE and
/// 0xFF, which clients take for a restart. One thread at a time.
class ServerSession {
 public:
  enum class State : std::uint8_t {
    kWaiting,     ///< for SYNC0; or a client is amid its handshake
    kIdentified,  ///< the handshake is done, OPEN has not come
    kOpen,        ///< information packets go out
  };
  /// What goes out and is not taken is dropped past this many packets, the newest first.
  static constexpr std::size_t kMaximumOutgoing = 1024;

  explicit ServerSession(ServerSettings settings = {});

  void take(const Packet& packet, Instant now);
  /// The line is closed: the robot stops, its parameters become those it began with, and it waits for the
  /// next client.
  void clientGone(Instant now);
  /// The robot was put elsewhere, and its encoders begin anew: it stands, and its odometry is 0.
  void robotReset();
  /// To be called every few milliseconds. The wheels' command holds until the next call.
  WheelCommand step(const RobotSensing& sensing, RangeFinders& ranges, Instant now);

  /// What goes to the client, oldest first.
  std::vector<Packet> takeOutgoing();
  std::vector<SimulatorRequest> takeRequests();
  /// Tells the client what is loaded now, whoever wanted it.
  void mapLoaded(const std::string& file, bool loaded, bool byUser);

  State state() const { return state_; }
  const ServerSettings& settings() const { return settings_; }
  const MotionController& motion() const { return motion_; }
  bool sonarOn() const { return sonars_.anyOn(); }
  /// Whether the true pose will be told with the next information packet; else it need not be known.
  bool tellsTruth() const;
  /// The watchdog has stopped the robot, which waits for the next packet.
  bool starved() const { return starved_; }
  std::uint64_t droppedPackets() const { return dropped_; }

 private:
  /// A packet that is sent once or with each information packet, as its command says: 0 never, 1 once, more
  /// always.
  struct Subscription {
    bool once = false, always = false;
    void ask(int argument);
    /// Whether it is to be sent with this information packet.
    bool take();
  };
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
  /// What a client set and what a new one shall not find.
  struct ClientState {
    std::array<Subscription, kSubscribables> subscriptions{};
    std::map<int, double> newSonars;  ///< m, by number: those measured since the last information packet
    std::vector<GyroPacket::Reading> gyroReadings;
    Instant nextGyroReading;
    bool gyroUsed = true;  ///< where the robot itself uses it
    int bumpStall = 0;
    std::uint8_t digitalOut = 0;
    std::optional<double> testedBattery;  ///< V, to be told instead of the real one
    bool gripperValueNext = false;        ///< the next GRIPPERVAL is the gripper's
  };

  void takeWaiting(const Packet& packet);
  void takeConnected(const Packet& packet);
  void open();
  void close();
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
  void ask(SimulatorRequest request);
  void send(Packet packet);
  Subscription& subscription(Subscribable which) { return client_.subscriptions[which]; }

  void checkWatchdog(Instant now);
  void checkBumpers(const RobotSensing& sensing);
  MotionController::Wheels wheelsOf(const RobotSensing& sensing) const;
  void fireSonars(RangeFinders& ranges, Instant now);
  void readGyroscope(const RobotSensing& sensing, Instant now);
  void sendCycle(const RobotSensing& sensing, RangeFinders& ranges);
  void sendRequested(const RobotSensing& sensing);

  const ServerSettings settings_;
  State state_ = State::kWaiting;
  int syncs_ = 0;  ///< of a handshake that have come
  MotionController motion_;
  SonarFiring sonars_;
  LaserService laser_;
  ClientState client_;
  std::optional<Instant> lastStep_;
  Instant lastHeard_, nextCycle_;
  bool starved_ = false;
  std::vector<Packet> outgoing_;
  std::uint64_t dropped_ = 0;
  std::vector<SimulatorRequest> requests_;
};

}  // namespace robotlink::arcos
