// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/FrameQueue.h"

#include <utility>

namespace logplayer {

FrameQueue::Rank FrameQueue::rankOf(std::uint64_t number, const RecordedFrame& frame) {
  return {!frame.holds, frame.largest, number};
}

void FrameQueue::push(RecordedFramePtr frame) {
  ranks_.insert(rankOf(next_, *frame));
  bytes_ += frame->bytes;
  entries_.emplace(next_++, Entry{std::move(frame), {}});
  while (bytes_ > maxBytes_ && !ranks_.empty()) dropGreatest();
}

void FrameQueue::push(Job job) {
  entries_.emplace(next_++, Entry{nullptr, std::move(job)});
}

void FrameQueue::dropGreatest() {
  const auto greatest = std::prev(ranks_.end());
  const auto entry = entries_.find(std::get<2>(*greatest));
  const RecordedFrame& frame = *entry->second.frame;
  bytes_ -= frame.bytes;
  dropped_.messages += frame.messages.size();
  dropped_.bytes += frame.bytes;
  entries_.erase(entry);
  ranks_.erase(greatest);
}

std::optional<FrameQueue::Entry> FrameQueue::pop() {
  if (entries_.empty()) return std::nullopt;
  auto oldest = entries_.extract(entries_.begin());
  Entry entry = std::move(oldest.mapped());
  if (entry.frame) {
    ranks_.erase(rankOf(oldest.key(), *entry.frame));
    bytes_ -= entry.frame->bytes;
  }
  return entry;
}

}  // namespace logplayer
