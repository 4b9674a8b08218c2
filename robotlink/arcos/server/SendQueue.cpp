// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/SendQueue.h"

namespace robotlink::arcos {

void SendQueue::push(const Packet& packet, Instant now) {
  const std::size_t before = bytes_.size();
  append(packet, bytes_);
  packets_.push_back({bytes_.size() - before, now});
  std::size_t excess = 0, size = bytes_.size();
  for (std::size_t i = firstWhole(); size > kMaxBytes && i + 1 < packets_.size(); ++i, ++excess)
    size -= packets_[i].size;
  drop(excess);
}

void SendQueue::dropOld(Instant now) {
  std::size_t old = 0;
  for (std::size_t i = firstWhole(); i < packets_.size() && now - packets_[i].pushed > kMaxAge; ++i) ++old;
  drop(old);
}

/// Drops packets, beginning with the first one that was not written in part.
void SendQueue::drop(std::size_t packets) {
  if (packets == 0) return;
  const auto first = packets_.begin() + static_cast<std::ptrdiff_t>(firstWhole());
  const auto last = first + static_cast<std::ptrdiff_t>(packets);
  const auto begin = bytes_.begin() + static_cast<std::ptrdiff_t>(begun_ ? packets_.front().size : 0);
  std::size_t size = 0;
  for (auto entry = first; entry != last; ++entry) size += entry->size;
  bytes_.erase(begin, begin + static_cast<std::ptrdiff_t>(size));
  packets_.erase(first, last);
  dropped_ += packets;
}

void SendQueue::written(std::size_t count) {
  bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(count));
  while (count > 0 && count >= packets_.front().size) {
    count -= packets_.front().size;
    packets_.pop_front();
    begun_ = false;
    ++sent_;
  }
  if (count == 0) return;
  packets_.front().size -= count;
  begun_ = true;
}

void SendQueue::clear() {
  bytes_.clear();
  packets_.clear();
  begun_ = false;
}

}  // namespace robotlink::arcos
