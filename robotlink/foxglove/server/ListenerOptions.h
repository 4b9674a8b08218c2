// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "robotlink/base/Clock.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"
#include "robotlink/foxglove/security/Certificate.h"
#include "robotlink/foxglove/server/Admission.h"
#include "robotlink/foxglove/server/ListenAddress.h"

namespace robotlink::websocket {

/// The options of a Listener. A plain value.
struct ListenerOptions {
  ListenAddress address = {"127.0.0.1", kDefaultPort};
  Admission::Options admission = {};
  /// Connections are encrypted with it (TLS 1.2 at least); nothing: they are not.
  std::optional<Certificate> certificate = {};
  /// The longest message of a client, and the longest of those that are JSON.
  std::size_t messageBytes = 8U << 20U, textBytes = 1U << 20U;
  /// Messages of one client a second. A client that sends more is read more slowly.
  double messagesPerSecond = 2000;
  /// Connections that have not asked for WebSocket yet; further ones are closed at once.
  std::size_t handshakes = 16;
  Duration handshakeTime = std::chrono::seconds(5);
  /// The time limit of a message from its first to its last byte.
  Duration messageTime = std::chrono::seconds(120);
  /// The silence after which a client is asked for a sign of life, and the one after which it is given up.
  Duration pingInterval = std::chrono::seconds(5), idleTime = std::chrono::seconds(30);
  /// How long a client that is asked to close its connection may take.
  Duration closeTime = std::chrono::seconds(2);
  /// Between the answer to the handshake and the first message. Some clients lose messages that come
  /// together with that answer.
  Duration greetingDelay = std::chrono::milliseconds(100);
  /// The limit of data that the system holds unsent, per client; the rest waits where newer messages
  /// replace it.
  int unsentBytes = 16 << 10;
  /// Clients of other machines that can (permessage-deflate) are sent all but images compressed. On loopback
  /// that only costs time; this is for tests.
  bool compressesLoopback = false;
  /// For all these times and for budgets; the server's if there is none.
  std::shared_ptr<const Clock> clock = {};
};

}  // namespace robotlink::websocket
