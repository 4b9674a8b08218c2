// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <deque>
#include <optional>

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/LaserScan.h"
#include "robotlink/arcos/codec/PacketParser.h"
#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/base/Clock.h"

namespace robotlink::arcos {

/// The client's end of a connection to a robot, without the line itself: it establishes the connection, keeps
/// it alive, detects its loss, and reconnects. The protocol is described in robotlink/arcos/ARCOS.md.
///
/// A state machine: it acts only in the calls below, which all take the time and may come at any rate (every
/// 20 ms is good). Its owner has the line and a PacketParser:
///
///   session.open(now);
///   in a loop: if (session.wantsLink() and there is no line) open it, then session.linkOpened(now) or
///              session.linkClosed(error, now); if (not session.wantsLink()) close it;
///              session.take(...) what the parser found; session.tick(now); write session.takeOutgoing()
///
/// Not thread-safe. Ids of errors begin with "arcos.".
class ClientSession {
 public:
  /// The phases of a connection; ARCOS.md has the diagram.
  enum class State {
    /// No connection is requested.
    kClosed,
    /// Waiting before the next attempt.
    kPausing,
    /// The owner should open the line.
    kWaitingForLink,
    /// Handshake: SYNC0 to SYNC2.
    kSynchronizing,
    /// Giving the robot time to leave an old connection, or to restart, before SYNC0.
    kResynchronizing,
    /// Waiting for the configuration and the first standard information.
    kOpening,
    /// Standard information arrives, commands can be sent.
    kConnected,
    /// Gave up because Options::reconnect is false: see problem().
    kFailed,
  };

  /// Timing of the protocol. The defaults suit real robots and simulators.
  struct Options {
    /// For the reply to each SYNC.
    Duration syncTimeout = std::chrono::seconds(1);
    /// Unanswered SYNCs in a row before the line is given up.
    int syncTries = 5;
    /// The pause after a CLOSE to an old connection, before SYNC0.
    Duration closePause = std::chrono::milliseconds(300);
    /// The delay from the handshake to OPEN.
    Duration openDelay = std::chrono::milliseconds(100);
    /// The interval of requests for the configuration while there is no reply.
    Duration configInterval = std::chrono::milliseconds(200);
    /// The time after which the connection counts as open without a configuration.
    Duration configTimeout = std::chrono::seconds(1);
    /// For the first standard information.
    Duration openTimeout = std::chrono::seconds(3);
    /// Silence on our side before a PULSE is sent; keeps the robot's watchdog from stopping it.
    Duration pulseInterval = std::chrono::milliseconds(500);
    /// The time without any packet, or without standard information, until the connection counts as lost.
    Duration linkTimeout = std::chrono::seconds(8);
    /// Interval of requests for the configuration that measure the round trip; 0 means never.
    Duration roundTripInterval = std::chrono::seconds(10);
    /// Whether to try again after a failure.
    bool reconnect = true;
    /// Pause before the first new attempt; doubled after each failure.
    Duration firstPause = std::chrono::seconds(1);
    Duration longestPause = std::chrono::seconds(30);
  };

  /// Counters since construction, and measurements.
  struct Statistics {
    /// Packets of any kind received while a connection was being made or open.
    std::uint64_t packets = 0;
    /// Standard information packets.
    std::uint64_t information = 0;
    /// Complete packets whose contents do not fit their id.
    std::uint64_t undecodable = 0;
    // Complete laser scans, and scans that lacked a part.
    std::uint64_t scans = 0;
    std::uint64_t incompleteScans = 0;
    /// How often the connection was established.
    std::uint64_t connections = 0;
    /// How often an established connection was lost.
    std::uint64_t losses = 0;
    /// The time from the last answered CONFIG to its reply; 0 if there was none.
    Duration roundTrip{};
    /// Longest time between two standard informations in the last 5 s.
    Duration longestGap{};
  };

  ClientSession() : ClientSession(Options{}) {}
  explicit ClientSession(const Options& options) : options_(options) {}

  /// Requests a connection. No effect if one is requested already.
  void open(Instant now);
  /// Skips the pause before the next attempt, and starts again after kFailed: for a user's "connect now".
  void connectNow(Instant now);
  /// Ends the connection. If there is one, switches the motors off and sends CLOSE; the owner should write
  /// takeOutgoing() before it closes the line.
  void close(Instant now);

  /// Whether the owner should keep a line open.
  bool wantsLink() const;
  /// The owner has opened the line; starts the handshake.
  void linkOpened(Instant now);
  /// The line could not be opened, broke, or was closed by the robot, for the given reason.
  void linkClosed(const Error& why, Instant now);

  /// The new content of a packet for a client; the data are in the getters below.
  enum class News { kNothing, kIdentity, kConfiguration, kInformation, kScan };
  /// Processes a received packet.
  News take(const Packet& packet, Instant now);
  /// Takes only the data of a packet that the robot sent to another client, while this session is closed.
  News overhear(const Packet& packet, Instant now);
  /// Damage is otherwise ignored, but improves error messages (wrong baud rate).
  void take(const DamagedBytes& damage, Instant now);
  /// Either of the two, as PacketParser::next() returns it.
  void take(const PacketParser::Found& found, Instant now);
  /// Handles timeouts, and sends what is due.
  void tick(Instant now);
  /// Removes and returns the bytes to be written to the line, in whole packets.
  Bytes takeOutgoing();
  /// The same as packets, for where there is no line.
  std::vector<Packet> takePackets();

  /// Sends a command. Fails if there is no connection, the argument does not fit, or the line is congested.
  Result<void> send(const Command& command, Instant now);
  /// Sends any packet. Fails if there is no connection, the packet is too long, or the line is congested.
  Result<void> send(const Packet& packet, Instant now);

  State state() const { return state_; }
  bool isConnected() const { return state_ == State::kConnected; }
  /// Describes the current activity to users, in a sentence.
  std::string describe() const;
  /// Why there is no connection; empty while there is one or if nothing has failed.
  const std::optional<Error>& problem() const { return problem_; }

  /// Data of this connection, or of the last one. Null until received.
  const Identity* identity() const { return identity_ ? &*identity_ : nullptr; }
  const Configuration* configuration() const { return configuration_ ? &*configuration_ : nullptr; }
  const StandardInformation* information() const { return information_ ? &*information_ : nullptr; }
  /// When information() was received.
  Instant informationAt() const { return informationAt_; }
  const LaserScan* laserScan() const { return scan_ ? &*scan_ : nullptr; }
  const Statistics& statistics() const { return statistics_; }

 private:
  /// Switches the state and restarts its timeout.
  void enter(State state, Instant now);
  /// Appends a packet to the outgoing ones.
  void post(const Packet& packet, Instant now);
  void post(CommandId id, Instant now);
  void post(CommandId id, int argument, Instant now);

  void dropOutgoing();

  /// Sends SYNC0, SYNC1 or SYNC2.
  void sendSync(int number, Instant now);
  /// Sends CLOSE and waits before the next SYNC0.
  void resynchronize(Instant now);
  /// Counts a failed try; returns false if it was the last one and the line was given up.
  bool mayTryAgain(Error why, Instant now);
  void retry(Error why, Instant now);
  void restart(Instant now);
  /// Gives up the line after a failure and starts the pause.
  void giveUpLine(Error why, Instant now);
  /// Gives up the line of an established connection, which counts as a loss.
  void lose(Error why, Instant now);
  /// The error for a timeout, depending on what has been received.
  Error silence() const;

  // Packets by phase and kind.
  News applyHandshake(const Packet& packet, Instant now);
  News applyConnection(const Packet& packet, Instant now);
  News takeIdentity(const Packet& packet);
  News takeInformation(const Packet& packet, Instant now);
  News takeConfiguration(const Packet& packet, Instant now);
  News takeLaser(const Packet& packet, Instant now);
  void askConfiguration(Instant now);

  void tickOpening(Instant now);
  void tickConnected(Instant now);
  void becomeConnected(Instant now);

  Options options_;
  State state_ = State::kClosed;
  /// The number of the last SYNC sent.
  int sync_ = 0;
  /// Failed tries in a row.
  int tries_ = 0;
  /// Failed tries since the line was opened, or since the last connection.
  int unanswered_ = 0;
  /// Failed lines since the last connection.
  int failures_ = 0;
  // Since the line was opened:
  /// Whether any packet has arrived.
  bool heard_ = false;
  std::uint64_t damages_ = 0;
  // In this connection:
  /// OPEN was sent.
  bool opened_ = false;
  // Configuration and standard information have been received.
  bool configured_ = false;
  bool informed_ = false;
  /// The configuration was requested again before a reply, so the reply cannot be matched to a request.
  bool askedTwice_ = false;
  /// When the pending CONFIG was sent.
  std::optional<Instant> askedAt_;
  Instant lastAsked_{};

  /// When state_ was entered, or its SYNC sent.
  Instant since_{};
  Duration pause_{};
  // Times of the last event of each kind.
  Instant openedAt_{};
  Instant openSentAt_{};
  Instant sentAt_{};
  Instant packetAt_{};
  /// The latest data of the connection.
  Instant informationAt_{};
  /// Outlives the line: shown until the next connection.
  std::optional<Error> problem_;
  std::vector<Packet> outgoing_;
  /// The size of all their frames.
  std::size_t outgoingBytes_ = 0;

  std::optional<Identity> identity_;
  std::optional<Configuration> configuration_;
  std::optional<StandardInformation> information_;
  LaserScanAssembler assembler_;
  std::optional<LaserScan> scan_;
  /// An interval between two standard informations that ended at `at`.
  struct Gap {
    Instant at;
    Duration length;
  };
  /// The gaps of the last 5 s, at most kMaxGaps.
  std::deque<Gap> gaps_;
  Statistics statistics_;
};

}  // namespace robotlink::arcos
