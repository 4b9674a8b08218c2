// SPDX-License-Identifier: GPL-3.0-or-later
// For sources that include Asio and Beast anyway.
#pragma once

#include <boost/beast/websocket/rfc6455.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <cstddef>
#include <optional>
#include <string>

#include "robotlink/foxglove/client/LinkWatch.h"
#include "robotlink/foxglove/client/ServerUrl.h"
#include "robotlink/foxglove/transport/TransportStream.h"

namespace robotlink::websocket {

// The HTTP request by which a client asks a server for a WebSocket, and what is made of the answer of a
// server that may be any. The bytes between are Beast's (async_handshake()).

using ClientSocket = boost::beast::websocket::stream<TransportStream>;

/// The HTTP upgrade request of a client. A plain value.
struct UpgradeRequest {
  ServerUrl url;
  /// Shown as "Authorization: Bearer TOKEN"; empty: none.
  std::string token = {};
  /// The name that the client states.
  std::string name = {};
  /// The longest message that is taken afterward.
  std::size_t messageBytes = 0;
};

/// The reason why an answer does not establish a connection. A plain value.
struct UpgradeProblem {
  LinkWatch::Failure failure = LinkWatch::Failure::kEnded;
  /// A sentence that says what to do.
  std::string reason;
  ServerObjection objection = {};
};

/// Prepares a socket for its handshake.
void prepareUpgrade(ClientSocket& socket, const UpgradeRequest& request);
/// Returns the problem with an answer to the handshake, which ended with `error`; nothing if it succeeded.
std::optional<UpgradeProblem> problemWith(const boost::beast::websocket::response_type& response,
                                          const error_code& error, const UpgradeRequest& request);

}  // namespace robotlink::websocket
