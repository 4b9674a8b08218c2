// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <set>
#include <span>

#include "robotlink/foxglove/protocol/CallPart.h"
#include "robotlink/foxglove/server/ConnectionGraph.h"
#include "robotlink/foxglove/server/ServerOptions.h"

namespace robotlink::websocket {

/// The parameter by which a client reads and sets its own budget in bytes a second (0: no limit), and the one
/// with its counters by topic. The second is only sent to clients that name it.
inline constexpr char kBudgetParameter[] = "link/budget";
inline constexpr char kCountersParameter[] = "link/counters";
/// How often a client gets messages of a topic of which the latest counts, in messages a second (0: all): an
/// object by topic, of which each setting replaces the whole.
inline constexpr char kRatesParameter[] = "link/rates";
/// The number by which others know a client (SteeringStatus.client); cannot be set.
inline constexpr char kClientParameter[] = "link/client";

/// The server's end of the Foxglove WebSocket protocol, without a transport: its offers, the subscriptions,
/// and the messages that wait to be sent. A Listener connects it with TCP.
///
/// The robot's side may be called from any thread and never waits for a client. Channels and publishers may
/// outlive the server.
class Server : public std::enable_shared_from_this<Server> {
 public:
  static std::shared_ptr<Server> make(ServerOptions options, ServerHandlers handlers);
  ~Server();

  // The robot's side.

  /// Announces channels to all clients in one message. Channels are remade each time: ids are not used
  /// again.
  std::vector<ChannelPtr> addChannels(std::vector<ChannelSetup> setups);
  void removeChannels(std::span<const ChannelPtr> channels);

  /// The id is given by the server, and returned.
  std::uint32_t addService(Service service, ServiceHandler handler,
                           ServiceAccess access = ServiceAccess::kControl);
  void removeService(std::uint32_t id);

  /// Sets or, without a value, removes parameters; changes go to clients that subscribed to them.
  void updateParameters(const std::vector<Parameter>& parameters);
  void setConnectionGraph(ConnectionGraph graph);
  void publishTime(Instant time);
  /// Sets the robot's time back: no later one is sent with the newest messages of latched channels.
  void setBackLatched(Instant time);
  /// While it exists, messages of channels wait for its end, so that those that are published together are
  /// sent together. Keep it shorter than they may be late.
  class Batch {
   public:
    explicit Batch(Server& server);
    ~Batch();
    Batch(const Batch&) = delete;
    Batch& operator=(const Batch&) = delete;

   private:
    Server& server_;
  };

  void publishPlaybackState(const PlaybackState& state);
  /// Sets the playable range of time of the open log; none: there is no log. At first it is that of the
  /// options. If it changes, clients get the information about the server again.
  void setPlayable(const std::optional<TimeRange>& range);
  /// Sends a status to all clients that are connected.
  void publishStatus(const Status& status);

  std::vector<ClientState> clients() const;
  std::size_t clientCount() const;
  const Clock& clock() const { return *options_.clock; }
  /// Returns when a client was last heard from; nothing if it is gone.
  std::optional<Instant> heardAt(std::uint64_t clientId) const;
  /// Asks these clients for signs of life after `pingEvery` of silence, and others as the link does.
  void watch(const std::set<std::uint64_t>& clientIds, Duration pingEvery);
  /// Tells one client something, if it is still there.
  void sendStatus(std::uint64_t clientId, const Status& status);
  /// Tells a client why, and closes its connection.
  void disconnect(std::uint64_t clientId, const std::string& reason);

  // The link's side: one thread, in which handlers are called.

  /// Fails if there are too many clients. `wake` is called from any thread when there is something to send
  /// again after next() found nothing; it must not block or call the server. The id of `info` is given here.
  Result<ClientPtr> connect(ClientInfo info, std::function<void()> wake);
  /// Call this when the connection has ended. Afterward `wake` is no longer called.
  void disconnected(const ClientPtr& client);
  void received(const ClientPtr& client, FrameKind kind, std::string_view bytes);
  std::optional<Outgoing> next(ServedClient& client, Instant now);
  /// Why a client has to be closed once next() finds nothing more; empty if it need not.
  std::string closingReason(const ServedClient& client) const;
  /// Tells the robot's log.
  void report(const std::string& sentence) const;

 private:
  friend class ServerChannel;
  using Calls = std::vector<std::function<void()>>;
  struct OfferedService {
    Service service;
    std::shared_ptr<const ServiceHandler> handler;
    ServiceAccess access = ServiceAccess::kControl;
  };

  Server(ServerOptions options, ServerHandlers handlers);

  void publish(ServerChannel& channel, Instant time, SharedBytes payload);
  void noteThinned(const ServerChannel& channel);

  /// A message as it is sent, to one client or several.
  struct SharedFrame {
    FrameKind kind = FrameKind::kText;
    SharedBytes bytes;
  };
  static SharedFrame sharedFrame(const ServerMessage& message);

  // With the mutex locked.
  // Clients that may only watch are told that nothing is taken from them.
  std::vector<std::string> capabilities(const ServedClient& client) const;
  ServerInfo info(const ServedClient& client) const;
  /// All channels and services, as a new client gets them.
  std::vector<SharedFrame> offer() const;
  void greet(ServedClient& client);
  void push(const ServerChannel& channel, const ServerChannel::Subscriber& to, Instant time,
            const SharedBytes& payload);
  void send(ServedClient& client, const ServerMessage& message);
  void sendAll(const ServerMessage& message);
  void sendShared(ServedClient& client, FrameKind kind, const SharedBytes& bytes);
  static void wake(ServedClient& client);
  /// The same for a message of a channel, which may wait for the end of a Batch.
  void wakeForStream(ServedClient& client) const;
  void close(ServedClient& client, const std::string& reason);
  void complain(ServedClient& client, const std::string& problem);
  std::vector<Parameter> valuesFor(ServedClient& client, const std::vector<std::string>& names) const;
  Value countersOf(const ServedClient& client) const;
  void unsubscribe(const ClientPtr& client, std::uint32_t subscription, Calls& calls);
  void reportSubscribers(const ChannelPtr& channel, Calls& calls) const;
  void reportClients(Calls& calls) const;
  void unadvertise(const ClientPtr& client, std::uint32_t channel, Calls& calls);
  std::string subscribe(const ClientPtr& client, const Subscription& wanted, Calls& calls);
  std::string advertise(const ClientPtr& client, const ClientChannel& channel, Calls& calls);
  std::string setBudget(ServedClient& client, const Parameter& parameter);
  std::string setRates(ServedClient& client, const Parameter& parameter);
  void applyRate(ServedClient& client, const ServerChannel& channel);
  /// A reply that `send` turns into messages, with the mutex locked, if the client is still there.
  Reply replyTo(const ClientPtr& client, std::function<void(ServedClient&, Result<Reply::Answer>)> send);

  void call(const ClientPtr& client, const ServiceCallRequest& message,
            std::shared_ptr<const std::string> payload, Calls& calls);
  /// Adds a part of a call; returns what is wrong with it.
  std::string addPart(ServedClient& client, const ServiceCallRequest& message, const CallPart& part);

  // Handle the messages of clients.
  void handle(const ClientPtr& client, const Subscribe& message, Calls& calls);
  void handle(const ClientPtr& client, const Unsubscribe& message, Calls& calls);
  void handle(const ClientPtr& client, const ClientAdvertise& message, Calls& calls);
  void handle(const ClientPtr& client, const ClientUnadvertise& message, Calls& calls);
  void handle(const ClientPtr& client, const GetParameters& message, Calls& calls);
  void handle(const ClientPtr& client, const SetParameters& message, Calls& calls);
  void handle(const ClientPtr& client, const SubscribeParameterUpdates& message, Calls& calls);
  void handle(const ClientPtr& client, const UnsubscribeParameterUpdates& message, Calls& calls);
  void handle(const ClientPtr& client, const SubscribeConnectionGraph& message, Calls& calls);
  void handle(const ClientPtr& client, const UnsubscribeConnectionGraph& message, Calls& calls);
  void handle(const ClientPtr& client, const FetchAsset& message, Calls& calls);
  void handle(const ClientPtr& client, const ClientMessageData& message, Calls& calls);
  void handle(const ClientPtr& client, const ServiceCallRequest& message, Calls& calls);
  void handle(const ClientPtr& client, const PlaybackControl& message, Calls& calls);

  const ServerOptions options_;
  const ServerHandlers handlers_;

  /// Protects everything below, and what it protects of channels and clients. Handlers are called without it.
  mutable std::mutex mutex_;
  std::vector<ClientPtr> clients_;
  int batches_ = 0;
  std::map<std::uint64_t, ChannelPtr> channels_;
  std::map<std::uint32_t, OfferedService> services_;
  /// The offer, kept for the next client; unset: it has changed since. With its schemas it is large.
  std::optional<std::vector<SharedFrame>> offer_;
  std::map<std::string, Value> parameters_;
  ConnectionGraph graph_;
  std::optional<PlaybackState> playback_;
  std::optional<TimeRange> playable_;
  std::uint64_t nextClientId_ = 1, nextChannelId_ = 1;
  std::uint32_t nextServiceId_ = 1;
};

}  // namespace robotlink::websocket
