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

namespace robotlink {

/// A process of a layout: runs its tasks in order, each by the solution that is chosen for it.
///
/// Requests (debug keys, solutions, parameters) arrive with the package "debug/requests/<process>" and take
/// effect at the start of a frame, all at once; refusals name their reason. What the process tells leaves it
/// as "debug/queue/<process>" whenever the last queue was taken. The setup must outlive it.
class TaskProcess final : public Process {
 public:
  struct Setup {
    const RobotSetup& robot;
    const Layout& layout;
    const Layout::Process& process;
    PlatformPackages platform;
    const ParameterSource& parameters;  ///< looked at only while it is made
  };

  /// Creates the default solutions of its tasks; fails if one cannot be created or its parameters cannot be
  /// read.
  static tl::expected<std::unique_ptr<TaskProcess>, Errors> create(const Setup& setup, const Clock& clock);
  ~TaskProcess() override;

  DebugContext& debug();
  /// Before it runs: as if it had been asked by RecordPackages, from the first frame on.
  void recordPackages(const std::set<std::string>& packages);
  /// Before it runs: modes of debug keys, of packages too, from the first frame on. Unknown ones are ignored.
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes);
  /// What all of its solutions have for parameters. Before it runs.
  std::vector<robotcontrol::ParameterValues> parameters() const;
  /// Which solution a task uses now. Only while the process does not run, or from its own thread.
  std::string activeSolution(const std::string& task) const;

  // What it would do if it were asked, for those who must know before its next frame. Only while the process
  // does not run.
  /// Why a solution could not be switched to; nothing is switched.
  Result<void> trySolution(const std::string& task, const std::string& solution) const;
  /// The parameters of a solution; of the active one if `solution` is empty. Null if there is no such task or
  /// solution.
  const SolutionParameters* solutionParameters(const std::string& task, const std::string& solution) const;
  /// Its tables of keys and solutions, if tasks used these solutions instead of theirs.
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
