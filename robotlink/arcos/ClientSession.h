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

/// The client's end of a connection to a robot, without the line: it makes the connection, keeps it alive,
/// notices when it is lost, and makes it anew.
///
/// A state machine: it does something only in the calls below, which all take the time, and which may come as
/// often and as rarely as its owner likes (every 20 ms is good). Its owner has the line and a PacketParser:
///
///   session.open(now);
///   each turn: if (session.wantsLink() and there is no line) open it, then session.linkOpened(now) or
///              session.linkClosed(error, now); if (not session.wantsLink()) close it;
///              session.take(...) what the parser found; session.tick(now); write session.takeOutgoing()
///
/// One thread at a time. Errors' ids begin with "arcos.".
class ClientSession {
 public:
  enum class State {
    kClosed,           ///< nothing is wanted
    kPausing,          ///< waits before it tries again
    kWaitingForLink,   ///< its owner shall open the line
    kSynchronizing,    ///< SYNC0 to SYNC2
    kResynchronizing,  ///< lets the robot leave another connection, or restart, before SYNC0
    kOpening,          ///< waits for the configuration and the first standard information
    kConnected,
    kFailed,  ///< has given up: see problem()
  };

  struct Options {
    Duration syncTimeout = std::chrono::seconds(1);        ///< of the answer to each SYNC
    int syncTries = 5;                                     ///< unanswered, until the line is given up
    Duration closePause = std::chrono::milliseconds(300);  ///< after a robot was told to close, before SYNC0
    Duration openDelay = std::chrono::milliseconds(100);   ///< from the handshake to OPEN
    Duration configInterval = std::chrono::milliseconds(200);
    Duration configTimeout = std::chrono::seconds(1);         ///< then it goes on without
    Duration openTimeout = std::chrono::seconds(3);           ///< of the first standard information
    Duration pulseInterval = std::chrono::milliseconds(500);  ///< of silence, until a PULSE is sent
    Duration linkTimeout = std::chrono::seconds(8);  ///< without packet or without standard information
    /// CONFIG is asked for again so often, to measure the round trip; 0: never.
    Duration roundTripInterval = std::chrono::seconds(10);
    bool reconnect = true;
    Duration firstPause = std::chrono::seconds(1);  ///< before connecting again; doubled each time
    Duration longestPause = std::chrono::seconds(30);
  };

  struct Statistics {
    std::uint64_t packets = 0;      ///< of any kind, while there was a line
    std::uint64_t information = 0;  ///< standard information
    std::uint64_t undecodable = 0;  ///< whole packets that do not hold what their number promises
    std::uint64_t scans = 0;
    std::uint64_t incompleteScans = 0;
    std::uint64_t connections = 0;  ///< how often the robot was connected
    std::uint64_t losses = 0;       ///< how often a connection was lost
    Duration roundTrip{};           ///< of the last CONFIG that was answered; 0: none was
    Duration longestGap{};          ///< between two standard informations, over the last 5 s
  };

  ClientSession() : ClientSession(Options{}) {}
  explicit ClientSession(const Options& options) : options_(options) {}

  /// A connection is wanted. Does nothing if it is already.
  void open(Instant now);
  /// Somebody does not want to wait until it tries again: it does so at once.
  void connectNow(Instant now);
  /// No connection is wanted any more. If there is one: motors off and CLOSE; the owner should write
  /// takeOutgoing() before it closes the line.
  void close(Instant now);

  /// Whether its owner shall have a line open.
  bool wantsLink() const;
  void linkOpened(Instant now);
  /// The line could not be opened, broke or was closed by the robot, for this reason.
  void linkClosed(const Error& why, Instant now);

  void take(const Packet& packet, Instant now);
  /// Damage counts as nothing, but makes its error messages better.
  void take(const Damage& damage, Instant now);
  void take(const PacketParser::Found& found, Instant now);
  void tick(Instant now);
  /// What shall be written to the line, in whole packets. Empties itself.
  Bytes takeOutgoing();

  /// Sends a command. Fails if there is no connection or the argument does not fit.
  Result<void> send(const Command& command, Instant now);
  /// Sends any packet; fails if there is no connection or it is too long.
  Result<void> send(const Packet& packet, Instant now);

  State state() const { return state_; }
  bool isConnected() const { return state_ == State::kConnected; }
  /// A sentence on what it is doing.
  std::string describe() const;
  /// Why there is no connection; nothing while there is one, or while none went wrong.
  const std::optional<Error>& problem() const { return problem_; }

  /// What the robot sent on this connection, or on the last one. Null until it was sent.
  const Identity* identity() const { return identity_ ? &*identity_ : nullptr; }
  const Configuration* configuration() const { return configuration_ ? &*configuration_ : nullptr; }
  const StandardInformation* information() const { return information_ ? &*information_ : nullptr; }
  Instant informationAt() const { return informationAt_; }
  const LaserScan* laserScan() const { return scan_ ? &*scan_ : nullptr; }
  const Statistics& statistics() const { return statistics_; }

 private:
  void enter(State state, Instant now);
  void post(const Packet& packet, Instant now);
  void post(CommandId id, Instant now);
  void post(CommandId id, int argument, Instant now);

  void sendSync(int number, Instant now);
  void resynchronize(Instant now);
  bool mayTryAgain(Error why, Instant now);
  void retry(Error why, Instant now);
  void restart(Instant now);
  void giveUpLine(Error why, Instant now);
  void lose(Error why, Instant now);
  Error silence() const;

  void takeInHandshake(const Packet& packet, Instant now);
  void takeInConnection(const Packet& packet, Instant now);
  void takeInformation(const Packet& packet, Instant now);
  void takeConfiguration(const Packet& packet, Instant now);
  void takeLaser(const Packet& packet, Instant now);
  void askConfiguration(Instant now);

  void tickOpening(Instant now);
  void tickConnected(Instant now);
  void becomeConnected(Instant now);

  Options options_;
  State state_ = State::kClosed;
  int sync_ = 0;        ///< the number that was sent last
  int tries_ = 0;       ///< that failed, one after the other
  int unanswered_ = 0;  ///< that failed since the line was opened, or since the last connection
  int failures_ = 0;    ///< lines that failed since the last connection
  // Since the line was opened.
  bool heard_ = false;  ///< any packet
  std::uint64_t damages_ = 0;
  // In this connection.
  bool opened_ = false;  ///< OPEN was sent
  bool configured_ = false;
  bool informed_ = false;
  bool askedTwice_ = false;         ///< for the configuration, so no telling which is answered
  std::optional<Instant> askedAt_;  ///< the CONFIG that is not answered yet
  Instant lastAsked_{};

  Instant since_{};  ///< when state_ was entered, or its SYNC sent
  Duration pause_{};
  Instant openedAt_{};
  Instant openSentAt_{};
  Instant sentAt_{};
  Instant packetAt_{};
  Instant informationAt_{};
  std::optional<Error> problem_;
  Bytes outgoing_;

  std::optional<Identity> identity_;
  std::optional<Configuration> configuration_;
  std::optional<StandardInformation> information_;
  LaserScanAssembler assembler_;
  std::optional<LaserScan> scan_;
  struct Gap {
    Instant at;
    Duration length;
  };
  std::deque<Gap> gaps_;  ///< of the last 5 s, at most kMaximumGaps
  Statistics statistics_;
};

/// "connected", "synchronizing", ...
const char* nameOf(ClientSession::State state);

}  // namespace robotlink::arcos
