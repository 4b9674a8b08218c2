// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Platform.h"

namespace robotlink {

/// Runs processes and their platforms in turn in the caller's thread. Time is the platforms' time, so the
/// same inputs give the same bytes at any speed.
///
/// In a step, every process that may enter phase 2 runs, in the order of add(), at most once per instant,
/// until none can. Then the platforms step: all actuate, the world that they share advances its clock, all
/// send their sensor data. The clock of the first platform counts; without a platform no process runs. A
/// process that has not run for `starvation` plus its period is reported once, with what it waits for, until
/// it runs again. Processes and platforms must outlive the executor or be removed with clear(). One thread at
/// a time.
class LockstepExecutor {
 public:
  struct Options {
    /// How long a process may wait, in the platform's time, before it is reported.
    Duration starvation = std::chrono::seconds(2);
    /// Advances the platforms' world and its clock; may be empty.
    std::function<void()> advance;
    /// Called by step() with a text such as "package camera/image of simulation".
    std::function<void(const Process&, const std::string&)> onStarved;
    /// Called by step() when a process or platform has thrown and was stopped.
    std::function<void(const Process&)> onFailed;
  };

  explicit LockstepExecutor(Options options);
  void add(Process& process) { processes_.push_back({.process = &process}); }
  void add(Platform& platform) { platforms_.push_back({.process = &platform, .platform = &platform}); }
  /// Removes all processes and platforms.
  void clear();

  /// runProcesses(), then stepPlatforms().
  void step();
  /// The first half of a step: runs processes until none can run.
  void runProcesses();
  /// The same at an instant of an executor that has no platforms.
  void runProcesses(Instant now);
  /// The second half of a step. A caller that begins with this half, such as a log player, sees what the
  /// processes compute from the new instant.
  void stepPlatforms();

 private:
  /// A process with its state in the lockstep; `platform` is null for ordinary processes.
  struct Entry {
    Process* process;
    Platform* platform = nullptr;
    std::optional<Instant> lastRun = std::nullopt;
    /// The instant since which it could have run but did not.
    std::optional<Instant> waitsSince = std::nullopt;
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
