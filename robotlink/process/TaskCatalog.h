// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace robotlink {

/// The tasks and solutions that a layout may name, and the packages that each solution needs and yields.
/// Plain data, filled from the registry of solutions (robotlink/debugging) or by a test. Names are those of
/// layout files: "ball-percept", "region".
struct TaskCatalog {
  /// A way to do a task.
  struct Solution {
    std::string name;
    std::string help;
    /// Packages without which it cannot run.
    std::vector<std::string> required;
    /// Packages that it uses if they are offered.
    std::vector<std::string> optional;
    /// Packages that it yields.
    std::vector<std::string> outputs;
  };
  /// A task with all its solutions.
  struct Task {
    std::string name;
    std::string help;
    std::vector<Solution> solutions;
  };
  /// Keyed by name.
  std::map<std::string, Task> tasks;

  /// Null if there is no such task or solution.
  const Task* find(const std::string& task) const;
  const Solution* find(const std::string& task, const std::string& solution) const;
};

}  // namespace robotlink
