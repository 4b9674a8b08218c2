// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>
#include <variant>

namespace robotlink {

/// A thread that does one job at a time for its owner. The newest job wins: it replaces a job that has not
/// begun, and asks the one in progress to end by its stop token, which that job may ignore. The newest result
/// waits here until the owner takes it, as the GUI does in its tick.
///
/// All functions may be called from any thread. It must be declared after all that its jobs use: the
/// destructor asks the job in progress to end, and waits for it.
template <typename Job, typename Result = std::monostate>
class Worker {
 public:
  using Clock = std::chrono::steady_clock;
  /// Does a job; called in the thread. The token says that the job should end soon.
  using Work = std::function<void(Job, const std::stop_token&)>;
  /// All functions are called in the thread.
  struct Options {
    /// Called after each result; must not block.
    std::function<void()> news = {};
    /// The first and the last call.
    std::function<void()> begin = {}, end = {};
    /// The time before which a job must not begin. Asked again when the job was replaced; must not call the
    /// worker.
    std::function<Clock::time_point(const Job&)> due = {};
    /// Whether the destructor lets all jobs be done, rather than ending the one in progress and dropping the
    /// other.
    bool finishesJobs = false;
  };

  explicit Worker(Work work) : Worker(std::move(work), Options()) {}
  Worker(Work work, Options options)
      : work_(std::move(work)), options_(std::move(options)), thread_([this] { run(); }) {}
  ~Worker() {
    {
      const std::lock_guard lock(mutex_);
      quit_ = true;
      if (!options_.finishesJobs) running_.request_stop();
    }
    changed_.notify_all();
    thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Replaces a job that has not begun.
  void post(Job job) {
    {
      const std::lock_guard lock(mutex_);
      running_.request_stop();
      waiting_.emplace(Posted{std::move(job), {}});
    }
    changed_.notify_all();
  }
  /// Does nothing and returns false if another job waits or is in progress.
  bool postIfFree(Job job) {
    {
      const std::lock_guard lock(mutex_);
      if (busy()) return false;
      waiting_.emplace(Posted{std::move(job), {}});
    }
    changed_.notify_all();
    return true;
  }
  /// Asks the job in progress to end. A job that has not begun is done, too, with a token that asks it to
  /// end.
  void cancel() {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
    if (waiting_) waiting_->stop.request_stop();
  }
  /// Blocks until no job waits or is in progress.
  void finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !busy(); });
  }

  /// Called by a job: makes a result available, in place of one that was not taken.
  void publish(Result result) {
    {
      const std::lock_guard lock(mutex_);
      result_ = std::move(result);
    }
    if (options_.news) options_.news();
  }
  /// The newest result that was not taken yet.
  std::optional<Result> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(result_, std::nullopt);
  }
  /// Whether all jobs are done and the newest result was taken.
  bool idle() const {
    const std::lock_guard lock(mutex_);
    return !busy() && !result_;
  }

 private:
  struct Posted {
    Job job;
    std::stop_source stop;
  };

  void run() {
    if (options_.begin) options_.begin();
    std::unique_lock lock(mutex_);
    while (waitForJob(lock)) {
      running_ = waiting_->stop;
      const std::stop_token stop = running_.get_token();
      Job job = std::move(waiting_->job);
      waiting_.reset();
      working_ = true;
      lock.unlock();
      work_(std::move(job), stop);
      lock.lock();
      running_ = std::stop_source(std::nostopstate);
      working_ = false;
      changed_.notify_all();
    }
    lock.unlock();
    if (options_.end) options_.end();
  }
  /// Returns false when the thread must end.
  bool waitForJob(std::unique_lock<std::mutex>& lock) {
    while (true) {
      if (quit_) return waiting_ && options_.finishesJobs;
      if (!waiting_) {
        changed_.wait(lock);
        continue;
      }
      if (!options_.due) return true;
      const Clock::time_point due = options_.due(waiting_->job);
      if (Clock::now() >= due) return true;
      changed_.wait_until(lock, due);
    }
  }
  bool busy() const { return waiting_ || working_; }

  const Work work_;
  const Options options_;
  /// Protects all following members but the thread.
  mutable std::mutex mutex_;
  /// Signaled when a job is posted or done, and by the destructor.
  std::condition_variable changed_;
  std::optional<Posted> waiting_;
  /// Belongs to the job in progress.
  std::stop_source running_{std::nostopstate};
  bool working_ = false;
  bool quit_ = false;
  std::optional<Result> result_;
  std::thread thread_;
};

}  // namespace robotlink
