// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Server.h"

#include <algorithm>
#include <random>

#include "robotlink/base/bytes/LittleEndian.h"
#include "robotlink/foxglove/server/ServedClient.h"

namespace robotlink::websocket {
namespace {

/// The stream of publishTime(); channels begin with 1.
constexpr Outbox::StreamId kTimeStream = 0;

ServerOptions completed(ServerOptions options) {
  options.metadata.emplace(kCallPartsKey, "1");
  if (!options.clock) options.clock = std::make_shared<const SteadyClock>();
  if (!options.sessionId.empty()) return options;
  std::random_device random;
  for (int i = 0; i < 4; ++i) options.sessionId += std::to_string(random()) + (i < 3 ? "-" : "");
  return options;
}

Channel channelOf(const ServerChannel& channel) {
  const ChannelSetup& setup = channel.setup();
  return {channel.id(), setup.topic, setup.encoding, setup.schemaName, setup.schema, setup.schemaEncoding};
}

}  // namespace

void ServerChannel::publish(Instant time, SharedBytes payload) {
  if (!isWanted() || !payload) return;
  if (const auto server = server_.lock()) server->publish(*this, time, std::move(payload));
}

void ServerChannel::noteThinned() {
  if (const auto server = server_.lock()) server->noteThinned(*this);
}

std::string shownName(const ClientInfo& client) {
  return client.name.empty() ? client.address : client.name + " at " + client.address;
}

std::shared_ptr<Server> Server::make(ServerOptions options, ServerHandlers handlers) {
  return std::shared_ptr<Server>(new Server(std::move(options), std::move(handlers)));
}

Server::Server(ServerOptions options, ServerHandlers handlers)
    : options_(completed(std::move(options))), handlers_(std::move(handlers)), playable_(options_.playable) {}

std::vector<std::string> Server::capabilities(const ServedClient& client) const {
  std::vector<std::string> names{"parameters", "parametersSubscribe", "services", "connectionGraph"};
  if (options_.publishesTime) names.emplace_back("time");
  if (handlers_.clientMessage && !client.info.isReadOnly) names.emplace_back("clientPublish");
  if (handlers_.playbackControl && playable_) names.emplace_back("playbackControl");
  return names;
}

// Channels and published messages.

std::vector<ChannelPtr> Server::addChannels(std::vector<ChannelSetup> setups) {
  std::vector<ChannelPtr> added;
  Advertise message;
  const std::lock_guard lock(mutex_);
  for (ChannelSetup& setup : setups) {
    const std::size_t latching = setup.latched ? 1 : 0;
    added.push_back(std::make_shared<ServerChannel>(weak_from_this(), nextChannelId_++, std::move(setup)));
    added.back()->wanted_ = latching;
    channels_.emplace(added.back()->id(), added.back());
    message.channels.push_back(channelOf(*added.back()));
  }
  offer_.reset();
  if (!added.empty()) sendAll(message);
  return added;
}

void Server::removeChannels(std::span<const ChannelPtr> channels) {
  Unadvertise message;
  const std::lock_guard lock(mutex_);
  offer_.reset();
  for (const ChannelPtr& channel : channels) {
    if (channels_.erase(channel->id()) == 0) continue;
    message.channelIds.push_back(channel->id());
    channel->wanted_ = 0;
    for (const auto& subscriber : std::exchange(channel->subscribers_, {}))
      subscriber.client->subscriptions.erase(subscriber.subscription);
    for (const ClientPtr& client : clients_) client->outbox.remove(channel->id());
    channel->latched_.reset();
  }
  if (!message.channelIds.empty()) sendAll(message);
}

void Server::publish(ServerChannel& channel, Instant time, SharedBytes payload) {
  const std::lock_guard lock(mutex_);
  for (const auto& subscriber : channel.subscribers_) push(channel, subscriber, time, payload);
  if (!channel.setup().latched) return;
  channel.latchedTime_ = time;
  channel.latched_ = std::move(payload);
}

void Server::noteThinned(const ServerChannel& channel) {
  const std::lock_guard lock(mutex_);
  for (const auto& subscriber : channel.subscribers_) subscriber.client->outbox.noteThinned(channel.id());
}

void Server::setBackLatched(Instant time) {
  const std::lock_guard lock(mutex_);
  for (const auto& [id, channel] : channels_) channel->latchedTime_ = std::min(channel->latchedTime_, time);
}

void Server::push(const ServerChannel& channel, const ServerChannel::Subscriber& to, Instant time,
                  const SharedBytes& payload) {
  if (!to.client->closing.empty()) return;
  Outgoing message{FrameKind::kBinary, {}, kMessageHeadSize, payload, channel.setup().isCompressible};
  message.head[0] = 1;  // the opcode of MessageData
  storeNumber(message.head.data() + 1, to.subscription);
  storeNumber(message.head.data() + 5, wireTime(time));
  to.client->outbox.push(channel.id(), std::move(message), channel.setup().delivery,
                         channel.setup().maxWaiting);
  wakeForStream(*to.client);
}

void Server::publishTime(Instant time) {
  const auto bytes = std::make_shared<const std::string>(encode(Time{time}).bytes);
  const std::lock_guard lock(mutex_);
  for (const ClientPtr& client : clients_) {
    if (!client->closing.empty()) continue;
    client->outbox.push(kTimeStream, {FrameKind::kBinary, {}, 0, bytes}, Delivery::kLatest, 1);
    wakeForStream(*client);
  }
}

// Other offers and messages of the robot.

std::uint32_t Server::addService(Service service, ServiceHandler handler, ServiceAccess access) {
  const std::lock_guard lock(mutex_);
  offer_.reset();
  service.id = nextServiceId_++;
  sendAll(AdvertiseServices{{service}});
  const std::uint32_t id = service.id;
  services_[id] = {std::move(service), std::make_shared<const ServiceHandler>(std::move(handler)), access};
  return id;
}

void Server::removeService(std::uint32_t id) {
  const std::lock_guard lock(mutex_);
  offer_.reset();
  if (services_.erase(id) > 0) sendAll(UnadvertiseServices{{id}});
}

void Server::updateParameters(const std::vector<Parameter>& parameters) {
  std::vector<Parameter> changed;
  const std::lock_guard lock(mutex_);
  for (const Parameter& parameter : parameters) {
    const auto known = parameters_.find(parameter.name);
    if (parameter.value) {
      if (known != parameters_.end() && known->second == *parameter.value) continue;
      parameters_.insert_or_assign(parameter.name, *parameter.value);
    } else {
      if (known == parameters_.end()) continue;
      parameters_.erase(known);
    }
    changed.push_back(parameter);
  }
  for (const ClientPtr& client : clients_) {
    ParameterValues message{changed, ""};
    if (!client->wantsAllParameters)
      std::erase_if(message.parameters,
                    [&](const Parameter& p) { return !client->parameterNames.contains(p.name); });
    if (!message.parameters.empty()) send(*client, message);
  }
}

void Server::setConnectionGraph(ConnectionGraph graph) {
  const std::lock_guard lock(mutex_);
  const ConnectionGraphUpdate update = difference(graph_, graph);
  graph_ = std::move(graph);
  if (update == ConnectionGraphUpdate()) return;
  for (const ClientPtr& client : clients_)
    if (client->wantsGraph) send(*client, update);
}

void Server::publishPlaybackState(const PlaybackState& state) {
  const std::lock_guard lock(mutex_);
  playback_ = state;
  playback_->requestId.clear();
  sendAll(state);
}

void Server::setPlayable(const std::optional<TimeRange>& range) {
  const std::lock_guard lock(mutex_);
  if (playable_ == range) return;
  playable_ = range;
  if (!range) playback_.reset();
  for (const ClientPtr& client : clients_) send(*client, info(*client));
}

void Server::publishStatus(const Status& status) {
  const std::lock_guard lock(mutex_);
  sendAll(status);
}

// Clients.

std::vector<ClientState> Server::clients() const {
  std::vector<ClientState> states;
  const std::lock_guard lock(mutex_);
  for (const ClientPtr& client : clients_) {
    ClientState state{client->info,
                      client->outbox.sentBytes(),
                      client->outbox.waitingBytes(),
                      client->outbox.budget().rate(),
                      client->rates,
                      {}};
    for (const auto& [id, channel] : channels_) {
      const StreamCounters counters = client->outbox.counters(id);
      if (counters != StreamCounters()) state.streams[channel->setup().topic] = counters;
    }
    states.push_back(std::move(state));
  }
  return states;
}

std::size_t Server::clientCount() const {
  const std::lock_guard lock(mutex_);
  return clients_.size();
}

std::optional<Instant> Server::heardAt(std::uint64_t clientId) const {
  const std::lock_guard lock(mutex_);
  for (const ClientPtr& client : clients_)
    if (client->info.id == clientId && client->closing.empty()) return Instant(Duration(client->heardAt));
  return std::nullopt;
}

void Server::watch(const std::set<std::uint64_t>& clientIds, Duration pingEvery) {
  const std::lock_guard lock(mutex_);
  for (const ClientPtr& client : clients_)
    client->pingEvery = clientIds.contains(client->info.id) ? pingEvery.count() : 0;
}

void Server::sendStatus(std::uint64_t clientId, const Status& status) {
  const std::lock_guard lock(mutex_);
  for (const ClientPtr& client : clients_)
    if (client->info.id == clientId) send(*client, status);
}

void Server::disconnect(std::uint64_t clientId, const std::string& reason) {
  const std::lock_guard lock(mutex_);
  for (const ClientPtr& client : clients_)
    if (client->info.id == clientId) close(*client, reason);
}

Result<ClientPtr> Server::connect(ClientInfo info, std::function<void()> wake) {
  Calls calls;
  ClientPtr client;
  {
    const std::lock_guard lock(mutex_);
    if (clients_.size() >= options_.limits.clients)
      return failure("foxglove.full", "there are " + std::to_string(clients_.size()) +
                                          " clients already, as many as this robot allows: disconnect one");
    info.id = nextClientId_++;
    client.reset(new ServedClient{std::move(info), Outbox(options_.limits.outbox), std::move(wake)});
    client->outbox.budget().setRate(options_.budget);
    client->heardAt = clock().now().time_since_epoch().count();
    clients_.push_back(client);
    greet(*client);
    reportClients(calls);
  }
  for (const auto& call : calls) call();
  return client;
}

ServerInfo Server::info(const ServedClient& client) const {
  ServerInfo info{
      options_.name, capabilities(client), options_.encodings, options_.metadata, options_.sessionId, {}, {}};
  if (playable_) {
    info.dataStart = playable_->start;
    info.dataEnd = playable_->end;
  }
  return info;
}

std::vector<Server::SharedFrame> Server::offer() const {
  std::vector<SharedFrame> offer;
  // Services first: STOP is one of them, and the channels with their schemas take a slow link long.
  AdvertiseServices services;
  for (const auto& [id, offered] : services_) services.services.push_back(offered.service);
  if (!services.services.empty()) offer.push_back(sharedFrame(services));
  Advertise channels;
  for (const auto& [id, channel] : channels_) channels.channels.push_back(channelOf(*channel));
  if (!channels.channels.empty()) offer.push_back(sharedFrame(channels));
  return offer;
}

void Server::greet(ServedClient& client) {
  send(client, info(client));
  if (!offer_) offer_ = offer();
  for (const auto& [kind, bytes] : *offer_) sendShared(client, kind, bytes);
  if (playback_) send(client, *playback_);
}

/// Channels and clients that are subscribed hold each other, and both may live longer.
Server::~Server() {
  for (const ClientPtr& client : clients_) client->subscriptions.clear();
  for (const auto& [id, channel] : channels_) {
    channel->subscribers_.clear();
    channel->wanted_ = 0;
  }
}

void Server::disconnected(const ClientPtr& client) {
  Calls calls;
  {
    const std::lock_guard lock(mutex_);
    if (std::erase(clients_, client) == 0) return;
    client->wake = nullptr;
    while (!client->subscriptions.empty()) unsubscribe(client, client->subscriptions.begin()->first, calls);
    while (!client->channels.empty()) unadvertise(client, client->channels.begin()->first, calls);
    client->outbox.clear();
    reportClients(calls);
  }
  for (const auto& call : calls) call();
}

std::optional<Outgoing> Server::next(ServedClient& client, Instant now) {
  const std::lock_guard lock(mutex_);
  auto message = client.outbox.next(now);
  client.isIdle = !message && client.outbox.isEmpty();
  return message;
}

std::string Server::closingReason(const ServedClient& client) const {
  const std::lock_guard lock(mutex_);
  return client.closing;
}

void Server::report(const std::string& sentence) const {
  if (handlers_.report) handlers_.report(sentence);
}

void Server::reportClients(Calls& calls) const {
  if (!handlers_.clientsChanged) return;
  std::vector<ClientInfo> infos;
  for (const ClientPtr& client : clients_) infos.push_back(client->info);
  calls.push_back([this, infos = std::move(infos)] { handlers_.clientsChanged(infos); });
}

// Sending.

Server::SharedFrame Server::sharedFrame(const ServerMessage& message) {
  Frame frame = encode(message);
  return {frame.kind, std::make_shared<const std::string>(std::move(frame.bytes))};
}

void Server::send(ServedClient& client, const ServerMessage& message) {
  const auto [kind, bytes] = sharedFrame(message);
  sendShared(client, kind, bytes);
}

void Server::sendAll(const ServerMessage& message) {
  if (clients_.empty()) return;
  const auto [kind, bytes] = sharedFrame(message);
  for (const ClientPtr& client : clients_) sendShared(*client, kind, bytes);
}

void Server::sendShared(ServedClient& client, FrameKind kind, const SharedBytes& bytes) {
  if (!client.closing.empty()) return;
  if (!client.outbox.pushControl(kind, bytes))
    return close(client, "you receive your subscriptions too slowly: connect again, and subscribe to less");
  wake(client);
}

void Server::wake(ServedClient& client) {
  if (client.isIdle && client.wake) client.wake();
  client.isIdle = false;
}

void Server::wakeForStream(ServedClient& client) const {
  if (batches_ > 0)
    client.isHeld = true;
  else
    wake(client);
}

Server::Batch::Batch(Server& server) : server_(server) {
  const std::lock_guard lock(server_.mutex_);
  ++server_.batches_;
}

Server::Batch::~Batch() {
  const std::lock_guard lock(server_.mutex_);
  if (--server_.batches_ > 0) return;
  for (const ClientPtr& client : server_.clients_) {
    if (std::exchange(client->isHeld, false)) wake(*client);
  }
}

void Server::close(ServedClient& client, const std::string& reason) {
  if (!client.closing.empty()) return;
  client.outbox.clear();
  send(client, Status{StatusLevel::kError, reason, ""});
  client.closing = reason;
}

void Server::complain(ServedClient& client, const std::string& problem) {
  send(client, Status{StatusLevel::kError, problem, ""});
}

}  // namespace robotlink::websocket
