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
    // The newest message takes the first turn; those in between no longer need one.
    while (stream.waiting.size() > 1) giveUp(stream, std::prev(stream.waiting.end()));
    Outgoing& waiting = stream.waiting.front()->message;
    removeWaiting(waiting.size());
    waiting = std::move(message);
    ++stream.counters.thinned;
  } else {
    if (stream.waiting.size() >= std::max<std::size_t>(maxWaiting, 1)) giveUp(stream, stream.waiting.begin());
    addTurn(id, stream, std::move(message));
  }
  while (streamBytes_ > limits_.streamBytes && small_.turns.size() + large_.turns.size() > 1) {
    Stream& longest = longestWaiting();
    giveUp(longest, longest.waiting.begin());
  }
}

void Outbox::addTurn(StreamId id, Stream& stream, Outgoing message) {
  if (stream.waiting.empty()) stream.line = message.size() > limits_.smallBytes ? &large_ : &small_;
  Line& line = *stream.line;
  if (line.turns.empty()) line.sent = std::max(small_.sent, large_.sent);
  line.turns.push_back({id, std::move(message), turnCount_++});
  stream.waiting.push_back(std::prev(line.turns.end()));
}

Outbox::Stream& Outbox::longestWaiting() {
  const bool isSmall = large_.turns.empty() ||
                       (!small_.turns.empty() && small_.turns.front().number < large_.turns.front().number);
  return streams_[(isSmall ? small_ : large_).turns.front().stream];
}

void Outbox::addWaiting(std::size_t size) {
  streamBytes_ += size;
  if (size <= limits_.calmBytes) smallBytes_ += size;
}

void Outbox::removeWaiting(std::size_t size) {
  streamBytes_ -= size;
  if (size <= limits_.calmBytes) smallBytes_ -= size;
}

void Outbox::giveUp(Stream& stream, std::deque<Turns::iterator>::iterator which) {
  ++(stream.delivery == Delivery::kLatest ? stream.counters.thinned : stream.counters.dropped);
  removeWaiting((*which)->message.size());
  stream.line->turns.erase(*which);
  stream.waiting.erase(which);
}

void Outbox::clear(StreamId id) {
  const auto found = streams_.find(id);
  if (found == streams_.end()) return;
  for (const auto turn : found->second.waiting) {
    removeWaiting(turn->message.size());
    found->second.line->turns.erase(turn);
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
  small_.turns.clear();
  large_.turns.clear();
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
  } else if (const Turn* turn = isReady ? firstDue(now) : nullptr) {
    Stream& stream = streams_[turn->stream];
    message = takeFirst(stream);
    noteSent(stream, message->size(), now);
  }
  if (!message) return message;
  message->hasMore = !control_.empty() || firstDue(now) != nullptr;
  budget_.take(message->size());
  sentBytes_ += message->size();
  return message;
}

/// Removes the first message of a stream: all messages of a stream are due together.
Outgoing Outbox::takeFirst(Stream& stream) {
  Outgoing message = std::move(stream.waiting.front()->message);
  stream.line->sent += message.size();
  stream.line->turns.erase(stream.waiting.front());
  stream.waiting.pop_front();
  removeWaiting(message.size());
  return message;
}

Outbox::Turn* Outbox::firstDueOf(Line& line, Instant now) {
  const auto due =
      std::ranges::find_if(line.turns, [&](const Turn& turn) { return streams_[turn.stream].due <= now; });
  return due == line.turns.end() ? nullptr : &*due;
}

Outbox::Turn* Outbox::firstDue(Instant now) {
  Turn* small = firstDueOf(small_, now);
  Turn* large = firstDueOf(large_, now);
  if (small == nullptr || large == nullptr) return small != nullptr ? small : large;
  if (small_.sent == large_.sent) return small->number < large->number ? small : large;
  return small_.sent < large_.sent ? small : large;
}

void Outbox::noteSent(Stream& stream, std::size_t bytes, Instant now) {
  ++stream.counters.sent;
  stream.counters.bytes += bytes;
  if (stream.gap == Duration::zero()) return;
  // A message that is sent a little late does not lower the rate.
  stream.due = (now - stream.due < stream.gap ? stream.due : now) + stream.gap;
}

StreamCounters Outbox::counters(StreamId stream) const {
  const auto found = streams_.find(stream);
  return found == streams_.end() ? StreamCounters() : found->second.counters;
}

}  // namespace robotlink::websocket
