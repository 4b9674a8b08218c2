// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "robotlink/process/Platform.h"

namespace robotlink {

/// Runs processes and their platforms in turn, in the caller's thread: time is the platforms', and the same inputs give the
/// same bytes at any speed.
///
/// A step: in order, every process that may enter phase 2 runs, at most once an instant, until none can; then the
/// platforms step: all actuate, the world that they share moves its clock on, all send their sensors. A process that has not run for `starvation` of the platform's time is reported with what it waits for,
/// once until it runs again. Processes and platforms must outlive the executor; one thread at a time.
class LockstepExecutor {
 public:
  struct Options {
    Duration starvation = std::chrono::seconds(2);
    /// Moves the platforms' world and its clock.
    std::function<void()> advance;
    /// "X waits for Y"; called by step().
    std::function<void(const Process&, const std::string&)> onStarved;
    /// A process threw and was stopped; called by step().
    std::function<void(const Process&)> onFailed;
  };

  explicit LockstepExecutor(Options options);
  void add(Process& process) { processes_.push_back({&process, {}, false, false, false}); }
  void add(Platform& platform) { platforms_.push_back(&platform); }
  void clear();

  void step();

 private:
  struct Entry {
    Process* process;
    Instant lastRun;
    bool everRan;
    bool reported;
    bool failureReported;
  };
  void runUntilNoneCan(Instant now);
  void report(Entry& entry, Instant now);

  Options options_;
  std::vector<Entry> processes_;
  std::vector<Platform*> platforms_;
  Instant firstStep_;
  bool started_ = false;
};

}  // namespace robotlink
