// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Platform.h"

namespace robotlink {

/// Runs processes and their platforms in turn, in the caller's thread: time is the platforms', and the same
/// inputs give the same bytes at any speed.
///
/// A step: in order, every process that may enter phase 2 runs, at most once an instant, until none can; then
/// the platforms step: all actuate, the world that they share moves its clock on, all send their sensors. A
/// process that has not run for `starvation` of the platform's time beyond its period is reported with what
/// it waits for, once until it runs again. The first platform's clock counts. Processes and platforms must
/// outlive the executor or be cleared; one thread at a time.
class LockstepExecutor {
 public:
  struct Options {
    Duration starvation = std::chrono::seconds(2);
    /// Moves the platforms' world and its clock.
    std::function<void()> advance;
    /// "X waits for Y"; called by step().
    std::function<void(const Process&, const std::string&)> onStarved;
    /// A process or a platform threw and was stopped; called by step().
    std::function<void(const Process&)> onFailed;
  };

  explicit LockstepExecutor(Options options);
  void add(Process& process) { processes_.push_back({.process = &process}); }
  void add(Platform& platform) { platforms_.push_back({.process = &platform, .platform = &platform}); }
  void clear();

  void step();
  /// The first half of a step: processes, until none can run.
  void runProcesses();
  /// The second half. Whoever begins with it, as a log does, sees what the processes made of the new instant.
  void stepPlatforms();

 private:
  struct Entry {
    Process* process;
    Platform* platform = nullptr;
    std::optional<Instant> lastRun = std::nullopt;
    std::optional<Instant> waitsSince = std::nullopt;  // it can run, but did not since then
    bool starvationReported = false;
    bool failureReported = false;
  };
  void runUntilNoneCan(Instant now);
  void reportStarvation(Entry& entry, Instant now);
  void reportFailure(Entry& entry);

  Options options_;
  std::vector<Entry> processes_;
  std::vector<Entry> platforms_;
};

}  // namespace robotlink
