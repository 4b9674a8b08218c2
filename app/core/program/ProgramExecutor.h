// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/program/TurnCrew.h"
#include "robotlink/base/threads/ThreadPool.h"
#include "robotlink/process/LockstepExecutor.h"
#include "robotlink/process/ThreadExecutor.h"

namespace app {

/// The execution of the processes of the programs: in turn, or in parallel.
enum class ExecutorKind : std::uint8_t { kLockstep, kThreads };
/// The name that is logged in ProgramSetup.executor: "lockstep" or "threads".
const char* nameOf(ExecutorKind kind);

/// The task that a process executes: "ball-percept (region)"; "its program" if that is not known.
std::string taskOf(const robotlink::Process& process);

/// The text about a process that has thrown, before the reason: "Process cognition was stopped ...".
inline constexpr char kStoppedText[] = "was stopped because it threw: ";

/// Executes the programs of all robots of one world together with their platforms: either in lockstep, each
/// process in turn, or each process in a thread of its own, with the platforms stepped by the caller.
///
/// In lockstep the processes of a robot take turns, one robot after the other, or, since robots' programs do
/// not know each other, those of several robots at once, with the same results; the caller waits.
///
/// With a `patience`, a frame that does not return within it keeps nothing but the program of its robot. One
/// thread at a time; `trouble` may be called in other threads.
class ProgramExecutor {
 public:
  /// The settings of an executor.
  struct Options {
    ExecutorKind kind = ExecutorKind::kLockstep;
    /// Advances the world by one step, between actuation and sensing.
    std::function<void()> advance = [] {};
    /// In lockstep, called when all processes of a step have run, with the real time that they took.
    std::function<void(robotlink::Duration took)> ran = [](robotlink::Duration) {};
    /// In lockstep, the threads that share the robots' programs; null: one does. With a patience the programs
    /// run in as many threads of their own.
    std::shared_ptr<robotlink::ThreadPool> pool = nullptr;
    /// The way in which those threads wait for each other.
    TurnCrew::Waiting waiting = TurnCrew::Waiting::kAlert;
    /// Called if something is wrong with a process, with the rest of a sentence: "was stopped because it
    /// threw: ...". Must not be empty.
    std::function<void(const robotlink::Process& process, const std::string& text)> trouble;
    /// The time that a frame may last, in real time, before it counts as not returning; 0: forever.
    std::chrono::milliseconds patience{0};
    /// Ends that time early in lockstep, such as for STOP; null: nothing does.
    std::shared_ptr<const ModulePatience> cut = nullptr;
    /// Called by step() for a platform whose program has such a frame, with what does not return, as in
    /// "ball-percept (region) of process cognition"; and with an empty text when it has returned.
    std::function<void(const robotlink::Platform& platform, const std::string& what)> stuck = {};
    /// With threads, called in the thread of each process before its first frame.
    std::function<void(const robotlink::Process& process)> started = {};
  };
  explicit ProgramExecutor(Options options);
  /// Stops the threads of all processes and waits for them.
  ~ProgramExecutor();

  ExecutorKind kind() const { return options_.kind; }
  /// Adds a robot before start(): its platform and its processes, in the order of their execution. All must
  /// outlive this object. Processes that wait for others with a patience of their own are not guarded; those
  /// that stand for a remote program are executed by step() itself, also where others have threads.
  enum class Guard : std::uint8_t { kNo, kYes, kStandIn };
  void add(robotlink::Platform& platform, const std::vector<robotlink::Process*>& processes,
           Guard guard = Guard::kYes);
  /// Starts the threads, if there are any; call this once, after all add().
  void start();
  /// Makes one step: the platforms actuate, the world advances, the platforms send their sensor data. In
  /// lockstep, all processes that can run do so first.
  void step();
  /// The same with the platforms first, so that the processes compute from the present sensor data. Only in
  /// lockstep.
  void stepFromSensors();
  /// Whether the program of a platform has a frame that does not return.
  bool isStuck(const robotlink::Platform& platform) const;

  /// Stops all processes, and waits for their frames for a moment, for all together. Returns false if some
  /// have not returned: this object, their programs and platforms, and the world must exist until hasEnded().
  /// Nothing is called afterward.
  bool stop();
  bool hasEnded() const;
  /// Whether the frames of the processes of one platform have returned.
  bool hasEnded(const robotlink::Platform& platform) const;

 private:
  /// A robot.
  struct Team {
    robotlink::Platform* platform = nullptr;
    std::vector<robotlink::Process*> processes;
    /// Only in lockstep, and for stand-ins.
    std::unique_ptr<robotlink::LockstepExecutor> lockstep = nullptr;
    /// Its processes may run in other threads than the caller's.
    bool takesTurns = false;
    bool isStuck = false;
  };
  robotlink::LockstepExecutor::Options lockstepOptions() const;
  /// A step with threads: the platforms' part only.
  void stepPlatforms();
  /// The processes' part of a step in lockstep.
  void runProcesses();
  void takeTurns();
  /// Whether turns are given up that take too long; then a crew makes them.
  bool isPatient() const { return lockstep_ && options_.patience.count() > 0; }
  void makeCrew();
  /// In any thread.
  void takeTurn(std::size_t team);
  bool hasEnded(std::size_t team) const;
  bool isBusy(std::size_t team) const;
  /// Looks for frames in threads that do not return, and for those that have.
  void watchThreads();
  void setStuck(Team& team, bool isStuck, const robotlink::Process* process);

  const Options options_;
  const std::shared_ptr<const ModulePatience> patience_;
  std::vector<std::unique_ptr<Team>> teams_;
  /// Shared with callbacks: nothing is reported after stop().
  const std::shared_ptr<std::atomic<bool>> isMuted_ = std::make_shared<std::atomic<bool>>(false);
  /// One of the two executors is null, depending on the kind.
  std::unique_ptr<robotlink::LockstepExecutor> lockstep_;
  std::unique_ptr<robotlink::ThreadExecutor> threads_;
  /// Null before the first turn, and if processes run in the caller's thread, or all in their own. The last
  /// member, since it uses the teams.
  std::unique_ptr<TurnCrew> crew_;
};

}  // namespace app
