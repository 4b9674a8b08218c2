// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/process/ThreadExecutor.h"

namespace app {

/// How the processes of the programs are executed: in turn, or in parallel.
enum class ExecutorKind : std::uint8_t { kLockstep, kThreads };
/// The name that is logged in ProgramSetup.executor: "lockstep" or "threads".
const char* nameOf(ExecutorKind kind);

/// Executes the programs of all robots of one world together with their platforms: either in lockstep, each
/// process in turn in the caller's thread, or each process in a thread of its own, with the platforms stepped
/// by the caller. One thread at a time; with threads, `trouble` is called in the threads of the processes.
class ProgramExecutor {
 public:
  /// The settings of an executor.
  struct Options {
    ExecutorKind kind = ExecutorKind::kLockstep;
    /// Advances the world by one step, between actuation and sensing.
    std::function<void()> advance = [] {};
    /// Called if something is wrong with a process, with the rest of a sentence: "was stopped because it
    /// threw: ...". Must not be empty.
    std::function<void(const robotlink::Process& process, const std::string& text)> trouble;
  };
  explicit ProgramExecutor(Options options);
  /// Stops the threads of all processes and waits for them.
  ~ProgramExecutor();

  ExecutorKind kind() const { return options_.kind; }
  /// Adds a robot before start(): its platform and its processes, in the order of their execution. All must
  /// outlive this object.
  void add(robotlink::Platform& platform, const std::vector<robotlink::Process*>& processes);
  /// Starts the threads, if there are any; to be called once, after all add().
  void start();
  /// Makes one step: the platforms actuate, the world advances, the platforms send their sensor data. In
  /// lockstep, all processes that can run do so first.
  void step();
  /// The same with the platforms first, so that the processes compute from the present sensor data. Only in
  /// lockstep.
  void stepFromSensors();

 private:
  /// A step with threads: the platforms' part only.
  void stepPlatforms();

  const Options options_;
  /// Only with threads; the lockstep executor has its own list.
  std::vector<robotlink::Platform*> platforms_;
  /// One of the two is null, depending on the kind.
  std::unique_ptr<robotlink::LockstepExecutor> lockstep_;
  std::unique_ptr<robotlink::ThreadExecutor> threads_;
};

}  // namespace app
