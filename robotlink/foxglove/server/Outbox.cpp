// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Outbox.h"

#include <algorithm>

namespace robotlink::websocket {

void Outbox::setRate(StreamId id, double messagesPerSecond) {
  Stream& stream = streams_[id];
  stream.gap = messagesPerSecond > 0 ? fromSeconds(1 / messagesPerSecond) : Duration(0);
  stream.due = {};
}

bool Outbox::pushControl(FrameKind kind, SharedBytes bytes) {
  const std::size_t size = bytes->size();
  const bool fits = control_.empty() || controlBytes_ + size <= limits_.controlBytes;
  if (!fits || control_.size() >= limits_.controlMessages) return false;
  controlBytes_ += size;
  control_.push_back({kind, {}, 0, std::move(bytes)});
  return true;
}

void Outbox::push(StreamId id, Outgoing message, Delivery delivery, std::size_t maxWaiting) {
  Stream& stream = streams_[id];
  stream.delivery = delivery;
  const bool hasRate = stream.gap > Duration::zero();
  const bool isCalm = message.size() + smallBytes_ <= limits_.calmBytes && !hasRate;
  addWaiting(message.size());
  if (delivery == Delivery::kLatest && !stream.waiting.empty() && !isCalm) {
    while (stream.waiting.size() > 1) giveUpOldest(stream);
    Outgoing& waiting = stream.waiting.front()->message;
    removeWaiting(waiting.size());
    waiting = std::move(message);
    ++stream.counters.thinned;
  } else {
    if (stream.waiting.size() >= std::max<std::size_t>(maxWaiting, 1)) giveUpOldest(stream);
    turns_.push_back({id, std::move(message)});
    stream.waiting.push_back(std::prev(turns_.end()));
  }
  while (streamBytes_ > limits_.streamBytes && turns_.size() > 1)
    giveUpOldest(streams_[turns_.front().stream]);
}

void Outbox::addWaiting(std::size_t size) {
  streamBytes_ += size;
  if (size <= limits_.calmBytes) smallBytes_ += size;
}

void Outbox::removeWaiting(std::size_t size) {
  streamBytes_ -= size;
  if (size <= limits_.calmBytes) smallBytes_ -= size;
}

void Outbox::giveUpOldest(Stream& stream) {
  ++(stream.delivery == Delivery::kLatest ? stream.counters.thinned : stream.counters.dropped);
  removeWaiting(stream.waiting.front()->message.size());
  turns_.erase(stream.waiting.front());
  stream.waiting.pop_front();
}

void Outbox::clear(StreamId id) {
  const auto found = streams_.find(id);
  if (found == streams_.end()) return;
  for (const auto turn : found->second.waiting) {
    removeWaiting(turn->message.size());
    turns_.erase(turn);
  }
  found->second.waiting.clear();
}

void Outbox::remove(StreamId id) {
  clear(id);
  streams_.erase(id);
}

void Outbox::clear() {
  control_.clear();
  controlBytes_ = 0;
  for (auto& [id, stream] : streams_) stream.waiting.clear();
  turns_.clear();
  streamBytes_ = smallBytes_ = 0;
}

std::optional<Outgoing> Outbox::next(Instant now) {
  std::optional<Outgoing> message;
  const bool isReady =
      budget_.isReady(now);  // also when control messages go first: time must not be saved up
  if (!control_.empty()) {
    message = std::move(control_.front());
    control_.pop_front();
    controlBytes_ -= message->size();
  } else if (const auto turn = isReady ? firstDue(now) : turns_.end(); turn != turns_.end()) {
    Stream& stream = streams_[turn->stream];
    message = std::move(turn->message);
    // Those of one stream are due together, so this is the first.
    stream.waiting.pop_front();
    turns_.erase(turn);
    removeWaiting(message->size());
    noteSent(stream, message->size(), now);
  }
  if (!message) return message;
  message->hasMore = !control_.empty() || firstDue(now) != turns_.end();
  budget_.take(message->size());
  sentBytes_ += message->size();
  return message;
}

Outbox::Turns::iterator Outbox::firstDue(Instant now) {
  return std::ranges::find_if(turns_, [&](const Turn& turn) { return streams_[turn.stream].due <= now; });
}

void Outbox::noteSent(Stream& stream, std::size_t bytes, Instant now) {
  ++stream.counters.sent;
  stream.counters.bytes += bytes;
  if (stream.gap == Duration::zero()) return;
  // What is sent a little late does not make the rate lower.
  stream.due = (now - stream.due < stream.gap ? stream.due : now) + stream.gap;
}

StreamCounters Outbox::counters(StreamId stream) const {
  const auto found = streams_.find(stream);
  return found == streams_.end() ? StreamCounters() : found->second.counters;
}

}  // namespace robotlink::websocket
