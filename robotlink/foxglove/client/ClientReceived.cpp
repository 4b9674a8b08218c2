// SPDX-License-Identifier: GPL-3.0-or-later
// Handles the messages of servers.
#include <algorithm>

#include "robotlink/foxglove/client/Client.h"

namespace robotlink::websocket {
namespace {

/// Ids of requests, so that answers are known; others' updates have none.
constexpr char kCountersId[] = "counters";

/// Bytes of the schemas of the argument and the answer.
std::size_t schemaBytesOf(const Service& service) {
  return service.request.schema.size() + service.response.schema.size();
}

tl::unexpected<Error> tooMuch(const std::string& what) {
  return failure("foxglove.limit", "the robot offers too much: " + what);
}

std::uint64_t countOf(const Value::Object& object, const char* name) {
  const auto found = object.find(name);
  const auto* count = found == object.end() ? nullptr : std::get_if<std::int64_t>(&found->second.data);
  return count != nullptr && *count > 0 ? static_cast<std::uint64_t>(*count) : 0;
}

}  // namespace

Result<void> Client::received(FrameKind kind, std::string_view bytes) {
  const auto message = decodeServerMessage(kind, bytes);
  Calls calls;
  Result<void> result;
  OfferedChannel channel;
  {
    const std::lock_guard lock(mutex_);
    ++state_.messages;
    const auto* data = message ? std::get_if<MessageData>(&*message) : nullptr;
    if (data != nullptr) {
      // A message of a channel that was unsubscribed may still be on its way.
      const auto found = conversation_.subscriptions.find(data->subscriptionId);
      if (found != conversation_.subscriptions.end()) channel = found->second;
    } else if (message) {
      result = std::visit([&](const auto& one) { return handle(one, calls); }, *message);
    } else if (handlers_.status) {
      // Later versions of the protocol may have messages that are not known here.
      calls.push_back([this, text = message.error().text] {
        handlers_.status({StatusLevel::kWarning, "A message of the robot was not understood: " + text, ""});
      });
    }
    if (result && !conversation_.overflow.empty()) result = failure("foxglove.limit", conversation_.overflow);
  }
  if (channel && handlers_.message) {
    const auto& data = std::get<MessageData>(*message);
    handlers_.message(*channel, data.time, data.payload);
  }
  for (const auto& call : calls) call();
  return result;
}

Result<void> Client::handle(const ServerInfo& message, Calls& calls) {
  conversation_.server = message;
  state_.serverName = message.name;
  if (conversation_.isGreeted) return {};
  conversation_.isGreeted = true;
  state_.takesMessages = can("clientPublish");
  conversation_.countersAt = clock_->now();
  ++state_.connections;
  state_.phase = ConnectionState::Phase::kConnected;
  state_.since = clock_->now();
  state_.reason.clear();
  if (handlers_.connected) calls.push_back([this, message] { handlers_.connected(message); });
  greet();
  return {};
}

/// Sends all requests that hold.
void Client::greet() {
  if (wishes_.budget && can("parameters")) send(SetParameters{{{"link/budget", Value{*wishes_.budget}}}, ""});
  if (!wishes_.rates.empty() && can("parameters"))
    send(SetParameters{{{"link/rates", valueOf(wishes_.rates)}}, ""});
  ClientAdvertise channels;
  for (const auto& [topic, channel] : wishes_.channels) channels.channels.push_back(channel);
  if (!channels.channels.empty() && can("clientPublish")) send(channels);
  if (wishes_.parameters && can("parametersSubscribe")) {
    send(SubscribeParameterUpdates());
    send(GetParameters());
  }
  if (wishes_.graph && can("connectionGraph")) send(SubscribeConnectionGraph());
}

Result<void> Client::handle(const Status& message, Calls& calls) {
  if (handlers_.status) calls.push_back([this, message] { handlers_.status(message); });
  return {};
}

/// Statuses are passed on as they come and never stored, so none has to be removed.
Result<void> Client::handle(const RemoveStatus&, Calls&) {
  return {};
}

// Channels.

Result<void> Client::handle(const Advertise& message, Calls& calls) {
  std::vector<Channel> added, removed;
  std::vector<OfferedChannel> wanted;
  for (const Channel& channel : message.channels) {
    const auto known = conversation_.channels.find(channel.id);
    if (known != conversation_.channels.end() && *known->second == channel) continue;
    remove(channel.id, removed);
    conversation_.schemaBytes += channel.schema.size();
    if (conversation_.channels.size() >= limits_.channels || conversation_.schemaBytes > limits_.schemaBytes)
      return tooMuch("more than " + std::to_string(limits_.channels) + " channels, or schemas of more than " +
                     std::to_string(limits_.schemaBytes >> 20U) + " MiB");
    const auto offered = std::make_shared<const Channel>(channel);
    conversation_.channels[channel.id] = offered;
    added.push_back(channel);
    if (wishes_.topics.contains(channel.topic)) wanted.push_back(offered);
  }
  subscribeAdvertised(wanted);
  if (!removed.empty() && handlers_.channelsRemoved)
    calls.push_back([this, removed] { handlers_.channelsRemoved(removed); });
  if (!added.empty() && handlers_.channelsAdded)
    calls.push_back([this, added] { handlers_.channelsAdded(added); });
  return {};
}

void Client::remove(std::uint64_t id, std::vector<Channel>& removed) {
  const auto node = conversation_.channels.extract(id);
  if (node.empty()) return;
  removed.push_back(*node.mapped());
  conversation_.schemaBytes -= node.mapped()->schema.size();
  const auto subscription = conversation_.subscriptionOf.extract(id);
  if (!subscription.empty()) conversation_.subscriptions.erase(subscription.mapped());
}

Result<void> Client::handle(const Unadvertise& message, Calls& calls) {
  std::vector<Channel> removed;
  for (const std::uint64_t id : message.channelIds) remove(id, removed);
  if (!removed.empty() && handlers_.channelsRemoved)
    calls.push_back([this, removed] { handlers_.channelsRemoved(removed); });
  return {};
}

Result<void> Client::handle(const MessageData&, Calls&) {
  return {};
}

/// Each message has its own time.
Result<void> Client::handle(const Time&, Calls&) {
  return {};
}

// Parameters, the connection graph, playback.

Result<void> Client::handle(const ParameterValues& message, Calls& calls) {
  if (message.id == kCountersId) {
    // A server that counts nothing sends nothing.
    conversation_.countsForUs = !message.parameters.empty();
    for (const Parameter& parameter : message.parameters)
      if (parameter.name == "link/counters" && parameter.value) noteCounters(*parameter.value);
    return {};
  }
  if (handlers_.parameters) calls.push_back([this, message] { handlers_.parameters(message.parameters); });
  return {};
}

void Client::noteCounters(const Value& value) {
  const auto* topics = std::get_if<Value::Object>(&value.data);
  if (topics == nullptr || topics->size() > limits_.channels) return;
  std::uint64_t thinned = 0, dropped = 0;
  conversation_.counters.clear();
  for (const auto& [topic, counted] : *topics) {
    const auto* object = std::get_if<Value::Object>(&counted.data);
    if (object == nullptr) continue;
    const Counters counters{countOf(*object, "thinned"), countOf(*object, "dropped")};
    conversation_.counters[topic] = counters;
    thinned += counters.thinned;
    dropped += counters.dropped;
  }
  state_.thinned = thinned;
  state_.dropped = dropped;
}

Result<void> Client::handle(const ConnectionGraphUpdate& message, Calls& calls) {
  if (handlers_.graph) calls.push_back([this, message] { handlers_.graph(message); });
  return {};
}

/// The robots' own streams tell the position in a log.
Result<void> Client::handle(const PlaybackState&, Calls&) {
  return {};
}

// Services.

Result<void> Client::handle(const AdvertiseServices& message, Calls& calls) {
  for (const Service& service : message.services) {
    const auto known = conversation_.services.find(service.name);
    if (known != conversation_.services.end())
      conversation_.serviceSchemaBytes -= schemaBytesOf(known->second);
    conversation_.serviceSchemaBytes += schemaBytesOf(service);
    if (conversation_.services.size() >= limits_.services ||
        conversation_.serviceSchemaBytes > limits_.schemaBytes)
      return tooMuch("more than " + std::to_string(limits_.services) + " services, or schemas of more than " +
                     std::to_string(limits_.schemaBytes >> 20U) + " MiB");
    conversation_.services.insert_or_assign(service.name, service);
  }
  if (handlers_.servicesAdded)
    calls.push_back([this, services = message.services] { handlers_.servicesAdded(services); });
  sendWaitingCalls();
  return {};
}

Result<void> Client::handle(const UnadvertiseServices& message, Calls& calls) {
  std::vector<std::string> names;
  std::erase_if(conversation_.services, [&](const auto& service) {
    if (std::ranges::find(message.serviceIds, service.second.id) == message.serviceIds.end()) return false;
    conversation_.serviceSchemaBytes -= schemaBytesOf(service.second);
    names.push_back(service.first);
    return true;
  });
  if (!names.empty() && handlers_.servicesRemoved)
    calls.push_back([this, names] { handlers_.servicesRemoved(names); });
  return {};
}

void Client::finish(std::uint32_t id, Result<Answer> answer, Calls& calls) {
  const auto found = calls_.find(id);
  if (found == calls_.end() || !found->second.isSent) return;
  std::erase_if(conversation_.longCalls, [&](const LongCall& part) { return part.id == id; });
  calls.push_back([handler = std::move(found->second.handler), answer = std::move(answer)] {
    if (handler) handler(answer);
  });
  calls_.erase(found);
}

Result<void> Client::handle(const ServiceCallFailure& message, Calls& calls) {
  finish(message.callId, failure(kServiceFailure, message.message), calls);
  return {};
}

Result<void> Client::handle(const ServiceCallResponse& message, Calls& calls) {
  finish(message.callId, Answer{message.encoding, std::string(message.payload)}, calls);
  return {};
}

/// None was asked for.
Result<void> Client::handle(const FetchAssetResponse&, Calls&) {
  return {};
}

}  // namespace robotlink::websocket
