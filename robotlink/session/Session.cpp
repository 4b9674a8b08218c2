// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/Session.h"

#include <algorithm>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/session/LatchedMessages.h"
#include "robotlink/session/QueueMessages.h"

namespace robotlink {
namespace {

using robotcontrol::RequestResult;
using ResultPtr = std::shared_ptr<const RequestResult>;

// Messages that were pushed together and are dropped together.
struct Batch {
  std::vector<StreamMessage> messages;
  std::size_t bytes = 0;
};

std::size_t bytesOf(const std::vector<StreamMessage>& messages) {
  std::size_t bytes = 0;
  for (const StreamMessage& message : messages) bytes += message.bytes;
  return bytes;
}

constexpr std::size_t kMaxProcesses = 1000;
constexpr std::size_t kMaxPending = 10'000;

}  // namespace

struct Session::Inbox {
  explicit Inbox(InboxLimits inboxLimits) : limits(inboxLimits) {}

  // Call it with the mutex locked.
  void add(Batch batch) {
    messageCount += batch.messages.size();
    bytes += batch.bytes;
    if (!batch.messages.empty()) lastTime = batch.messages.back().time;
    batches.push_back(std::move(batch));
    while (!batches.empty() && (messageCount > limits.messages || bytes > limits.bytes)) dropOldest();
  }
  void dropOldest() {
    Batch& oldest = batches.front();
    messageCount -= oldest.messages.size();
    bytes -= oldest.bytes;
    for (const StreamMessage& message : oldest.messages) {
      if (!latched.take(message)) ++dropped;
    }
    batches.pop_front();
  }

  void forget() {
    batches.clear();
    latched.clear();
    messageCount = 0;
    bytes = 0;
    lastTime = Instant{};
  }

  // Call it with the mutex locked. Only the first result of a known request counts, so that the number of
  // waiting results is bounded by that of requests.
  void addResult(const RequestResult& result) {
    if (awaited.erase(result.id()) > 0) results.push_back(std::make_shared<RequestResult>(result));
  }

  void countDropped(const std::string& process, std::uint64_t count) {
    if (robotDropped.size() >= kMaxProcesses && !robotDropped.contains(process)) return;
    auto& [before, since] = robotDropped[process];
    // The process was restarted.
    if (count < since) before += since;
    since = count;
  }

  const InboxLimits limits;
  // Protects everything below.
  mutable std::mutex mutex;
  std::deque<Batch> batches;
  LatchedMessages latched;  // of dropped batches
  std::size_t messageCount = 0;
  std::size_t bytes = 0;
  std::uint64_t dropped = 0;
  Instant lastTime;
  // Keyed by process: before its restarts, and since the last one.
  std::map<std::string, std::pair<std::uint64_t, std::uint64_t>> robotDropped;
  // Ids of requests without a result.
  std::set<std::uint64_t> awaited;
  std::vector<ResultPtr> results;
  // restart() was called: the history is older than the inbox and must be cleared.
  bool restarted = false;
  std::uint64_t restarts = 0;
  // The inbox is not complete yet; tick() leaves it alone.
  bool held = false;
};

struct Session::Pending {
  std::uint64_t nextId = 1;
  std::map<std::uint64_t, ResultHandler> handlers;
};

Session::Session(StreamStore::Limits limits) : Session(limits, InboxLimits{}) {}

Session::Session(StreamStore::Limits limits, InboxLimits inboxLimits)
    : store_(limits), inbox_(std::make_unique<Inbox>(inboxLimits)), pending_(std::make_unique<Pending>()) {}

Session::~Session() = default;

void Session::push(StreamMessage message) {
  if (!message.value || message.path.empty()) return;
  if (message.bytes == 0) message.bytes = sizeOf(message);
  Batch batch;
  batch.bytes = message.bytes;
  batch.messages.push_back(std::move(message));
  const std::lock_guard lock(inbox_->mutex);
  inbox_->add(std::move(batch));
}

void Session::push(std::vector<StreamMessage> messages) {
  std::erase_if(messages,
                [](const StreamMessage& message) { return !message.value || message.path.empty(); });
  if (messages.empty()) return;
  for (StreamMessage& message : messages) {
    if (message.bytes == 0) message.bytes = sizeOf(message);
  }
  Batch batch;
  batch.bytes = bytesOf(messages);
  batch.messages = std::move(messages);
  const std::lock_guard lock(inbox_->mutex);
  inbox_->add(std::move(batch));
}

void Session::pushQueue(const std::string& robot, const std::shared_ptr<const SharedDebugQueue>& queue) {
  if (!queue) return;
  Instant lastTime;
  {
    const std::lock_guard lock(inbox_->mutex);
    lastTime = inbox_->lastTime;
  }
  // Not under the lock, so that other producers need not wait meanwhile.
  QueueMessages parts = messagesOf(robot, *queue, lastTime);
  Batch batch;
  batch.bytes = bytesOf(parts.messages);
  batch.messages = std::move(parts.messages);
  const std::lock_guard lock(inbox_->mutex);
  for (const ResultPtr& result : parts.results) inbox_->addResult(*result);
  inbox_->dropped += parts.senseless;
  inbox_->countDropped(robot + "/" + queue->process, queue->dropped);
  if (!batch.messages.empty()) inbox_->add(std::move(batch));
}

void Session::pushResult(const RequestResult& result) {
  const std::lock_guard lock(inbox_->mutex);
  inbox_->addResult(result);
}

void Session::tick() {
  std::deque<Batch> batches;
  LatchedMessages latched;
  std::vector<ResultPtr> results;
  bool restarted = false;
  {
    const std::lock_guard lock(inbox_->mutex);
    // Results wait, too, so that a handler sees the effect of its request.
    if (!inbox_->held) {
      results.swap(inbox_->results);
      batches.swap(inbox_->batches);
      std::swap(latched, inbox_->latched);
      restarted = std::exchange(inbox_->restarted, false);
      inbox_->messageCount = 0;
      inbox_->bytes = 0;
    }
  }
  if (restarted) {
    store_.clear();
    history_.goLive();
  }
  const auto add = [this](StreamMessage& message) {
    for (const auto& [number, listener] : listeners_) {
      if (listener.message) listener.message(message);
    }
    store_.add(std::move(message));
  };
  for (StreamMessage& message : latched.all()) add(message);
  for (Batch& batch : batches) {
    for (StreamMessage& message : batch.messages) add(message);
  }
  timeline_.setNewest(store_.newest());
  history_.tick();
  for (const ResultPtr& result : results) {
    for (const auto& [number, listener] : listeners_) {
      if (listener.result) listener.result(*result);
    }
    auto handler = pending_->handlers.extract(result->id());
    if (!handler.empty() && handler.mapped()) handler.mapped()(*result);
    for (const auto& [number, listener] : listeners_) {
      if (listener.handled) listener.handled(*result);
    }
  }
}

std::uint64_t Session::dropped() const {
  const std::lock_guard lock(inbox_->mutex);
  std::uint64_t sum = inbox_->dropped + store_.refused();
  for (const auto& [process, counts] : inbox_->robotDropped) sum += counts.first + counts.second;
  return sum;
}

std::uint64_t Session::restarts() const {
  const std::lock_guard lock(inbox_->mutex);
  return inbox_->restarts;
}

void Session::setRobots(std::vector<std::string> robots) {
  robots_ = std::move(robots);
  if (std::find(robots_.begin(), robots_.end(), selectedRobot_) != robots_.end()) return;
  selectedRobot_ = robots_.empty() ? std::string() : robots_.front();
}

void Session::selectRobot(const std::string& robot) {
  if (std::find(robots_.begin(), robots_.end(), robot) != robots_.end()) selectedRobot_ = robot;
}

void Session::setRequestSink(RequestSink sink) {
  sink_ = std::move(sink);
}

void Session::setRefusalHandler(RefusalHandler handler) {
  refused_ = std::move(handler);
}

std::uint64_t Session::addListener(Listener listener) {
  const std::uint64_t id = nextListener_++;
  listeners_.emplace(id, std::move(listener));
  return id;
}

void Session::removeListener(std::uint64_t id) {
  listeners_.erase(id);
}

void Session::await(std::uint64_t id, ResultHandler onResult) {
  pending_->handlers[id] = std::move(onResult);
  const std::lock_guard lock(inbox_->mutex);
  inbox_->awaited.insert(id);
  if (pending_->handlers.size() <= kMaxPending) return;
  inbox_->awaited.erase(pending_->handlers.begin()->first);
  pending_->handlers.erase(pending_->handlers.begin());
}

void Session::reportRefusal(const std::string& what, const std::string& reason) {
  for (const auto& [number, listener] : listeners_) {
    if (listener.refusal) listener.refusal(what, reason);
  }
  if (refused_) refused_(what, reason);
}

std::uint64_t Session::request(robotcontrol::Request request, ResultHandler onResult) {
  const std::uint64_t id = pending_->nextId++;
  request.set_id(id);
  if (!onResult) {
    onResult = [this, what = inWords(request)](const RequestResult& result) {
      if (!result.accepted()) reportRefusal(what, result.reason());
    };
  }
  await(id, std::move(onResult));
  for (const auto& [number, listener] : listeners_) {
    if (listener.request) listener.request(request);
  }
  if (sink_) {
    sink_(request);
    return id;
  }
  RequestResult refusal;
  refusal.set_id(id);
  refusal.set_reason("nothing that is open can do this; open a scene or connect to a robot first");
  pushResult(refusal);
  return id;
}

void Session::restart(const std::function<void()>& publish) {
  {
    const std::lock_guard lock(inbox_->mutex);
    inbox_->forget();
    inbox_->restarted = true;
    ++inbox_->restarts;
    inbox_->held = true;
  }
  if (publish) publish();
  const std::lock_guard lock(inbox_->mutex);
  inbox_->held = false;
}

}  // namespace robotlink
