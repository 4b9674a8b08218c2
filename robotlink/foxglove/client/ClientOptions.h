// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "robotlink/foxglove/client/ConnectionState.h"
#include "robotlink/foxglove/protocol/MessageCodec.h"

namespace robotlink::websocket {

/// Limits of the resources that a server can use. Beyond one of them its connection ends, with a reason.
struct ClientLimits {
  std::size_t channels = 10'000, services = 10'000;
  /// The limit of all schemas together that it advertises, of its channels and again of its services.
  std::size_t schemaBytes = 64U << 20U;
  /// Calls of this client that are not answered yet, and bytes that wait to be sent.
  std::size_t calls = 1000, waitingBytes = 32U << 20U;
};

/// The handlers of a server's messages. All are called in the link's thread, one at a time, without a lock:
/// they may call the client. They should be quick; while one runs nothing is read, and the server sends less.
struct ClientHandlers {
  /// Called first after each connection. A server with another session id than before was restarted.
  std::function<void(const ServerInfo&)> connected = {};
  /// Called when the connection is lost; channels and services are gone without being removed one by one.
  std::function<void()> disconnected = {};
  std::function<void(const std::vector<Channel>&)> channelsAdded = {}, channelsRemoved = {};
  std::function<void(const std::vector<Service>&)> servicesAdded = {};
  std::function<void(const std::vector<std::string>& names)> servicesRemoved = {};
  /// Called with each message of a subscribed topic. The payload is valid during the call.
  std::function<void(const Channel&, Instant time, std::string_view payload)> message = {};
  std::function<void(const std::vector<Parameter>&)> parameters = {};
  std::function<void(const ConnectionGraphUpdate&)> graph = {};
  std::function<void(const Status&)> status = {};
};

}  // namespace robotlink::websocket
