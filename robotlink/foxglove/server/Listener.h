// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "robotlink/foxglove/server/ListenerOptions.h"
#include "robotlink/foxglove/server/Server.h"

namespace robotlink::websocket {

class ListenerPort;

/// A TCP port at which clients reach a server by WebSocket. One thread of its own does all input and output,
/// and calls the server's handlers; no client can make it wait. The destructor closes all connections; it
/// must not run in a handler.
class Listener {
 public:
  using Options = ListenerOptions;

  /// The error says why one cannot listen there, and what to do.
  static Result<std::unique_ptr<Listener>> open(std::shared_ptr<Server> server, Options options);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  /// The address with the port that was chosen.
  const ListenAddress& address() const { return address_; }

 private:
  explicit Listener(std::unique_ptr<ListenerPort> port);

  const std::unique_ptr<ListenerPort> port_;
  const ListenAddress address_;
};

}  // namespace robotlink::websocket
