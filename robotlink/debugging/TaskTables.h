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

/// The stopwatches of all processes.
extern const DebugKey kTimingKey;

using TaskRunners = std::vector<std::unique_ptr<TaskRunner>>;

/// The keys of all solutions of a process's tasks, those of packages that it shows on request, and the
/// stopwatches'. `chosen`: solutions that tasks are to use from the next frame on, by task.
void fillKeyTable(const TaskRunners& tasks, const PackageBoard& board, const DebugContext& debug,
                  robotcontrol::KeyTable& to, const std::map<std::string, std::string>& chosen = {});
/// The key of one package that is shown on request.
void fillPackageKey(const std::string& package, const robotcontrol::KeyMode& mode,
                    robotcontrol::KeyTable_Key& to);
/// The process's tasks with their solutions.
void fillSolutionTable(const std::string& process, const TaskRunners& tasks, const Layout& layout,
                       const TaskCatalog& catalog, const PlatformPackages& platform,
                       robotcontrol::SolutionTable& to);

/// Tasks that no process does, with all their solutions and why none can be chosen.
void addAbsentTasks(const std::vector<Layout::Absence>& absent, robotcontrol::SolutionTable& to);

}  // namespace robotlink
