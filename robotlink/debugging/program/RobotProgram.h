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

namespace robotlink {

/// A process layout running on a platform: all of its processes, linked with each other and with the
/// platform. An executor runs them.
///
/// It is built as a whole or refused with all reasons. The platform must outlive it. Its tables (keys,
/// solutions, processes) go to the debug listener after a SendTables request and whenever they change. STOP
/// acts on the platform and does not depend on the program.
///
/// create() touches the platform only when nothing can fail any more, so a program that already runs on it
/// keeps running after a failure; on success, the platform's links change to the new program. Executors must
/// have released the processes (clear(), ThreadExecutor::stop()) before a program is destroyed; the platform
/// may keep running meanwhile, in another thread.
class RobotProgram {
 public:
  /// Fails with the errors of the layout, of parameter files and of solutions' constructors. `parameters` is
  /// only used during the call.
  static tl::expected<std::unique_ptr<RobotProgram>, Errors> create(RobotSetup robot, Layout layout,
                                                                    Platform& platform,
                                                                    const ParameterSource& parameters);
  ~RobotProgram();

  const RobotSetup& robot() const;
  const Layout& layout() const;
  /// In the order of the layout, including the debug process.
  const std::vector<Process*>& processes() const;
  DebugProcess& debugProcess();

  /// All packages that its tasks yield, but not those of the platform or the debug process. Sorted.
  std::vector<std::string> yieldedPackages() const;
  /// Has the same effect as a RecordPackages request to all processes before the first frame. Before it runs.
  void recordPackages(const std::set<std::string>& packages);
  /// Sets modes of debug keys, including those of packages, before the first frame. Unknown keys are ignored.
  /// Before it runs.
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes);
  /// The parameters of all solutions of all tasks. Before it runs.
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
