// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "robotlink/process/Process.h"

namespace robotlink {

/// Runs each process in a thread of its own, as on real robots. Processes must outlive it. Platforms are not
/// added: their owner drives them, and calls clockAdvanced() after it has advanced a clock that is not real
/// time. add(), start() and stop() are called by one thread.
class ThreadExecutor {
 public:
  struct Options {
    /// Called in the thread of a process that has thrown and was stopped.
    std::function<void(const Process&)> onFailed;
    /// Called in the process's thread if its priority could not be set, with the reason.
    std::function<void(const Process&, const std::string&)> onPriorityRefused;
    /// Called in the thread of each process before its first frame.
    std::function<void(const Process&)> onStarted = {};
  };

  explicit ThreadExecutor(Options options);
  /// Stops all processes and waits for them.
  ~ThreadExecutor();
  ThreadExecutor(const ThreadExecutor&) = delete;
  ThreadExecutor& operator=(const ThreadExecutor&) = delete;

  void add(Process& process) { processes_.push_back(&process); }
  /// Starts one thread a process.
  void start();
  /// Makes periodic processes look at the clock again. Any thread.
  void clockAdvanced();
  /// Stops all processes and joins their threads. Processes cannot be started again.
  void stop();
  /// The same, but waits at most `limit`. Returns false if there are frames that have not ended by then: this
  /// object, their processes and what these use must exist until hasEnded().
  bool stopWithin(std::chrono::milliseconds limit);
  bool hasEnded() const;
  bool hasEnded(const Process& process) const;
  /// How long the present frame of a process has lasted in real time; zero between frames.
  std::chrono::nanoseconds busyFor(const Process& process) const;

 private:
  struct Slot {
    explicit Slot(Process& executed) : process(executed) {}
    Process& process;
    /// When the present frame began, steady nanoseconds; 0 between frames.
    std::atomic<std::int64_t> since{0};
    std::atomic<bool> hasEnded{false};
    /// No PacedThread: the process waits for its next frame by its own clock, and is what stops the thread.
    std::thread thread;
  };
  void run(Slot& slot);
  /// After stopWithin(): processes that have ended may go.
  void forgetEnded();

  Options options_;
  std::vector<Process*> processes_;
  std::vector<std::unique_ptr<Slot>> slots_;
  /// Signaled when a thread ends; the mutex is locked while it says so in its slot.
  std::mutex mutex_;
  std::condition_variable ended_;
};

}  // namespace robotlink
