// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "robotlink/debugging/DebugProcess.h"
#include "robotlink/debugging/TaskProcess.h"
#include "robotlink/process/Platform.h"

namespace robotlink {

/// A process layout put on a platform: all of its processes, linked with each other and with the platform. An
/// executor runs them.
///
/// Built as a whole or refused with all reasons. The platform must outlive it. Its tables (keys, solutions,
/// processes) are sent to the debug listener after a SendTables request and whenever they change; STOP never
/// passes through here.
///
/// create() touches the platform only when nothing can be refused any more, so that a program that runs on it
/// goes on; from then on the platform obeys the new one. Executors must have let go of the processes
/// (clear(), ThreadExecutor::stop()) before a program is destroyed; the platform may go on meanwhile, in
/// another thread.
class RobotProgram {
 public:
  static tl::expected<std::unique_ptr<RobotProgram>, Errors> create(RobotSetup robot, Layout layout,
                                                                    Platform& platform,
                                                                    const ParameterSource& parameters);
  ~RobotProgram();

  const RobotSetup& robot() const;
  const Layout& layout() const;
  /// In the order of the layout, the debug process among them.
  const std::vector<Process*>& processes() const;
  DebugProcess& debugProcess();

  /// The packages that its tasks yield: those of the platform and of the debug process are told by these.
  std::vector<std::string> yieldedPackages() const;
  /// Before it runs: as if all processes had been asked by RecordPackages, from the first frame on.
  void recordPackages(const std::set<std::string>& packages);
  /// Before it runs: modes of debug keys, of packages too, from the first frame on. Unknown ones are ignored.
  void setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes);
  /// What the solutions of all tasks have for parameters. Before it runs.
  std::vector<robotcontrol::ParameterValues> parameters() const;

  /// Stops all processes; their links to the platform never hold it back from now on. Idempotent.
  void stop();

 private:
  RobotProgram();
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The packages that every debug process offers: a person's wishes.
std::vector<std::string> debugPackages();
bool isDebugPackage(const std::string& package);

}  // namespace robotlink
