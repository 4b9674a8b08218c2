// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "robotlink/arcos/ClientSession.h"
#include "robotlink/arcos/StateDecoder.h"
#include "robotlink/arcos/codec/RangeScan.h"

namespace robotlink::arcos {

/// The client's end of a conversation with a Pioneer, from the bytes of the line to SI units: it finds the
/// packets, keeps the connection (ClientSession), and decodes each packet once. PioneerRobot and the
/// workbench's driver are made of it; they differ in who moves the bytes and in what they do with the data.
///
/// Its owner has the line, or hands packets over as values where there is none: see ClientSession for the
/// order of the calls. Not thread-safe.
class PioneerClient {
 public:
  /// Receives what happens, in the order in which it happens, during the calls that take a packet or the
  /// time.
  class Listener {
   public:
    virtual ~Listener() = default;
    /// Called when a packet was received, or was taken from the outgoing ones. `frame` has its bytes, valid
    /// during the call; empty if it was handed over as a value.
    virtual void packetPassed(Direction, const Packet&, std::span<const std::uint8_t> /*frame*/, Instant) {}
    /// Called when bytes were received that are no packet.
    virtual void damageCame(const DamagedBytes&, Instant) {}
    /// The robot has identified itself: its odometry starts over.
    virtual void robotIdentified() {}
    virtual void configurationCame(const Configuration&) {}
    /// A new state(), from this packet.
    virtual void stateCame(const StandardInformation&, Instant) {}
    virtual void scanCame(const RangeScan&) {}
    /// In tick(), after the connection was established or lost.
    virtual void connectionChanged(bool /*connected*/, Instant) {}
  };

  /// The listener must outlive it.
  explicit PioneerClient(Listener& listener, const ClientSession::Options& options = {});
  /// Forgets all, counters, too.
  void reset();

  // --- The connection, as in ClientSession
  void open(Instant now) { session_.open(now); }
  void connectNow(Instant now) { session_.connectNow(now); }
  void close(Instant now) { session_.close(now); }
  bool wantsLink() const { return session_.wantsLink(); }
  /// Also drops what is left of the line before.
  void linkOpened(Instant now);
  void linkClosed(const Error& why, Instant now) { session_.linkClosed(why, now); }
  bool isConnected() const { return session_.isConnected(); }
  /// Handles timeouts, and sends what is due.
  void tick(Instant now);

  // --- From the robot
  /// Processes bytes of the line.
  void take(std::span<const std::uint8_t> bytes, Instant now);
  /// Processes a packet that was handed over as a value.
  void take(const Packet& packet, Instant now);
  /// Processes a packet of a conversation between the robot and another client: its data count, and nothing
  /// is answered. Until then close() has to be called.
  void overhear(const Packet& packet, Direction direction, Instant now);
  /// Call this if no byte arrived for `duration`, although the line was listened to: gives up a packet whose
  /// rest will not come any longer.
  void lineSilent(Duration duration);

  // --- To the robot
  Result<void> send(const Command& command, Instant now) { return session_.send(command, now); }
  Result<void> send(const Packet& packet, Instant now) { return session_.send(packet, now); }
  /// Sends SETO, and expects the odometry to jump to its origin.
  Result<void> resetOdometry(Instant now);
  /// The commands that ask a simulator for its laser; all have equal arguments. Old simulators know only the
  /// legacy ones.
  enum class LaserCommands { kUsual, kLegacy };
  /// Asks a simulator for scans of the angles from `startAngle` to `endAngle`, rad, with a reading for each
  /// degree.
  Result<void> startLaser(double startAngle, double endAngle, LaserCommands commands, Instant now);
  /// Cancels that, and forgets the last scan.
  Result<void> stopLaser(Instant now);
  /// Removes and returns what is to be sent, as packets or as the bytes of a frame each.
  std::vector<Packet> takeOutgoing(Instant now);
  std::vector<Bytes> takeOutgoingFrames(Instant now);
  /// Drops what is to be sent: the line is another's now.
  void dropOutgoing() { (void)session_.takePackets(); }

  // --- The state
  const ClientSession& session() const { return session_; }
  const PacketParser::Counters& received() const { return parser_.counters(); }
  /// The state of this connection or of the last one.
  const RobotState& state() const { return decoder_.state(); }
  const RobotType& type() const { return decoder_.type(); }
  /// The latest scan; empty before there is one.
  const std::optional<RangeScan>& scan() const { return scan_; }
  /// Whether the robot identified itself as a simulator, as the manufacturer's library decides it: such
  /// robots obey the commands of simulators.
  bool isSimulated() const;

 private:
  /// Tells the listener what a packet brought.
  void use(ClientSession::News news, Instant now);
  RangeScan toRangeScan(const LaserScan& laser) const;

  Listener& listener_;
  ClientSession::Options options_;
  PacketParser parser_;
  ClientSession session_;
  StateDecoder decoder_;
  std::optional<RangeScan> scan_;
  /// The angles of the first and the last reading, as they were asked for.
  double scanStart_ = -kPi / 2, scanEnd_ = kPi / 2;
  /// Whether it is connected according to the listener.
  bool connected_ = false;
};

}  // namespace robotlink::arcos
