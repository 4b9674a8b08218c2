// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <functional>
#include <mutex>
#include <variant>

#include "robotlink/base/Worker.h"

namespace app {

/// A thread that does jobs one after the other, in their order. Any thread may add some.
class JobQueue {
 public:
  using Job = std::function<void()>;

  void add(Job job) {
    {
      const std::lock_guard lock(mutex_);
      if (isClosed_) return;
      waiting_.push_back(std::move(job));
    }
    worker_.post({});
  }
  /// Drops the jobs that have not begun.
  void clear() {
    std::deque<Job> left;
    const std::lock_guard lock(mutex_);
    left.swap(waiting_);
  }
  /// Waits for the job in progress; after this, no more jobs are done.
  void close() {
    std::deque<Job> left;
    {
      const std::lock_guard lock(mutex_);
      isClosed_ = true;
      left.swap(waiting_);
    }
    worker_.finish();
  }

 private:
  void work() {
    while (true) {
      Job job;
      {
        const std::lock_guard lock(mutex_);
        if (waiting_.empty()) return;
        job = std::move(waiting_.front());
        waiting_.pop_front();
      }
      job();
    }
  }

  std::mutex mutex_;
  std::deque<Job> waiting_;
  bool isClosed_ = false;
  /// The last member, since its thread uses the others.
  robotlink::Worker<std::monostate> worker_{[this](std::monostate, const std::stop_token&) { work(); }};
};

}  // namespace app
