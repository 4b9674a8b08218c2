// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "robotlink/process/Layout.h"

namespace robotlink {

/// Which process of a layout answers for what: where requests go. A plain value, derived from a layout.
struct DebugRoutes {
  struct TaskList {
    std::string process;
    std::vector<std::string> tasks;
  };
  std::vector<TaskList> processes;              ///< without the debug process, in the layout's order
  std::vector<Layout::Absence> absent;          ///< tasks that no process does
  std::map<std::string, std::string> packages;  ///< package: the process that shows it on request

  /// The process that does a task; empty if none does.
  std::string processOf(const std::string& task) const;
};

/// A package is shown on request by the process that yields it; one of the platform or of the debug process
/// by the first process that receives it.
DebugRoutes debugRoutes(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

/// The key by which a package is asked for: "package/camera/image".
std::string packageKey(const std::string& package);
/// The package that a key asks for; empty if it is no such key.
std::string packageOfKey(const std::string& key);

}  // namespace robotlink
