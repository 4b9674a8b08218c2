// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <thread>
#include <vector>

#include "robotlink/process/Process.h"

namespace robotlink {

/// Runs each process in a thread of its own, as real robots do. Processes must outlive it. Platforms are not
/// added here: whoever owns one paces it and calls clockAdvanced() after it has moved a clock that is not
/// real time.
class ThreadExecutor {
 public:
  struct Options {
    /// A process threw and was stopped. Called in that process's thread.
    std::function<void(const Process&)> onFailed;
    /// A priority could not be set, and why. Called in that process's thread.
    std::function<void(const Process&, const std::string&)> onPriorityRefused;
  };

  explicit ThreadExecutor(Options options);
  /// Stops all processes and waits for them.
  ~ThreadExecutor();
  ThreadExecutor(const ThreadExecutor&) = delete;
  ThreadExecutor& operator=(const ThreadExecutor&) = delete;

  void add(Process& process) { processes_.push_back(&process); }
  void start();
  /// Lets processes look at the clock again; any thread.
  void clockAdvanced();
  void stop();

 private:
  void run(Process& process);

  Options options_;
  std::vector<Process*> processes_;
  std::vector<std::thread> threads_;
};

}  // namespace robotlink
