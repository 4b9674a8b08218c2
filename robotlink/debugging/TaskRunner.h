// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/debugging/PackageBoard.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/SolutionParameters.h"

namespace robotlink {

/// One task of a process: its solutions with their parameters, and the active one. A package is new to a task
/// if it arrived since the task last ran. Used by the process's thread; internal to this folder.
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
    /// Where it notes what it does (Process::activity()); may be null.
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
  /// Runs the active solution once; adds task and solution to the text of its exceptions.
  void execute();

 private:
  struct TaskInput {
    PackageBoard::Entry* entry;
    /// The value of `arrivals` when the task last ran.
    std::uint64_t seen = 0;
    PackageSlot slot;
  };
  class Context;

  Result<const SolutionDescription*> known(const std::string& solution) const;
  Result<std::unique_ptr<Solution>> make(const SolutionDescription& solution, Context& context) const;
  void takeRecorded(const ParameterSource& source);
  void refreshInputs();
  /// Errors about parameter files whose solution does not exist, probably because of a typing error.
  Errors filesOfNoSolution(const std::filesystem::path& folder) const;

  /// Notes, while it exists, that code of a solution runs.
  class Busy;

  const std::string task_;
  Environment environment_;
  std::vector<const SolutionDescription*> solutions_;
  /// Keyed by solution.
  std::map<std::string, SolutionParameters> parameters_;
  /// What Process::activity() returns while a solution runs, by solution.
  std::map<std::string, std::string> activities_;
  /// Keyed by package.
  std::map<std::string, TaskInput> inputs_;
  std::string active_;
  /// Declared before solution_ so that it outlives it.
  std::unique_ptr<Context> context_;
  std::unique_ptr<Solution> solution_;
};

}  // namespace robotlink
