// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/StreamStore.h"

#include <google/protobuf/message.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

#include "robotlink/session/LatchedMessages.h"

namespace robotlink {
namespace {

constexpr Duration kRateWindow = std::chrono::seconds(1);
constexpr Duration kSweepPeriod = std::chrono::milliseconds(100);
/// Beyond the limit, this share of it is dropped at once.
constexpr std::size_t kDropShare = 32;
/// If the limit was lowered, this much is dropped in a tick: little enough for the GUI's thread, and for the
/// archive to have it written before long.
constexpr std::size_t kLowerBytes = std::size_t{16} << 20U;

bool earlier(Instant time, const StreamMessage& message) {
  return time < message.time;
}

/// Sets the rates by the messages in the last second, or since the stream began if that is less.
void updateRates(StreamStore::Stream& stream, Instant now) {
  stream.rate = stream.byteRate = 0;
  const Instant from = std::max(stream.since, now - kRateWindow);
  if (now <= from) return;
  const auto& messages = stream.messages;
  const auto first = std::upper_bound(messages.begin(), messages.end(), from, earlier);
  std::size_t bytes = 0;
  for (auto at = first; at != messages.end(); ++at) bytes += at->bytes;
  stream.rate = static_cast<double>(messages.end() - first) / seconds(now - from);
  stream.byteRate = static_cast<double>(bytes) / seconds(now - from);
}

/// The bytes that a message takes in memory. Counting them by reflection takes longer than serializing it,
/// so those of a type that are equally long on the wire share what one of them was found to take: streams
/// have messages of the same shape repeatedly.
std::size_t memoryOf(const google::protobuf::Message& message, std::size_t onWire) {
  struct Known {
    const google::protobuf::Descriptor* type = nullptr;
    std::size_t onWire = 0, inMemory = 0;
    int uses = 0;
  };
  constexpr std::size_t kKnown = 1024;
  constexpr int kMaxUses = 32;
  thread_local std::array<Known, kKnown> all;
  const auto* type = message.GetDescriptor();
  Known& known = all[(std::hash<const void*>()(type) / alignof(std::max_align_t) + onWire) % kKnown];
  if (known.type != type || known.onWire != onWire || known.uses >= kMaxUses)
    known = {type, onWire, message.SpaceUsedLong(), 0};
  ++known.uses;
  return known.inMemory;
}

}  // namespace

std::size_t sizeOf(const StreamMessage& message) {
  // The message object, its place in the history, and its path.
  constexpr std::size_t kOverhead = 256;
  if (!message.value) return kOverhead;
  // The size in memory, not on the wire: a drawing of points takes several times the bytes that it is sent
  // as. The excess is in separate allocations, for which the heap needs about a third more.
  const std::size_t onWire = message.value->ByteSizeLong(), inMemory = memoryOf(*message.value, onWire);
  return kOverhead + inMemory + (inMemory > onWire ? (inMemory - onWire) / 3 : 0);
}

StreamStore::StreamStore(Limits limits) : limits_(limits), bound_(limits.bytes) {}

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
  const auto recent = stream.messages.begin() + static_cast<std::ptrdiff_t>(stream.lookedAt);
  const auto at = std::upper_bound(recent, stream.messages.end(), message.time, earlier);
  stream.messages.insert(at, std::move(message));
}

void StreamStore::dropOldest(Stream& stream, std::size_t count, std::vector<StreamMessage>& dropped) {
  const auto begin = stream.messages.begin() + static_cast<std::ptrdiff_t>(stream.lookedAt);
  const auto end = begin + static_cast<std::ptrdiff_t>(count);
  if (archive_) dropped.insert(dropped.end(), begin, end);
  // A stretch that is looked at includes the newest message at its begin.
  const auto isLookedAt = [this](const StreamMessage& message, const StreamMessage& following) {
    return looked_ && message.time <= looked_->to && following.time > looked_->from;
  };
  auto kept = begin;
  for (auto at = begin; at != end; ++at) {
    if (isLookedAt(*at, *std::next(at))) {
      lookedBytes_ += at->bytes;
      if (kept != at) *kept = std::move(*at);
      ++kept;
    } else {
      bytes_ -= at->bytes;
      stream.bytes -= at->bytes;
    }
  }
  stream.lookedAt += static_cast<std::size_t>(kept - begin);
  stream.messages.erase(kept, end);
}

void StreamStore::forgetAfter(Instant time) {
  lookAway();
  horizon_ = std::min(horizon_, time);
  if (archive_) archive_->forgetAfter(time);
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
  // Not one by one, since all streams have to be looked through, and since the archive gets them together.
  if (bytes_ - lookedBytes_ > bound_) drop(Instant::min(), bound_ - bound_ / kDropShare);
}

void StreamStore::drop(Instant until, std::size_t bytes) {
  // A message holds until the next one of its stream, whose time decides when it is dropped. That also keeps
  // the newest message of each stream.
  struct Next {
    Instant time;
    Stream* stream;
    std::size_t dropped;
  };
  const auto later = [](const Next& a, const Next& b) { return a.time > b.time; };
  std::vector<Next> next;
  for (auto& [path, stream] : streams_) {
    if (stream.messages.size() > stream.lookedAt + 1)
      next.push_back({stream.messages[stream.lookedAt + 1].time, &stream, 0});
  }
  std::make_heap(next.begin(), next.end(), later);
  std::size_t remaining = bytes_ - lookedBytes_;
  std::vector<Next> ended;
  const Instant before = horizon_;
  while (!next.empty() && (next.front().time <= until || remaining > bytes)) {
    std::pop_heap(next.begin(), next.end(), later);
    Next& oldest = next.back();
    const auto& messages = oldest.stream->messages;
    horizon_ = std::max(horizon_, oldest.time);
    remaining -= messages[oldest.stream->lookedAt + oldest.dropped].bytes;
    ++oldest.dropped;
    const std::size_t following = oldest.stream->lookedAt + oldest.dropped + 1;
    if (following < messages.size()) {
      oldest.time = messages[following].time;
      std::push_heap(next.begin(), next.end(), later);
    } else {
      ended.push_back(oldest);
      next.pop_back();
    }
  }
  std::vector<StreamMessage> dropped;
  for (const auto& those : {next, ended}) {
    for (const Next& each : those) dropOldest(*each.stream, each.dropped, dropped);
  }
  if (archive_ && !dropped.empty()) archive_->add(std::move(dropped), {before, horizon_});
}

void StreamStore::sweep() {
  swept_ = newest_;
  if (limits_.age < kNoLimit) drop(newest_ - limits_.age, std::numeric_limits<std::size_t>::max());
  for (auto& [path, stream] : streams_) updateRates(stream, newest_);
}

void StreamStore::setBytes(std::size_t bytes) {
  limits_.bytes = bytes;
  bound_ = archive_ ? std::max(bytes, bytes_ - lookedBytes_) : bytes;
  forgetOld();
}

void StreamStore::lowerBound() {
  if (bound_ == limits_.bytes || (archive_ && !archive_->hasRoom())) return;
  const std::size_t kept = bytes_ - lookedBytes_;
  const std::size_t lower = archive_ && kept > kLowerBytes ? kept - kLowerBytes : 0;
  bound_ = std::max(limits_.bytes, lower);
  // Not by forgetOld(), which drops more than what exceeds the bound.
  drop(Instant::min(), bound_);
}

bool StreamStore::has(Instant time) const {
  return time >= horizon_ || (looked_ && looked_->from <= time && time <= looked_->to);
}

void StreamStore::lookAt(Stretch stretch) {
  lookAway();
  looked_ = {std::max(stretch.from, horizon_), stretch.to};
}

void StreamStore::lookAt(Stretch stretch, std::vector<StreamMessage> messages) {
  lookAway();
  looked_ = stretch;
  for (StreamMessage& message : messages) {
    const auto found = streams_.find(message.path);
    if (found == streams_.end()) continue;
    Stream& stream = found->second;
    if (message.bytes == 0) message.bytes = sizeOf(message);
    bytes_ += message.bytes;
    stream.bytes += message.bytes;
    lookedBytes_ += message.bytes;
    const auto at = stream.messages.begin() + static_cast<std::ptrdiff_t>(stream.lookedAt);
    stream.messages.insert(at, std::move(message));
    ++stream.lookedAt;
  }
}

void StreamStore::lookAway() {
  looked_.reset();
  if (lookedBytes_ == 0) return;
  for (auto& [path, stream] : streams_) {
    for (; stream.lookedAt > 0; --stream.lookedAt) {
      bytes_ -= stream.messages.front().bytes;
      stream.bytes -= stream.messages.front().bytes;
      stream.messages.pop_front();
    }
  }
  lookedBytes_ = 0;
}

void StreamStore::clear() {
  streams_.clear();
  bytes_ = lookedBytes_ = 0;
  bound_ = limits_.bytes;
  looked_.reset();
  horizon_ = Instant::min();
  if (archive_) archive_->clear();
  ++listVersion_;
  ++generation_;
  newest_ = swept_ = Instant{};
}

const StreamStore::Stream* StreamStore::find(const std::string& path) const {
  const auto found = streams_.find(path);
  if (found == streams_.end()) return nullptr;
  noteRead(found->second);
  return &found->second;
}

void StreamStore::forgetReaders() {
  for (auto& [path, stream] : streams_) stream.readers = 0;
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
