// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/debugging/TaskProcess.h"
#include "robotlink/debugging/program/DebugProcess.h"
#include "robotlink/process/Platform.h"
#include "robotlink/process/ProgramLinks.h"

namespace robotlink {

/// A process layout running on a platform: all of its processes, linked with each other and with the
/// platform. An executor runs them.
///
/// It is built as a whole or refused with all reasons. The platform must outlive it. Its tables (keys,
/// solutions, processes) go to the debug listener after a SendTables request and whenever they change. STOP
/// acts on the platform and does not depend on the program.
///
/// create() touches the platform only when nothing can fail any longer, so a program that already runs on it
/// keeps running after a failure; on success, the platform's links change to the new program. Executors must
/// have released the processes (clear(), ThreadExecutor::stop()) before a program is destroyed; the platform
/// may keep running meanwhile, in another thread.
///
/// It may also be one of several programs that run the processes of the layout together (Layout::Program).
/// Then it has its own processes only; the one with the debug process has the platform, and the `platform` of
/// the others only says which packages that has.
class RobotProgram {
 public:
  /// The part of a layout that this program runs.
  struct Part {
    /// The name of the program in the layout; empty: it runs all processes.
    std::string program = {};
    /// Makes the links to the other programs; must outlive the call of create(). Null if it runs all.
    ProgramLinks* links = nullptr;
  };
  /// Fails with the errors of the layout, of parameter files and of solutions' constructors. `parameters` is
  /// only used during the call.
  static tl::expected<std::unique_ptr<RobotProgram>, Errors> create(RobotSetup robot, Layout layout,
                                                                    Platform& platform,
                                                                    const ParameterSource& parameters) {
    return create(std::move(robot), std::move(layout), platform, parameters, Part());
  }
  static tl::expected<std::unique_ptr<RobotProgram>, Errors> create(RobotSetup robot, Layout layout,
                                                                    Platform& platform,
                                                                    const ParameterSource& parameters,
                                                                    const Part& part);
  ~RobotProgram();

  const RobotSetup& robot() const;
  const Layout& layout() const;
  /// In the order of the layout, including the debug process.
  const std::vector<Process*>& processes() const;
  /// Only if hasDebugProcess(), which only one of several programs has.
  DebugProcess& debugProcess();
  bool hasDebugProcess() const;
  /// The tables of the processes here as they would be if the solutions in `chosenSolutions` (by task) were
  /// active. While no process runs.
  DebugProcess::Tables tables(const std::map<std::string, std::string>& chosenSolutions) const;
  /// Returns the name of a process that decides what the platform does, directly or through others, but does
  /// not answer: it was stopped, such as by an exception, or its program has ended, is another version, or
  /// was out of reach until its links were closed. The robot has to stand then. Empty: all are there.
  /// Only if hasDebugProcess(); any thread.
  std::string missingProcess() const;
  /// Notes the task from which a process does not return, as in "ball-percept (region)", for the program with
  /// the debug process; empty: it has returned. Only without hasDebugProcess(); any thread.
  void noteStuck(const std::string& process, const std::string& task);

  /// All packages that its tasks yield, but not those of the platform or the debug process. Sorted.
  std::vector<std::string> yieldedPackages() const;
  /// Has the same effect as a RecordPackages request to all processes before the first frame. Before it runs.
  void recordPackages(const std::set<std::string>& packages);
  /// Sets modes of debug keys, including those of packages, before the first frame. Unknown keys are ignored.
  /// Before it runs.
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes);
  /// The parameters of all solutions of all tasks, but not of those in other programs. Before it runs.
  std::vector<robotcontrol::ParameterValues> parameters() const;

  /// Stops all processes; the platform is never blocked by their links again. Idempotent.
  void stop();

 private:
  RobotProgram();
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The packages that every debug process sends on behalf of the user.
std::vector<std::string> debugPackages();
bool isDebugPackage(const std::string& package);

}  // namespace robotlink
