// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/StreamStore.h"

#include <google/protobuf/message.h>

#include <algorithm>

#include "robotlink/session/LatchedMessages.h"

namespace robotlink {
namespace {

constexpr Duration kRateWindow = std::chrono::seconds(1);
constexpr Duration kSweepPeriod = std::chrono::milliseconds(100);

bool earlier(Instant time, const StreamMessage& message) {
  return time < message.time;
}

// Messages in the last second, or since the stream began if that is less.
double rateOf(const StreamStore::Stream& stream, Instant now) {
  const Instant from = std::max(stream.since, now - kRateWindow);
  if (now <= from) return 0;
  const auto& messages = stream.messages;
  const auto first = std::upper_bound(messages.begin(), messages.end(), from, earlier);
  return static_cast<double>(messages.end() - first) / seconds(now - from);
}

}  // namespace

std::size_t sizeOf(const StreamMessage& message) {
  // The message object, its place in the history, and its path.
  constexpr std::size_t kOverhead = 256;
  if (!message.value) return kOverhead;
  // The size in memory, not on the wire: a drawing of points takes several times the bytes that it is sent
  // as. The excess is in separate allocations, for which the heap needs about a third more.
  const std::size_t inMemory = message.value->SpaceUsedLong(), onWire = message.value->ByteSizeLong();
  return kOverhead + inMemory + (inMemory > onWire ? (inMemory - onWire) / 3 : 0);
}

StreamStore::StreamStore(Limits limits) : limits_(limits) {}

StreamStore::Stream* StreamStore::streamFor(const StreamMessage& message) {
  auto found = streams_.find(message.path);
  if (found == streams_.end()) {
    if (streams_.size() >= limits_.streams) {
      ++refused_;
      return nullptr;
    }
    found = streams_.try_emplace(message.path).first;
    found->second.path = message.path;
    found->second.generation = generation_;
    found->second.since = message.time;
    ++listVersion_;
  }
  const std::string& type = message.value->GetDescriptor()->full_name();
  if (found->second.type != type) {
    found->second.type = type;
    ++listVersion_;
  }
  return &found->second;
}

void StreamStore::add(StreamMessage message) {
  if (!message.value) return;
  Stream* stream = streamFor(message);
  if (!stream) return;
  const auto last = stream->newestOf.find(message.process);
  if (last != stream->newestOf.end() && message.time < last->second) forgetAfter(message.time);
  stream->newestOf[message.process] = message.time;
  newest_ = streams_.size() == 1 && stream->count == 0 ? message.time : std::max(newest_, message.time);
  insert(*stream, std::move(message));
  forgetOld();
}

void StreamStore::insert(Stream& stream, StreamMessage message) {
  if (message.bytes == 0) message.bytes = sizeOf(message);
  bytes_ += message.bytes;
  stream.bytes += message.bytes;
  ++stream.count;
  const auto at = std::upper_bound(stream.messages.begin(), stream.messages.end(), message.time, earlier);
  stream.messages.insert(at, std::move(message));
}

void StreamStore::popFront(Stream& stream) {
  bytes_ -= stream.messages.front().bytes;
  stream.bytes -= stream.messages.front().bytes;
  stream.messages.pop_front();
}

void StreamStore::forgetAfter(Instant time) {
  for (auto& [path, stream] : streams_) {
    auto& messages = stream.messages;
    StreamMessage kept;
    while (!messages.empty() && messages.back().time > time) {
      bytes_ -= messages.back().bytes;
      stream.bytes -= messages.back().bytes;
      if (!kept.value && isLatched(path, stream.type)) kept = std::move(messages.back());
      messages.pop_back();
    }
    stream.since = std::min(stream.since, time);
    for (auto& [process, newest] : stream.newestOf) newest = std::min(newest, time);
    if (!kept.value) continue;
    kept.time = time;
    // The message was not received again.
    --stream.count;
    insert(stream, std::move(kept));
  }
  newest_ = swept_ = time;
}

void StreamStore::forgetOld() {
  // Often enough for rates; all streams are checked, even those without new messages.
  if (newest_ - swept_ >= kSweepPeriod || newest_ < swept_) sweep();
  while (bytes_ > limits_.bytes) {
    Stream* oldest = nullptr;
    for (auto& [path, stream] : streams_) {
      if (stream.messages.size() < 2) continue;
      if (!oldest || stream.messages.front().time < oldest->messages.front().time) oldest = &stream;
    }
    if (!oldest) return;
    popFront(*oldest);
  }
}

void StreamStore::sweep() {
  const Instant oldest = newest_ - limits_.age;
  swept_ = newest_;
  for (auto& [path, stream] : streams_) {
    // What a silent stream published last is kept for good.
    while (stream.messages.size() > 1 && stream.messages.front().time < oldest) popFront(stream);
    stream.rate = rateOf(stream, newest_);
  }
}

void StreamStore::clear() {
  streams_.clear();
  bytes_ = 0;
  ++listVersion_;
  ++generation_;
  newest_ = swept_ = Instant{};
}

const StreamStore::Stream* StreamStore::find(const std::string& path) const {
  const auto found = streams_.find(path);
  return found == streams_.end() ? nullptr : &found->second;
}

std::vector<const StreamStore::Stream*> StreamStore::streams(const std::string& prefix) const {
  std::vector<const Stream*> result;
  for (auto it = streams_.lower_bound(prefix); it != streams_.end() && it->first.starts_with(prefix); ++it) {
    result.push_back(&it->second);
  }
  return result;
}

const StreamMessage* StreamStore::latest(const std::string& path, Instant time) const {
  const Stream* stream = find(path);
  if (!stream) return nullptr;
  const auto after = std::upper_bound(stream->messages.begin(), stream->messages.end(), time, earlier);
  return after == stream->messages.begin() ? nullptr : &*std::prev(after);
}

}  // namespace robotlink
