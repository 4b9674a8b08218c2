// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/foxglove/server/Reply.h"
#include "robotlink/foxglove/server/ServerChannel.h"

namespace robotlink::websocket {

/// A client, as users see it.
struct ClientInfo {
  /// The client's id, which this server never uses again.
  std::uint64_t id = 0;
  std::string address;
  /// The name that it states (the User-Agent of its HTTP request); may be empty.
  std::string name;
  /// Whether it may only watch: it sets, calls, publishes and plays nothing.
  bool isReadOnly = false;
  bool operator==(const ClientInfo&) const = default;
};

/// "RobotControl at 10.0.0.7:51234".
std::string shownName(const ClientInfo& client);

/// A client with what was sent to it.
struct ClientState {
  ClientInfo info;
  std::uint64_t sentBytes = 0;
  std::size_t waitingBytes = 0;
  /// The client's budget in bytes a second; 0 without limit.
  double budget = 0;
  /// The client's rates in messages a second, by topic; other topics have none.
  std::map<std::string, double> rates = {};
  /// The counters of what it subscribed to at some time, by topic.
  std::map<std::string, StreamCounters> streams;
};

/// The range from the first instant to the last.
struct TimeRange {
  Instant start, end;
  bool operator==(const TimeRange&) const = default;
};

struct ServerLimits {
  std::size_t clients = 16;
  /// Limits of each client.
  std::size_t subscriptions = 4096, channels = 64, parameterNames = 4096;
  /// Calls of services and settings of parameters of each client that are not answered yet.
  std::size_t calls = 32;
  /// The argument of a call that is sent in parts.
  std::size_t callBytes = 8U << 20U;
  Outbox::Limits outbox = {};
};

struct ServerOptions {
  std::string name = "RobotControl";
  std::map<std::string, std::string> metadata = {};
  /// Tells clients whether this is the server that they knew; made up if it is empty.
  std::string sessionId = {};
  /// The encodings of client channels and services.
  std::vector<std::string> encodings = {"json", "protobuf"};
  /// Whether publishTime() will be called.
  bool publishesTime = false;
  /// The time range of the log, if one is played.
  std::optional<TimeRange> playable = {};
  /// A client's initial budget, in bytes a second; 0 without limit.
  double budget = 0;
  ServerLimits limits = {};
  /// For when clients were heard; a Listener without a clock of its own uses it, too. Real time if there is
  /// none.
  std::shared_ptr<const Clock> clock = {};
};

/// The handlers of clients' requests. All are called in the link's thread, one at a time, and must not block:
/// long work is handed to another thread, which answers by the Reply. They may call the server. What has no
/// handler is not offered to clients.
struct ServerHandlers {
  /// After each change of a channel's subscribers; with none when the last has gone. Not when the channel is
  /// removed.
  std::function<void(const ChannelPtr& channel, const std::vector<ClientInfo>& subscribers)>
      subscribersChanged = {};
  /// Called after a client connected or disconnected.
  std::function<void(const std::vector<ClientInfo>&)> clientsChanged = {};

  /// The new values are those that the robot reports by Server::updateParameters() before it replies.
  std::function<void(const ClientInfo&, const std::vector<Parameter>&, Reply)> setParameters = {};

  std::function<void(const ClientInfo&, const ClientChannel&, std::string_view payload)> clientMessage = {};
  std::function<void(const ClientInfo&, const ClientChannel&)> clientAdvertised = {}, clientUnadvertised = {};

  std::function<void(const ClientInfo&, const PlaybackControl&)> playbackControl = {};

  /// Sentences for the robot's log: clients that were refused, and why.
  std::function<void(const std::string&)> report = {};
};

/// The clients that may call a service.
enum class ServiceAccess {
  kControl,  ///< clients that may do everything
  kAnybody,  ///< also those that may only watch; the handler may object
};

/// Answers a call of a service.
using ServiceHandler = std::function<void(const ClientInfo&, const ServiceCallRequest& call, Reply)>;

}  // namespace robotlink::websocket
