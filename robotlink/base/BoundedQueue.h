// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace robotlink {

/// A queue between threads that never blocks its producers: when it is full, what is pushed is dropped
/// and counted. The consumer drains it whole. Thread-safe.
template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t capacity) : capacity_(capacity) {}

  /// False if the queue was full and `value` was dropped.
  bool push(T value) {
    const std::lock_guard lock(mutex_);
    if (values_.size() >= capacity_) {
      ++dropped_;
      return false;
    }
    values_.push_back(std::move(value));
    return true;
  }

  /// Everything that is queued, oldest first.
  std::vector<T> drain() {
    const std::lock_guard lock(mutex_);
    return std::exchange(values_, {});
  }

  /// How many were dropped since the queue was made.
  std::size_t dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;  // protects values_ and dropped_
  std::vector<T> values_;
  std::size_t dropped_ = 0;
};

}  // namespace robotlink
