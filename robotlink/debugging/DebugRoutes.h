// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/process/Layout.h"

namespace robotlink {

/// For each task and package, the process that handles requests about it, and the robot's joints. A plain
/// value.
struct DebugRoutes {
  /// A process and its tasks.
  struct TaskList {
    std::string process;
    std::vector<std::string> tasks;
  };
  /// All processes but the debug process, in the layout's order.
  std::vector<TaskList> processes;
  /// Tasks that no process runs.
  std::vector<Layout::Absence> absent;
  /// Package to the process that publishes it on request.
  std::map<std::string, std::string> packages;
  /// The robot's joints, the columns of its key-frame motions.
  std::vector<std::string> joints;

  /// The process that runs a task; empty if none does.
  std::string processOf(const std::string& task) const;
};

/// A package is published on request by the process that yields it; a package of the platform or of the debug
/// process by the first process that receives it.
DebugRoutes debugRoutes(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform);

/// The debug key by which a package is requested: "package/camera/image".
std::string packageKey(const std::string& package);
/// The package that a key requests; empty if the key is not for a package.
std::string packageOfKey(const std::string& key);

/// A solution that runs in the shadow of the active one of its task: on the same inputs, without being used.
struct ShadowName {
  std::string task;
  std::string solution;
  bool operator==(const ShadowName&) const = default;
};
/// The debug key by which a solution runs in the shadow of the active one: "shadow/ball-model/kalman".
std::string shadowKey(const std::string& task, const std::string& solution);
/// Returns the solution that a key runs in shadow mode; nothing if the key is not for that.
std::optional<ShadowName> shadowOfKey(const std::string& key);
/// The prefix of the paths of what a solution publishes in shadow mode, "shadow/kalman/"; the path on which
/// it would publish it otherwise follows.
std::string shadowPrefix(const std::string& solution);

}  // namespace robotlink
