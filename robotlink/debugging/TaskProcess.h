// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/debugging/SolutionParameters.h"
#include "robotlink/process/Layout.h"
#include "robotlink/process/Process.h"

namespace robotcontrol {
class Request;
}

namespace robotlink {

/// A process of a layout that runs its tasks in order, each with the solution that is selected for it.
///
/// Requests (debug keys, solutions, parameters) arrive with the package "debug/requests/<process>" and are
/// applied together at the start of a frame; a refusal contains the reason. Debug messages leave it with the
/// package "debug/queue/<process>" whenever the previous queue was acknowledged. The robot setup and the
/// layout must outlive it.
class TaskProcess final : public Process {
 public:
  /// The arguments of create().
  struct Setup {
    const RobotSetup& robot;
    const Layout& layout;
    const Layout::Process& process;
    PlatformPackages platform;
    /// Only used during create().
    const ParameterSource& parameters;
  };

  /// Constructs the initial solutions of its tasks; fails if one cannot be constructed or its parameters
  /// cannot be read.
  static tl::expected<std::unique_ptr<TaskProcess>, Errors> create(const Setup& setup, const Clock& clock);
  ~TaskProcess() override;

  /// Whether there is a handler for requests of this kind.
  static bool fulfills(const robotcontrol::Request& request);

  /// Has the same effect as a RecordPackages request before the first frame. Before it runs.
  void recordPackages(const std::set<std::string>& packages);
  /// Sets modes of debug keys, including those of packages, before the first frame. Unknown keys are ignored.
  /// Before it runs.
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes);
  /// The parameters of all solutions of its tasks. Before it runs.
  std::vector<robotcontrol::ParameterValues> parameters() const;
  /// The solution that a task uses now. Only while the process does not run, or from its own thread.
  std::string activeSolution(const std::string& task) const;

  // Previews of requests, for results that are needed before the next frame. Only while the process does not
  // run.
  /// Whether a solution can be selected; the error says why not. Constructs and destroys one, but changes
  /// nothing.
  Result<void> trySolution(const std::string& task, const std::string& solution) const;
  /// The parameters of a solution, or of the active one if `solution` is empty. Null if there is no such task
  /// or solution.
  const SolutionParameters* solutionParameters(const std::string& task, const std::string& solution) const;
  /// Whether a value of a user can replace a package in this process (SetPackage). Any time.
  bool canSet(const std::string& package) const;
  /// The newest value of a package that this process publishes on request; null: there is none yet, or
  /// another process publishes it.
  PackagePtr newest(const std::string& package) const;
  /// The tables of keys and solutions as they would be if the solutions in `chosen` (by task) were active.
  void describe(const std::map<std::string, std::string>& chosen, robotcontrol::KeyTable& keys,
                robotcontrol::SolutionTable& solutions) const;

 protected:
  void execute() override;

 private:
  struct Implementation;
  TaskProcess(const Setup& setup, const Clock& clock);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace robotlink
