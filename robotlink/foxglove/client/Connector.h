// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>

#include "robotlink/base/network/HostLookup.h"
#include "robotlink/foxglove/client/Client.h"
#include "robotlink/foxglove/client/LinkWatch.h"
#include "robotlink/foxglove/client/ServerUrl.h"

namespace robotlink::websocket {

class ConnectorThread;

/// Connects a client with a server by WebSocket, repeatedly until it is destroyed. One thread of its own
/// does all input and output and calls the client's handlers; nothing blocks the user of the client. The
/// destructor ends the connection and waits for the thread; it must not run in a handler. What went wrong is
/// in Client::state().
class Connector {
 public:
  struct Options {
    ServerUrl url;
    /// Shown as "Authorization: Bearer TOKEN"; empty: none.
    std::string token = {};
    /// With wss://: asked, in the connector's thread and without blocking it for long, whether a robot that
    /// was never seen is the intended one, by the fingerprint that it printed at its start. If not, it
    /// counts as refused, and is tried again later. Empty: it is trusted. A robot that was trusted once is
    /// remembered, and a robot that shows another fingerprint later is refused.
    std::function<bool(const std::string& server, const std::string& fingerprint)> isTrusted = {};
    /// The file in which that is remembered; empty: the user's.
    std::filesystem::path knownServers = {};
    /// The longest message of the server, and the longest of those that are JSON.
    std::size_t messageBytes = 64U << 20U, textBytes = 16U << 20U;
    LinkWatch::Times times = {};
    /// Finds the addresses of the robot's name; the system's if there is none.
    HostLookup::Resolver resolver = {};
    /// The limit of unsent data in the system: urgent messages wait behind it.
    int unsentBytes = 2 << 10;
    /// The name of this client, for users who watch the robot.
    std::string name = "RobotControl";
    /// For all times; real time if there is none.
    std::shared_ptr<const Clock> clock = {};
  };

  Connector(std::shared_ptr<Client> client, Options options);
  ~Connector();
  Connector(const Connector&) = delete;
  Connector& operator=(const Connector&) = delete;

 private:
  const std::unique_ptr<ConnectorThread> thread_;
};

}  // namespace robotlink::websocket
