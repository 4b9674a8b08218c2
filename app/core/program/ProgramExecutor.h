// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/process/ThreadExecutor.h"

namespace robotlink {
class RobotProgram;
}

namespace app {

enum class ExecutorKind : std::uint8_t { kLockstep, kThreads };
/// The word for it in the set-up of a logged program: "lockstep" or "threads".
const char* nameOf(ExecutorKind kind);

/// Runs the programs of the robots of one world with their platforms: one process after the other in lockstep
/// with the world, or each process in a thread of its own, while its owner steps the platforms. One thread at
/// a time; whoever is told of trouble is told in the processes' threads.
class ProgramExecutor {
 public:
  struct Options {
    ExecutorKind kind = ExecutorKind::kLockstep;
    std::function<void()> advance = [] {};  ///< moves the world on by one step
    /// What is wrong with a process: "was stopped because it threw: ...".
    std::function<void(const robotlink::Process& process, const std::string& text)> trouble;
  };
  explicit ProgramExecutor(Options options);
  ~ProgramExecutor();

  ExecutorKind kind() const { return options_.kind; }
  /// Platforms and programs must outlive it.
  void add(robotlink::Platform& platform, robotlink::RobotProgram& program);
  /// Once, when all are added.
  void start();
  /// The platforms move their actuators, the world moves on, the platforms send their sensors; in lockstep,
  /// all processes that this lets run, run.
  void step();

 private:
  void stepPlatforms();

  const Options options_;
  std::vector<robotlink::Platform*> platforms_;  // with threads
  std::unique_ptr<robotlink::LockstepExecutor> lockstep_;
  std::unique_ptr<robotlink::ThreadExecutor> threads_;
};

}  // namespace app
