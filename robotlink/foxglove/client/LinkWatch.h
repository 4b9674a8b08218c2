// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/foxglove/client/ConnectionState.h"

namespace robotlink::websocket {

/// Decides when to connect, to ask for a sign of life, and to give a connection up. It uses no socket: it is
/// told what happens, with the time, and asked what to do. Not thread-safe.
class LinkWatch {
 public:
  struct Times {
    /// The interval of signs of life; in silence one is asked for as often, and otherwise after
    /// roundTripInterval. An answer may have to wait behind a large message, and with it whatever the server
    /// would read next.
    Duration pingInterval = std::chrono::milliseconds(300), roundTripInterval = std::chrono::seconds(2);
    /// The time without a byte after which the link counts as silent, and after which it is reconnected.
    Duration silentTime = std::chrono::seconds(1), giveUpTime = std::chrono::seconds(3);
    /// Time for a connection of TCP, and for each further step of the handshake. Before the first success the
    /// steps may take firstStepTime, for lines that are very slow.
    Duration connectTime = std::chrono::seconds(1), stepTime = std::chrono::seconds(1),
             firstStepTime = std::chrono::seconds(5);
    /// Time for finding the address of a name, which the system may have to ask for several times.
    Duration lookupTime = std::chrono::seconds(30);
    /// The time between two attempts, and after a refusal.
    Duration retryTime = std::chrono::milliseconds(200), refusedTime = std::chrono::seconds(5);
  };
  enum class Action {
    kNone,
    kConnect,
    kPing,    ///< ask for a sign of life
    kPong,    ///< give one
    kGiveUp,  ///< close what there is; failed() was called already
  };
  /// Why a connection ended, or was not established.
  enum class Failure {
    kSilence,  ///< no byte was received
    kEnded,    ///< the other end closed it, or no server listens
    kRefused,  ///< the server does not want this client
  };

  LinkWatch(Times times, Instant now) : times_(times), since_(now), nextTry_(now) {}

  /// Returns the action to take now. Call it several times a second.
  Action next(Instant now);
  /// Call this when the address is known, and TCP begins to connect.
  void addressFound(Instant now);
  /// Call this after a step: TCP is connected, encryption is agreed on, the handshake is answered.
  void stepDone(Instant now);
  /// Call this when the server has said hello.
  void greeted(Instant now);
  /// Call this when any byte was received.
  void heard(Instant now) { heardAt_ = now; }
  /// Call this when connecting failed, or the connection ended.
  void failed(Failure failure, const std::string& reason, Instant now);

  ConnectionState::Phase phase() const { return phase_; }
  Instant since() const { return since_; }
  const std::string& reason() const { return reason_; }
  bool isGreeted() const { return step_ == Step::kOpen; }

 private:
  enum class Step { kWaiting, kLookup, kTcp, kHandshake, kOpen };
  using Phase = ConnectionState::Phase;
  void enter(Phase phase, Instant since, std::string reason);
  Duration stepLimit() const;
  Action nextWhileConnecting(Instant now);
  /// Why the current step of connecting has not ended.
  std::string whyNoStep() const;

  const Times times_;
  Step step_ = Step::kWaiting;
  Phase phase_ = Phase::kConnecting;
  Instant since_;
  std::string reason_;
  bool wasOpen_ = false;
  Instant nextTry_, stepAt_, heardAt_, pingedAt_, askedAt_;
};

}  // namespace robotlink::websocket
