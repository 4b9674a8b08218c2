// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

#include "app/robotctl/compare/RunPlan.h"

namespace app {

/// The progress of a set of runs, for one line of output.
struct RunProgress {
  std::size_t all = 0, done = 0, failed = 0, running = 0;
};

/// Executes runs as processes of their own, some at once; each writes its result into the runs' folder. They
/// end with this program, however that ends. One thread.
class RunPool {
 public:
  /// `parallel`: how many run at once.
  RunPool(const RunFiles& files, std::size_t parallel) : files_(files), parallel_(parallel) {}
  /// Ends those that run.
  ~RunPool();
  RunPool(const RunPool&) = delete;
  RunPool& operator=(const RunPool&) = delete;

  /// Executes all of these; blocks until each has ended. `look` is called several times a second, and ends
  /// everything by returning false. Returns those that failed or were not executed.
  std::vector<PlannedRun> execute(std::vector<PlannedRun> runs,
                                  const std::function<bool(const RunProgress&)>& look);

 private:
  struct Child {
    ::pid_t pid = 0;
    PlannedRun run;
  };
  /// Starts a run; false if that is impossible.
  bool start(const PlannedRun& run);
  /// Takes note of those that have ended.
  void collect(RunProgress& progress, std::vector<PlannedRun>& failed);
  void endAll();

  const RunFiles& files_;
  const std::size_t parallel_;
  std::vector<Child> children_;
};

}  // namespace app
