// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace robotlink {

/// A queue between threads that never blocks its producers: when it is full, a pushed value is dropped and
/// counted. The consumer drains the whole queue at once. Thread-safe. Nothing is signaled; the consumer
/// polls, as the GUI does in its 30 Hz tick.
template <typename T>
class BoundedQueue {
 public:
  /// The capacity is the number of values, whatever their size.
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// Returns false if the queue was full and `value` was dropped.
  bool push(T value) {
    const std::lock_guard lock(mutex_);
    if (values_.size() >= capacity_) {
      ++dropped_;
      return false;
    }
    values_.push_back(std::move(value));
    return true;
  }

  /// Enqueues `value` however full the queue is: for what must arrive, and of which its producer has few.
  void pushAlways(T value) {
    const std::lock_guard lock(mutex_);
    values_.push_back(std::move(value));
  }

  /// Removes and returns all queued values, oldest first.
  std::vector<T> drain() {
    const std::lock_guard lock(mutex_);
    return std::exchange(values_, {});
  }

  /// The number of values dropped since the queue was created.
  std::size_t dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  const std::size_t capacity_;
  /// Protects values_ and dropped_.
  mutable std::mutex mutex_;
  std::vector<T> values_;
  std::size_t dropped_ = 0;
};

}  // namespace robotlink
