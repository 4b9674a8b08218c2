// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <thread>
#include <vector>

#include "robotlink/process/Process.h"

namespace robotlink {

/// Runs each process in a thread of its own, as on real robots. Processes must outlive it. Platforms are not
/// added: their owner drives them, and calls clockAdvanced() after it has advanced a clock that is not real
/// time. add(), start() and stop() are called by one thread. No Workers, since a process decides itself when
/// its next frame begins.
class ThreadExecutor {
 public:
  struct Options {
    /// Called in the thread of a process that has thrown and was stopped.
    std::function<void(const Process&)> onFailed;
    /// Called in the process's thread if its priority could not be set, with the reason.
    std::function<void(const Process&, const std::string&)> onPriorityRefused;
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

 private:
  void run(Process& process);

  Options options_;
  std::vector<Process*> processes_;
  std::vector<std::thread> threads_;
};

}  // namespace robotlink
