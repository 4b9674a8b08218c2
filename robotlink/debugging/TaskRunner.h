// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/debugging/PackageBoard.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/SolutionParameters.h"

namespace robotlink {

/// One task of a process: its solutions with their parameters, and the one that runs. A task sees a package
/// as new if it came since the task ran last. Used by the process's thread; only for this folder.
class TaskRunner {
 public:
  struct Environment {
    const RobotSetup& robot;
    const Clock& clock;
    DebugContext& debug;
    PackageBoard& board;
    const std::set<std::string>& withheld;  // packages that its solutions keep to themselves
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

  Errors loadParameters(const ParameterSource& source);
  /// Makes a new object of the solution and only then destroys the one before; if its constructor throws,
  /// nothing changes.
  Result<void> select(const std::string& solution);
  /// Whether select() would do it now: makes such an object, and destroys it without anybody having heard of
  /// it.
  Result<void> trySolution(const std::string& solution) const;
  void execute();

 private:
  struct TaskInput {
    PackageBoard::Entry* entry;
    std::uint64_t seen = 0;  // arrivals when the task ran last
    PackageSlot slot;
  };
  class Context;

  Result<const SolutionDescription*> known(const std::string& solution) const;
  Result<std::unique_ptr<Solution>> make(const SolutionDescription& solution, Context& context) const;
  void takeRecorded(const ParameterSource& source);
  void refreshInputs();
  Errors filesOfNoSolution(const std::filesystem::path& folder) const;

  const std::string task_;
  Environment environment_;
  std::vector<const SolutionDescription*> solutions_;
  std::map<std::string, SolutionParameters> parameters_;  // by solution
  std::map<std::string, TaskInput> inputs_;               // by package
  std::string active_;
  std::unique_ptr<Context> context_;  // outlives solution_
  std::unique_ptr<Solution> solution_;
};

}  // namespace robotlink
