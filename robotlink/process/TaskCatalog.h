// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace robotlink {

/// What a layout may name: the tasks, their solutions, and what each solution needs and yields. Plain data,
/// filled from the registry of solutions (robotlink/debugging) or by a test.
struct TaskCatalog {
  struct Solution {
    std::string name;
    std::string help;
    std::vector<std::string> required;  ///< packages without which it cannot run
    std::vector<std::string> optional;  ///< packages that it uses if somebody offers them
    std::vector<std::string> outputs;
  };
  struct Task {
    std::string name;
    std::string help;
    std::vector<Solution> solutions;
  };
  std::map<std::string, Task> tasks;  ///< by name

  const Task* find(const std::string& task) const;
  const Solution* find(const std::string& task, const std::string& solution) const;
};

}  // namespace robotlink
