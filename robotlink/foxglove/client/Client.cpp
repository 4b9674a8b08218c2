// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Client.h"

#include <algorithm>
#include <utility>

#include "robotlink/foxglove/protocol/CallPart.h"

namespace robotlink::websocket {
namespace {

/// A longer argument of a call is sent in parts of this size: urgent messages wait for one of them.
constexpr std::size_t kPartBytes = 2048;

}  // namespace

Client::Client(ClientHandlers handlers, ClientLimits limits, std::shared_ptr<const Clock> clock)
    : handlers_(std::move(handlers)), limits_(limits), clock_(std::move(clock)) {
  state_.since = countedAt_ = clock_->now();
}

Client::~Client() = default;

// Requests that hold until they are changed.

void Client::subscribe(const std::set<std::string>& topics) {
  const std::lock_guard lock(mutex_);
  std::vector<OfferedChannel> wanted;
  std::set<std::string> added;
  std::ranges::set_difference(topics, wishes_.topics, std::inserter(added, added.end()));
  wishes_.topics.insert(added.begin(), added.end());
  if (added.empty()) return;
  for (const auto& [id, channel] : conversation_.channels)
    if (added.contains(channel->topic)) wanted.push_back(channel);
  subscribeAdvertised(wanted);
}

void Client::subscribeAdvertised(const std::vector<OfferedChannel>& channels) {
  Subscribe message;
  for (const OfferedChannel& channel : channels) {
    const std::uint32_t id = conversation_.nextSubscription++;
    conversation_.subscriptionOf[channel->id] = id;
    conversation_.subscriptions[id] = channel;
    message.subscriptions.push_back({id, channel->id});
  }
  if (!message.subscriptions.empty()) send(message);
}

void Client::unsubscribe(const std::set<std::string>& topics) {
  const std::lock_guard lock(mutex_);
  std::vector<std::uint64_t> unwanted;
  for (const std::string& topic : topics) wishes_.topics.erase(topic);
  for (const auto& [id, channel] : conversation_.channels)
    if (topics.contains(channel->topic)) unwanted.push_back(id);
  unsubscribeIds(unwanted);
}

void Client::unsubscribeIds(const std::vector<std::uint64_t>& channels) {
  Unsubscribe message;
  for (const std::uint64_t channel : channels) {
    const auto node = conversation_.subscriptionOf.extract(channel);
    if (node.empty()) continue;
    conversation_.subscriptions.erase(node.mapped());
    message.subscriptionIds.push_back(node.mapped());
  }
  if (!message.subscriptionIds.empty()) send(message);
}

void Client::subscribeParameters(bool wanted) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(wishes_.parameters, wanted) == wanted || !can("parametersSubscribe")) return;
  if (!wanted) return send(UnsubscribeParameterUpdates());
  send(SubscribeParameterUpdates());
  send(GetParameters());
}

void Client::subscribeGraph(bool wanted) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(wishes_.graph, wanted) == wanted || !can("connectionGraph")) return;
  if (wanted)
    send(SubscribeConnectionGraph());
  else
    send(UnsubscribeConnectionGraph());
}

void Client::setBudget(double bytesPerSecond) {
  const std::lock_guard lock(mutex_);
  wishes_.budget = bytesPerSecond;
  if (can("parameters")) send(SetParameters{{{"link/budget", Value{bytesPerSecond}}}, ""});
}

void Client::setRates(std::map<std::string, double> messagesPerSecond) {
  const std::lock_guard lock(mutex_);
  if (std::exchange(wishes_.rates, messagesPerSecond) == messagesPerSecond || !can("parameters")) return;
  send(SetParameters{{{"link/rates", valueOf(wishes_.rates)}}, ""});
}

void Client::advertise(ClientChannel channel) {
  const std::lock_guard lock(mutex_);
  const auto old = wishes_.channels.find(channel.topic);
  if (old != wishes_.channels.end() && can("clientPublish")) send(ClientUnadvertise{{old->second.id}});
  channel.id = wishes_.nextChannel++;
  if (can("clientPublish")) send(ClientAdvertise{{channel}});
  std::string topic = channel.topic;
  wishes_.channels.insert_or_assign(std::move(topic), std::move(channel));
}

void Client::unadvertise(const std::string& topic) {
  const std::lock_guard lock(mutex_);
  const auto node = wishes_.channels.extract(topic);
  if (!node.empty() && can("clientPublish")) send(ClientUnadvertise{{node.mapped().id}});
}

bool Client::publish(const std::string& topic, std::string payload) {
  const std::lock_guard lock(mutex_);
  const auto channel = wishes_.channels.find(topic);
  if (channel == wishes_.channels.end() || !can("clientPublish")) return false;
  if (payload.size() + conversation_.waitingBytes > limits_.waitingBytes) return false;
  Frame& frame = conversation_.published[topic];
  if (frame.bytes.empty()) conversation_.publishedOrder.push_back(topic);
  conversation_.waitingBytes -= frame.bytes.size();
  frame = encode(ClientMessageData{channel->second.id, payload});
  conversation_.waitingBytes += frame.bytes.size();
  wake();
  return true;
}

// Requests that are made once.

void Client::call(Call call, AnswerHandler handler) {
  std::string problem;
  {
    const std::lock_guard lock(mutex_);
    std::size_t bytes = call.payload.size();
    for (const auto& [id, pending] : calls_) bytes += pending.call.payload.size();
    if (calls_.size() >= limits_.calls || bytes > limits_.waitingBytes)
      problem = "too many requests to this robot have no answer yet: wait for them";
    if (problem.empty()) {
      const std::uint32_t id = nextCall_++;
      const Instant deadline = clock_->now() + call.connectionTime;
      PendingCall& pending = calls_[id] = {std::move(call), std::move(handler), deadline};
      const auto service = conversation_.services.find(pending.call.service);
      if (conversation_.isGreeted && service != conversation_.services.end())
        sendCall(id, pending, service->second);
    }
  }
  if (!problem.empty() && handler) handler(failure("foxglove.call", problem));
}

void Client::sendCall(std::uint32_t id, PendingCall& pending, const Service& service) {
  pending.isSent = true;
  pending.deadline = clock_->now() + pending.call.answerTime;
  const Call& call = pending.call;
  const bool takesParts = conversation_.server.metadata.contains(kCallPartsKey);
  if (!takesParts || call.payload.size() <= 2 * kPartBytes)
    return send(ServiceCallRequest{service.id, id, call.encoding, call.payload}, call.urgency);
  conversation_.longCalls.push_back({service.id, id, 0});
  wake();
}

void Client::sendWaitingCalls() {
  for (const Urgency urgency : {Urgency::kUrgent, Urgency::kNormal}) {
    for (auto& [id, pending] : calls_) {
      const auto service = conversation_.services.find(pending.call.service);
      if (!pending.isSent && pending.call.urgency == urgency && service != conversation_.services.end())
        sendCall(id, pending, service->second);
    }
  }
}

void Client::setParameters(std::vector<Parameter> parameters) {
  const std::lock_guard lock(mutex_);
  if (can("parameters")) send(SetParameters{std::move(parameters), "set"});
}

void Client::getParameters(std::vector<std::string> names) {
  const std::lock_guard lock(mutex_);
  if (can("parameters")) send(GetParameters{std::move(names), "get"});
}

ConnectionState Client::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::map<std::string, Client::Counters> Client::counters() const {
  const std::lock_guard lock(mutex_);
  return conversation_.counters;
}

std::vector<Channel> Client::channels() const {
  const std::lock_guard lock(mutex_);
  std::vector<Channel> all;
  for (const auto& [id, channel] : conversation_.channels) all.push_back(*channel);
  return all;
}

std::vector<Service> Client::services() const {
  const std::lock_guard lock(mutex_);
  std::vector<Service> all;
  for (const auto& [name, service] : conversation_.services) all.push_back(service);
  return all;
}

// Sending.

bool Client::can(const char* capability) const {
  return conversation_.isGreeted && std::ranges::find(conversation_.server.capabilities, capability) !=
                                        conversation_.server.capabilities.end();
}

void Client::send(const ClientMessage& message, Urgency urgency) {
  if (!conversation_.isOpen) return;
  Frame frame = encode(message);
  conversation_.waitingBytes += frame.bytes.size();
  if (conversation_.waitingBytes > limits_.waitingBytes)
    conversation_.overflow = "the robot receives data too slowly; send less, or connect again";
  auto& queue = urgency == Urgency::kUrgent ? conversation_.urgent : conversation_.waiting;
  queue.push_back(std::move(frame));
  wake();
}

void Client::end(const std::string& reason) {
  const std::lock_guard lock(mutex_);
  conversation_.overflow = reason;
}

void Client::wake() {
  if (isIdle_ && wake_) wake_();
  isIdle_ = false;
}

bool Client::hasWork() const {
  return !conversation_.urgent.empty() || !conversation_.waiting.empty() ||
         !conversation_.publishedOrder.empty() || !conversation_.longCalls.empty();
}

std::optional<Frame> Client::next() {
  const std::lock_guard lock(mutex_);
  isIdle_ = !hasWork();
  if (isIdle_) return std::nullopt;
  Conversation& now = conversation_;
  Frame frame;
  if (auto& queue = now.urgent.empty() ? now.waiting : now.urgent; !queue.empty()) {
    frame = std::move(queue.front());
    queue.pop_front();
  } else if (!now.publishedOrder.empty()) {
    frame = std::move(now.published.extract(now.publishedOrder.front()).mapped());
    now.publishedOrder.pop_front();
  } else {
    return nextPart();
  }
  now.waitingBytes -= frame.bytes.size();
  return frame;
}

/// Long calls take turns in the order in which they came.
Frame Client::nextPart() {
  LongCall& part = conversation_.longCalls.front();
  const Call& call = calls_.at(part.id).call;
  const CallPart what{part.offset, call.payload.size(), call.encoding};
  const std::string_view payload = std::string_view(call.payload).substr(part.offset, kPartBytes);
  Frame frame = encode(ServiceCallRequest{part.service, part.id, toEncoding(what), payload});
  part.offset += payload.size();
  // The time for the answer begins when all was sent.
  calls_.at(part.id).deadline = clock_->now() + call.answerTime;
  if (part.offset >= call.payload.size()) conversation_.longCalls.pop_front();
  return frame;
}

// The link.

void Client::setWake(std::function<void()> wake) {
  const std::lock_guard lock(mutex_);
  wake_ = std::move(wake);
  isIdle_ = true;
}

void Client::opened() {
  const std::lock_guard lock(mutex_);
  conversation_ = {};
  conversation_.isOpen = true;
}

void Client::lost() {
  Calls calls;
  {
    const std::lock_guard lock(mutex_);
    const bool wasGreeted = conversation_.isGreeted;
    conversation_ = {};
    state_.roundTrip.reset();
    state_.bytesPerSecond = 0;
    failAll(
        calls, [](const PendingCall& pending) { return pending.isSent; },
        "the connection was lost before the robot answered; the request may or may not have been executed");
    if (wasGreeted && handlers_.disconnected) calls.emplace_back(handlers_.disconnected);
  }
  for (const auto& call : calls) call();
}

void Client::failAll(Calls& calls, const std::function<bool(const PendingCall&)>& which,
                     const std::string& why) {
  for (auto it = calls_.begin(); it != calls_.end();) {
    if (!which(it->second)) {
      ++it;
      continue;
    }
    const std::string reason = why.empty() ? reasonFor(it->second) : why;
    const bool isAnswer = !it->second.isSent && conversation_.isGreeted;
    std::erase_if(conversation_.longCalls, [&](const LongCall& part) { return part.id == it->first; });
    calls.push_back([handler = std::move(it->second.handler), reason, isAnswer] {
      if (handler) handler(failure(isAnswer ? kServiceFailure : "foxglove.call", reason));
    });
    it = calls_.erase(it);
  }
}

/// The reason why a call was not answered in time.
std::string Client::reasonFor(const PendingCall& pending) const {
  if (pending.isSent)
    return "the robot did not answer within " +
           std::to_string(std::chrono::duration_cast<std::chrono::seconds>(pending.call.answerTime).count()) +
           " s; the request may or may not have been executed";
  if (conversation_.isGreeted) return "the robot offers no '" + pending.call.service + "'";
  return "there is no connection with the robot" + (state_.reason.empty() ? "" : ": " + state_.reason);
}

void Client::tick() {
  Calls calls;
  {
    const std::lock_guard lock(mutex_);
    const Instant now = clock_->now();
    failAll(calls, [&](const PendingCall& pending) { return now >= pending.deadline; }, {});
    if (now - countedAt_ >= std::chrono::seconds(1)) {
      state_.bytesPerSecond = static_cast<double>(state_.bytes - countedBytes_) / seconds(now - countedAt_);
      countedBytes_ = state_.bytes;
      countedAt_ = now;
    }
    constexpr Duration kCountersInterval = std::chrono::seconds(2);
    if (can("parameters") && conversation_.countsForUs &&
        now - conversation_.countersAt >= kCountersInterval) {
      conversation_.countersAt = now;
      send(GetParameters{{"link/counters"}, "counters"});
    }
  }
  for (const auto& call : calls) call();
}

void Client::setLink(ConnectionState::Phase phase, Instant since, std::string reason,
                     ServerObjection objection) {
  const std::lock_guard lock(mutex_);
  state_.phase = phase;
  state_.since = since;
  state_.reason = std::move(reason);
  state_.objection = std::move(objection);
}

void Client::setRoundTrip(Duration roundTrip) {
  const std::lock_guard lock(mutex_);
  state_.roundTrip = roundTrip;
}

bool Client::isGreeted() const {
  const std::lock_guard lock(mutex_);
  return conversation_.isGreeted;
}

void Client::countBytes(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  state_.bytes += bytes;
}

}  // namespace robotlink::websocket
