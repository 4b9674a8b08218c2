// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/RobotProgram.h"

namespace robotlink {

TaskCatalog registeredTasks() {
  TaskCatalog catalog;
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    TaskCatalog::Task& task = catalog.tasks[solution.task];
    task.name = solution.task;
    task.solutions.push_back(
        {solution.name, solution.help, solution.required, solution.optional, solution.outputs});
  }
  return catalog;
}

}  // namespace robotlink
