// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "robotlink/debugging/PackageBoard.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/SolutionParameters.h"

namespace robotcontrol {
class StopwatchTimes;
}

namespace robotlink {

/// A task of a process: its solutions with their parameters, the active one, and those that run in its
/// shadow: on the same inputs, with debug messages of their own, but without being used. A package is new to
/// a solution if it arrived since the solution last ran. Used by the process's thread; internal to this
/// folder.
class TaskRunner {
 public:
  /// The task's surroundings; everything referred to must outlive it.
  struct Environment {
    const RobotSetup& robot;
    const Clock& clock;
    DebugContext& debug;
    PackageBoard& board;
    /// Packages that its solutions do not send to others.
    const std::set<std::string>& withheld;
    /// The slot in which the task notes its activity (Process::activity()); may be null.
    std::atomic<const std::string*>* activity = nullptr;
  };

  TaskRunner(std::string task, const Environment& environment);
  ~TaskRunner();
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  const std::string& task() const { return task_; }
  const std::string& active() const { return active_; }
  const std::vector<const SolutionDescription*>& solutions() const { return solutions_; }
  /// Null if there is no such solution.
  SolutionParameters* parameters(const std::string& solution);
  const SolutionParameters* parameters(const std::string& solution) const;

  /// Loads the parameters of all solutions. A file of an unknown solution is an error, too.
  Errors loadParameters(const ParameterSource& source);
  /// Constructs the solution and only then destroys the previous one; if the constructor throws, nothing
  /// changes.
  Result<void> select(const std::string& solution);
  /// Whether select() would succeed now: constructs a solution whose debug messages and packages go nowhere,
  /// and destroys it.
  Result<void> trySolution(const std::string& solution) const;
  /// Runs the active solution once, then the shadows that are due; adds task and solution to the text of the
  /// exceptions of the active one. A shadow that throws is switched off. Adds how long each took to `times`
  /// unless that is null.
  void execute(robotcontrol::StopwatchTimes* times = nullptr);

  /// Sets in which frames a solution runs in the shadow of the active one. It is constructed when it is
  /// switched on, pauses while it is the active one itself, and is destroyed when it is switched off. Fails
  /// without changing anything if it cannot be constructed.
  Result<void> setShadow(const std::string& solution, const robotcontrol::KeyMode& mode);
  robotcontrol::KeyMode shadowMode(const std::string& solution) const;
  /// Sets the mode of a debug key for all shadows, whose counters are their own.
  void setKey(int key, const robotcontrol::KeyMode& mode);
  /// Whether a shadow has ended by itself since the last call.
  bool takeShadowEnd() { return std::exchange(shadowEnded_, false); }

 private:
  struct TaskInput {
    PackageBoard::Entry* entry;
    /// The value of `arrivals` when the task last ran.
    std::uint64_t seen = 0;
    PackageSlot slot;
  };
  /// Keyed by package.
  using TaskInputs = std::map<std::string, TaskInput>;
  class Context;
  struct Shadow;

  Result<const SolutionDescription*> known(const std::string& solution) const;
  Result<std::unique_ptr<Solution>> make(const SolutionDescription& solution, Context& context) const;
  void takeRecorded(const ParameterSource& source);
  /// The inputs of all solutions of the task, none of which has been seen.
  TaskInputs unseenInputs() const;
  static void refresh(TaskInputs& inputs);
  void executeActive();
  void executeShadow(Shadow& shadow);
  /// Errors about parameter files whose solution does not exist, probably because of a typing error.
  Errors filesOfNoSolution(const std::filesystem::path& folder) const;

  /// Notes, while it exists, that code of a solution runs.
  class Busy;

  const std::string task_;
  Environment environment_;
  std::vector<const SolutionDescription*> solutions_;
  /// Keyed by solution.
  std::map<std::string, SolutionParameters> parameters_;
  /// The texts of Process::activity() while a solution runs, by solution.
  std::map<std::string, std::string> activities_;
  TaskInputs inputs_;
  std::string active_;
  /// Declared before solution_ so that it outlives it.
  std::unique_ptr<Context> context_;
  std::unique_ptr<Solution> solution_;
  /// The shadows that run, keyed by solution.
  std::map<std::string, std::unique_ptr<Shadow>> shadows_;
  bool shadowEnded_ = false;
};

}  // namespace robotlink
