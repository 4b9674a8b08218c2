// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/debugging/DebugKey.h"
#include "robotlink/debugging/TaskRunner.h"
#include "robotlink/process/Layout.h"

namespace robotcontrol {
class KeyMode;
class KeyTable;
class KeyTable_Key;
class SolutionTable;
}  // namespace robotcontrol

namespace robotlink {

/// The debug key of the stopwatches of all processes.
extern const StopwatchKey kTimingKey;

using TaskRunners = std::vector<std::unique_ptr<TaskRunner>>;

/// Adds the keys of all solutions of a process's tasks, those of the packages that it publishes on request,
/// and that of the stopwatches. `chosen` overrides the active solutions, by task.
void fillKeyTable(const TaskRunners& tasks, const PackageBoard& board, const DebugContext& debug,
                  robotcontrol::KeyTable& to, const std::map<std::string, std::string>& chosen = {});
/// Describes the key of one package that is published on request.
void fillPackageKey(const std::string& package, const robotcontrol::KeyMode& mode,
                    robotcontrol::KeyTable_Key& to);
/// Adds the process's tasks with their solutions, and why a solution is unavailable.
void fillSolutionTable(const std::string& process, const TaskRunners& tasks, const Layout& layout,
                       const TaskCatalog& catalog, const PlatformPackages& platform,
                       robotcontrol::SolutionTable& to);

/// Adds the tasks that no process runs, with all their solutions and why none can be selected.
void addAbsentTasks(const std::vector<Layout::Absence>& absent, robotcontrol::SolutionTable& to);

}  // namespace robotlink
