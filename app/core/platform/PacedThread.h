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

/// A thread that executes jobs in the order in which they were posted and, between them, makes steps when
/// these are due. Jobs take precedence, so a request of the user is applied between two steps.
///
/// The functions of `Work` are called in this thread only; what they refer to must outlive this object.
/// It is not a robotlink::Worker, which keeps the newest job only and makes no steps by itself.
class PacedThread {
 public:
  using Clock = std::chrono::steady_clock;
  using Job = std::function<void()>;
  /// The work of the thread besides jobs.
  struct Work {
    /// When the next step is due; nothing: no step until a job changes that. Called again after each step and
    /// each job.
    std::function<std::optional<Clock::time_point>()> due;
    /// Makes one step.
    std::function<void()> step;
    /// The last call in the thread; may be empty.
    std::function<void()> end;
  };

  explicit PacedThread(Work work);
  /// Waits for the job or step that is in progress. Jobs that were not started are dropped.
  ~PacedThread();
  PacedThread(const PacedThread&) = delete;
  PacedThread& operator=(const PacedThread&) = delete;

  /// Enqueues a job. Any thread; never blocks for long. The queue is unbounded.
  void post(Job job);
  /// Enqueues a job that is executed before all others that wait, behind earlier urgent ones.
  void postUrgent(Job job);

 private:
  void postTo(std::deque<Job>& jobs, Job job);
  /// The thread's function.
  void runLoop();
  /// Executes all waiting jobs, with `lock` released during each. Returns false when the thread is to end.
  bool doJobs(std::unique_lock<std::mutex>& lock);

  const Work work_;
  /// Protects the jobs and quit_.
  std::mutex mutex_;
  /// Notified when a job is posted or the thread is to end.
  std::condition_variable wakeUp_;
  std::deque<Job> urgent_, jobs_;
  bool quit_ = false;
  /// The last member, since the thread uses the others.
  std::thread thread_;
};

}  // namespace app
