// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace robotlink {

/// A thread that makes steps when these are due, until it is destroyed, and executes jobs between them in the
/// order in which they were posted. Jobs take precedence, so a request of the user is applied between two
/// steps. All threads that repeat something are of this class; Worker is for single jobs, of which only the
/// newest one counts.
///
/// The functions of `Work` are called in this thread only, and must not throw. What they refer to must
/// outlive this object, so it is the last member of its owner.
class PacedThread {
 public:
  using Clock = std::chrono::steady_clock;
  using Job = std::function<void()>;
  /// The work of the thread besides jobs.
  struct Work {
    /// When the next step is due; nothing: no step until a job or wake() changes that. Called again after
    /// each step, each job and each wake().
    std::function<std::optional<Clock::time_point>()> due;
    /// Makes one step.
    std::function<void()> step;
    /// The last call in the thread; may be empty.
    std::function<void()> end = {};
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
  /// Has Work::due() called again if the thread waits, or else before it waits next. Any thread; several
  /// calls may count as one.
  void wake();
  /// Whether the destructor has been called: a step that takes long should return. Any thread.
  bool isEnding() const;

 private:
  void postTo(std::deque<Job>& jobs, Job job);
  /// The thread's function.
  void runLoop();
  /// Executes all waiting jobs, with `lock` released during each. Returns false when the thread is to end.
  bool doJobs(std::unique_lock<std::mutex>& lock);

  const Work work_;
  /// Protects the jobs, isWoken_ and quit_.
  mutable std::mutex mutex_;
  /// Notified when a job is posted, the thread is woken or is to end.
  std::condition_variable wakeUp_;
  std::deque<Job> urgent_, jobs_;
  bool isWoken_ = false, quit_ = false;
  /// The last member, since the thread uses the others.
  std::thread thread_;
};

}  // namespace robotlink
