// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"

namespace robotlink::websocket {

/// An objection of a server that the user can resolve, such as a missing token. A plain value.
struct ServerObjection {
  enum class Kind {
    kNone,
    kToken,             ///< the server wants another token
    kNewCertificate,    ///< unknown certificate, which the user has not confirmed yet
    kOtherCertificate,  ///< the certificate differs from the one shown before
  };
  Kind kind = Kind::kNone;
  /// "HOST:PORT", as KnownServers has it; of certificates.
  std::string server = {};
  /// The fingerprints of the presented certificate and of the known one.
  std::string fingerprint = {}, knownFingerprint = {};
  bool operator==(const ServerObjection&) const = default;
};

/// The state of a client's connection with its server. A plain value.
struct ConnectionState {
  enum class Phase {
    kConnecting,  ///< for the first time, or again after the server ended the connection
    kConnected,
    kSilent,   ///< was connected; nothing has been heard since
    kRefused,  ///< the server does not want this client; tried again from time to time
  };
  Phase phase = Phase::kConnecting;
  /// When the phase began, by the client's clock; silence begins with the last byte received.
  Instant since;
  /// Why it is not connected, and what to do: a sentence. Empty while it is, and at the very beginning.
  std::string reason = {};
  /// How long the newest sign of life that was answered took, there and back.
  std::optional<Duration> roundTrip = {};
  /// The bytes received over the last second.
  double bytesPerSecond = 0;
  /// The messages and bytes received since the beginning.
  std::uint64_t messages = 0, bytes = 0;
  /// The server's counts for this connection: messages replaced by newer ones, and messages lost. Unset if it
  /// does not count.
  std::optional<std::uint64_t> thinned = {}, dropped = {};
  /// How often it was connected.
  std::uint64_t connections = 0;
  /// The name that the server states; empty until it has sent it.
  std::string serverName = {};
  /// Whether it takes what this client publishes; not from clients that may only watch.
  bool takesMessages = false;
  /// The server's objection while it refuses this client, which tries again.
  ServerObjection objection = {};

  bool isConnected() const { return phase == Phase::kConnected; }
  bool operator==(const ConnectionState&) const = default;
};

/// For users: "connected, 12 ms, 1.3 MB/s", "silent for 3 s: ...". `now` is by the client's clock.
std::string describe(const ConnectionState& state, Instant now);

}  // namespace robotlink::websocket
