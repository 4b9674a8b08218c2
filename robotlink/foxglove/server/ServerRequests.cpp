// SPDX-License-Identifier: GPL-3.0-or-later
// Handles the messages of clients.
#include <algorithm>
#include <cmath>

#include "robotlink/foxglove/server/ServedClient.h"
#include "robotlink/foxglove/server/Server.h"

namespace robotlink::websocket {
namespace {

constexpr char kOnlyWatches[] =
    "you may only watch this robot: connect with its token for control to change something";

/// A budget below this would not carry the messages that keep a connection alive.
constexpr double kMinBudget = 1000;
/// The minimum rate, about one message a day.
constexpr double kMinRate = 1e-5;

std::optional<double> numberOf(const Value& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) return static_cast<double>(*whole);
  if (const auto* number = std::get_if<double>(&value.data)) return *number;
  return std::nullopt;
}

/// The first of several problems, and how many there are.
void add(std::string& problems, std::size_t& count, std::string problem) {
  if (problem.empty()) return;
  if (count++ == 0) problems = std::move(problem);
}

std::string textOfProblems(const std::string& problems, std::size_t count) {
  return count < 2 ? problems : problems + " (and " + std::to_string(count - 1) + " more problems)";
}

}  // namespace

void Server::received(const ClientPtr& client, FrameKind kind, std::string_view bytes) {
  const auto message = decodeClientMessage(kind, bytes);
  Calls calls;
  {
    const std::lock_guard lock(mutex_);
    const bool isGone = std::ranges::find(clients_, client) == clients_.end();
    if (isGone || !client->closing.empty()) return;
    if (message)
      std::visit([&](const auto& one) { handle(client, one, calls); }, *message);
    else
      complain(*client, message.error().text);
  }
  for (const auto& call : calls) call();
}

// Subscriptions.

void Server::handle(const ClientPtr& client, const Subscribe& message, Calls& calls) {
  std::string problems;
  std::size_t count = 0;
  for (const Subscription& wanted : message.subscriptions)
    add(problems, count, subscribe(client, wanted, calls));
  if (count > 0) complain(*client, textOfProblems(problems, count));
}

std::string Server::subscribe(const ClientPtr& client, const Subscription& wanted, Calls& calls) {
  const auto found = channels_.find(wanted.channelId);
  if (found == channels_.end()) return "there is no channel " + std::to_string(wanted.channelId);
  const ChannelPtr& channel = found->second;
  const std::string& topic = channel->setup().topic;
  if (client->subscriptions.contains(wanted.id))
    return "the subscription of " + topic + " has the id of another one: " + std::to_string(wanted.id);
  if (std::ranges::find(channel->subscribers_, client, &ServerChannel::Subscriber::client) !=
      channel->subscribers_.end())
    return "you have subscribed to " + topic + " already";
  if (client->subscriptions.size() >= options_.limits.subscriptions)
    return topic + " is one subscription too many: " + std::to_string(options_.limits.subscriptions) +
           " are allowed";
  client->subscriptions.emplace(wanted.id, channel);
  channel->subscribers_.push_back({client, wanted.id});
  ++channel->wanted_;
  applyRate(*client, *channel);
  if (channel->latched_)
    push(*channel, channel->subscribers_.back(), channel->latchedTime_, channel->latched_);
  reportSubscribers(channel, calls);
  return {};
}

void Server::handle(const ClientPtr& client, const Unsubscribe& message, Calls& calls) {
  // Ids that are not known may be those of channels that were removed meanwhile.
  for (const std::uint32_t id : message.subscriptionIds) unsubscribe(client, id, calls);
}

void Server::unsubscribe(const ClientPtr& client, std::uint32_t subscription, Calls& calls) {
  const auto found = client->subscriptions.find(subscription);
  if (found == client->subscriptions.end()) return;
  const ChannelPtr channel = found->second;
  client->subscriptions.erase(found);
  std::erase_if(channel->subscribers_, [&](const auto& subscriber) { return subscriber.client == client; });
  --channel->wanted_;
  client->outbox.clear(channel->id());
  reportSubscribers(channel, calls);
}

void Server::reportSubscribers(const ChannelPtr& channel, Calls& calls) const {
  if (!handlers_.subscribersChanged) return;
  std::vector<ClientInfo> infos;
  for (const auto& subscriber : channel->subscribers_) infos.push_back(subscriber.client->info);
  calls.push_back(
      [this, channel, infos = std::move(infos)] { handlers_.subscribersChanged(channel, infos); });
}

// Publishing by clients.

void Server::handle(const ClientPtr& client, const ClientAdvertise& message, Calls& calls) {
  std::string problems;
  std::size_t count = 0;
  for (const ClientChannel& channel : message.channels)
    add(problems, count, advertise(client, channel, calls));
  if (count > 0) complain(*client, textOfProblems(problems, count));
}

std::string Server::advertise(const ClientPtr& client, const ClientChannel& channel, Calls& calls) {
  if (!handlers_.clientMessage) return "this robot accepts no messages from clients";
  if (client->info.isReadOnly) return kOnlyWatches;
  if (std::ranges::find(options_.encodings, channel.encoding) == options_.encodings.end())
    return channel.topic + " has the encoding " + channel.encoding + ", which this robot does not accept";
  if (client->channels.contains(channel.id))
    return "the channel of " + channel.topic + " has the id of another one: " + std::to_string(channel.id);
  if (client->channels.size() >= options_.limits.channels)
    return channel.topic + " is one channel too many: " + std::to_string(options_.limits.channels) +
           " are allowed";
  client->channels.emplace(channel.id, channel);
  if (handlers_.clientAdvertised)
    calls.push_back([this, client, channel] { handlers_.clientAdvertised(client->info, channel); });
  return {};
}

void Server::handle(const ClientPtr& client, const ClientUnadvertise& message, Calls& calls) {
  for (const std::uint32_t id : message.channelIds) unadvertise(client, id, calls);
}

void Server::unadvertise(const ClientPtr& client, std::uint32_t id, Calls& calls) {
  auto node = client->channels.extract(id);
  if (!node || !handlers_.clientUnadvertised) return;
  calls.push_back([this, client, channel = std::move(node.mapped())] {
    handlers_.clientUnadvertised(client->info, channel);
  });
}

void Server::handle(const ClientPtr& client, const ClientMessageData& message, Calls& calls) {
  const auto found = client->channels.find(message.channelId);
  if (found == client->channels.end())
    return complain(*client, "you have not advertised a channel " + std::to_string(message.channelId));
  calls.push_back([this, client, channel = found->second, payload = message.payload] {
    handlers_.clientMessage(client->info, channel, payload);
  });
}

// Parameters.

std::vector<Parameter> Server::valuesFor(ServedClient& client, const std::vector<std::string>& names) const {
  std::vector<Parameter> values;
  const Parameter budget{kBudgetParameter, Value{client.outbox.budget().rate()}};
  const Parameter rates{kRatesParameter, valueOf(client.rates)};
  const Parameter number{kClientParameter, Value{static_cast<std::int64_t>(client.info.id)}};
  if (names.empty()) {
    for (const auto& [name, value] : parameters_) values.push_back({name, value});
    values.insert(values.end(), {budget, rates, number});
    return values;
  }
  for (const std::string& name : std::set(names.begin(), names.end())) {
    if (name == kBudgetParameter) values.push_back(budget);
    if (name == kRatesParameter) values.push_back(rates);
    if (name == kClientParameter) values.push_back(number);
    if (name == kCountersParameter) values.push_back({name, countersOf(client)});
    if (const auto found = parameters_.find(name); found != parameters_.end())
      values.push_back({name, found->second});
  }
  return values;
}

Value Server::countersOf(const ServedClient& client) const {
  Value::Object topics;
  for (const auto& [id, channel] : channels_) {
    const StreamCounters counters = client.outbox.counters(id);
    if (counters == StreamCounters()) continue;
    const auto number = [](std::uint64_t count) { return Value{static_cast<std::int64_t>(count)}; };
    topics[channel->setup().topic] = Value{Value::Object{{"sent", number(counters.sent)},
                                                         {"bytes", number(counters.bytes)},
                                                         {"thinned", number(counters.thinned)},
                                                         {"dropped", number(counters.dropped)}}};
  }
  return Value{std::move(topics)};
}

void Server::handle(const ClientPtr& client, const GetParameters& message, Calls&) {
  send(*client, ParameterValues{valuesFor(*client, message.names), message.id});
}

std::string Server::setBudget(ServedClient& client, const Parameter& parameter) {
  const auto budget = parameter.value ? numberOf(*parameter.value) : 0.0;
  if (!budget || !std::isfinite(*budget) || *budget < 0)
    return std::string(kBudgetParameter) + " must be a number of bytes a second, or 0 for no limit";
  client.outbox.budget().setRate(*budget > 0 ? std::max(*budget, kMinBudget) : 0);
  return {};
}

std::string Server::setRates(ServedClient& client, const Parameter& parameter) {
  const auto* object = parameter.value ? std::get_if<Value::Object>(&parameter.value->data) : nullptr;
  if (parameter.value && object == nullptr)
    return std::string(kRatesParameter) + " must be an object: the messages a second of each topic";
  std::map<std::string, double> rates;
  for (const auto& [topic, value] : object != nullptr ? *object : Value::Object()) {
    const auto rate = numberOf(value);
    if (!rate || !std::isfinite(*rate) || *rate < 0)
      return "the rate of " + topic + " must be a number of messages a second, or 0 for all";
    if (*rate > 0) rates[topic] = std::max(*rate, kMinRate);
  }
  if (rates.size() > options_.limits.parameterNames) return "you limit the rates of too many topics";
  client.rates = std::move(rates);
  for (const auto& [id, channel] : client.subscriptions) applyRate(client, *channel);
  return {};
}

/// Applies the rate, except to streams that must be complete.
void Server::applyRate(ServedClient& client, const ServerChannel& channel) {
  if (channel.setup().delivery != Delivery::kLatest) return;
  const auto rate = client.rates.find(channel.setup().topic);
  client.outbox.setRate(channel.id(), rate == client.rates.end() ? 0 : rate->second);
}

void Server::handle(const ClientPtr& client, const SetParameters& message, Calls& calls) {
  std::vector<Parameter> others;
  std::vector<std::string> names;
  for (const Parameter& parameter : message.parameters) {
    names.push_back(parameter.name);
    const bool isBudget = parameter.name == kBudgetParameter;
    if (!isBudget && parameter.name != kRatesParameter) {
      others.push_back(parameter);
      continue;
    }
    const std::string problem = isBudget ? setBudget(*client, parameter) : setRates(*client, parameter);
    if (!problem.empty()) complain(*client, problem);
  }
  const auto answer = [this, names, id = message.id](ServedClient& to, const Result<Reply::Answer>& result) {
    if (!result) complain(to, result.error().text);
    // No names would mean all.
    if (!id.empty())
      send(to, ParameterValues{names.empty() ? std::vector<Parameter>() : valuesFor(to, names), id});
  };
  if (others.empty()) return answer(*client, Reply::Answer());
  if (client->info.isReadOnly) return answer(*client, failure("foxglove.read-only", kOnlyWatches));
  if (!handlers_.setParameters)
    return answer(*client, failure("foxglove.parameters", "the parameters of this robot cannot be set"));
  if (client->calls >= options_.limits.calls)
    return answer(*client,
                  failure("foxglove.calls", "too many of your requests have no answer yet: try again later"));
  calls.push_back([this, client, others = std::move(others), reply = replyTo(client, answer)] {
    handlers_.setParameters(client->info, others, reply);
  });
}

void Server::handle(const ClientPtr& client, const SubscribeParameterUpdates& message, Calls&) {
  client->wantsAllParameters |= message.names.empty();
  client->parameterNames.insert(message.names.begin(), message.names.end());
  if (client->parameterNames.size() <= options_.limits.parameterNames) return;
  client->parameterNames.clear();
  complain(*client, "you subscribed to too many parameters: subscribe to all of them");
}

void Server::handle(const ClientPtr& client, const UnsubscribeParameterUpdates& message, Calls&) {
  for (const std::string& name : message.names) client->parameterNames.erase(name);
  if (!message.names.empty()) return;
  client->wantsAllParameters = false;
  client->parameterNames.clear();
}

// The connection graph, playback.

void Server::handle(const ClientPtr& client, const SubscribeConnectionGraph&, Calls&) {
  client->wantsGraph = true;
  send(*client, difference({}, graph_));
}

void Server::handle(const ClientPtr& client, const UnsubscribeConnectionGraph&, Calls&) {
  client->wantsGraph = false;
}

void Server::handle(const ClientPtr& client, const PlaybackControl& message, Calls& calls) {
  if (!handlers_.playbackControl || !playable_)
    return complain(*client, "this is not a log, so it cannot be played");
  if (client->info.isReadOnly) return complain(*client, kOnlyWatches);
  calls.push_back([this, client, message] { handlers_.playbackControl(client->info, message); });
}

// Calls that are answered later.

Reply Server::replyTo(const ClientPtr& client,
                      std::function<void(ServedClient&, Result<Reply::Answer>)> sendAnswer) {
  ++client->calls;
  return Reply([server = weak_from_this(), weakClient = std::weak_ptr(client),
                sendAnswer = std::move(sendAnswer)](Result<Reply::Answer> result) {
    const auto self = server.lock();
    const auto to = weakClient.lock();
    if (!self || !to) return;
    const std::lock_guard lock(self->mutex_);
    --to->calls;
    sendAnswer(*to, std::move(result));
  });
}

void Server::handle(const ClientPtr& client, const ServiceCallRequest& message, Calls& calls) {
  const auto part = callPartOf(message.encoding);
  if (!part) return call(client, message, nullptr, calls);
  if (const std::string problem = addPart(*client, message, *part); !problem.empty()) {
    client->partialCall.reset();
    return send(*client, ServiceCallFailure{message.serviceId, message.callId, problem});
  }
  if (client->partialCall->payload.size() < part->total) return;
  const auto whole = *std::exchange(client->partialCall, std::nullopt);
  call(client, whole.call, std::make_shared<const std::string>(whole.payload), calls);
}

std::string Server::addPart(ServedClient& client, const ServiceCallRequest& message, const CallPart& part) {
  if (part.total > options_.limits.callBytes)
    return "the argument is longer than " + std::to_string(options_.limits.callBytes) + " bytes";
  auto& partial = client.partialCall;
  if (part.offset == 0) partial = {{message.serviceId, message.callId, part.encoding, {}}, part.total};
  const bool fits = partial && partial->call.serviceId == message.serviceId &&
                    partial->call.callId == message.callId && partial->call.encoding == part.encoding &&
                    partial->total == part.total && partial->payload.size() == part.offset &&
                    message.payload.size() <= part.total - part.offset && !message.payload.empty();
  if (!fits) return "the parts of a call must arrive in order, one call after another";
  partial->payload += message.payload;
  return {};
}

/// `payload` is what the message refers to, if that is not the frame that is being received.
void Server::call(const ClientPtr& client, const ServiceCallRequest& message,
                  std::shared_ptr<const std::string> payload, Calls& calls) {
  const auto fail = [this, service = message.serviceId, call = message.callId](ServedClient& to,
                                                                               std::string why) {
    send(to, ServiceCallFailure{service, call, std::move(why)});
  };
  const auto found = services_.find(message.serviceId);
  if (found == services_.end())
    return fail(*client, "there is no service " + std::to_string(message.serviceId));
  if (client->info.isReadOnly && found->second.access == ServiceAccess::kControl)
    return fail(*client, kOnlyWatches);
  if (client->calls >= options_.limits.calls)
    return fail(*client, "too many of your calls have no answer yet: " +
                             std::to_string(options_.limits.calls) + " are allowed");
  const auto answer = [this, fail, service = message.serviceId, call = message.callId,
                       encoding = message.encoding](ServedClient& to, const Result<Reply::Answer>& result) {
    if (!result) return fail(to, result.error().text);
    send(to, ServiceCallResponse{service, call, result->encoding.empty() ? encoding : result->encoding,
                                 result->data});
  };
  calls.push_back([client, message, payload = std::move(payload), handler = found->second.handler,
                   reply = replyTo(client, answer)] {
    ServiceCallRequest request = message;
    if (payload) request.payload = *payload;
    (*handler)(client->info, request, reply);
  });
}

/// No request reads a file.
void Server::handle(const ClientPtr& client, const FetchAsset& message, Calls&) {
  send(*client, FetchAssetResponse{message.requestId, "this robot offers no files", {}});
}

}  // namespace robotlink::websocket
