// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace app {

/// A thread that does jobs in the order in which they came, and between them makes steps when they are due.
/// Jobs go first: what a person asks for is done between two steps.
///
/// The functions of `Work` are called in this thread only; what they use must outlive it.
class PacedThread {
 public:
  using Clock = std::chrono::steady_clock;
  using Job = std::function<void()>;
  struct Work {
    /// When the next step is to be made; nothing: not before a job has changed that. Asked after each step
    /// and each job.
    std::function<std::optional<Clock::time_point>()> due;
    std::function<void()> step;
    std::function<void()> end;  ///< the thread's last call
  };

  explicit PacedThread(Work work);
  /// Waits for the job or step that is being done; jobs that still wait are dropped.
  ~PacedThread();
  PacedThread(const PacedThread&) = delete;
  PacedThread& operator=(const PacedThread&) = delete;

  /// Any thread; never waits.
  void post(Job job);

 private:
  void runLoop();
  bool doJobs(std::unique_lock<std::mutex>& lock);

  const Work work_;
  std::mutex mutex_;  // protects jobs_ and quit_
  std::condition_variable wakeUp_;
  std::deque<Job> jobs_;
  bool quit_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace app
