// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/RegisteredTasks.h"

#include "robotlink/base/Registrations.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/PackageTypes.h"

namespace robotlink {
namespace {

bool taskPrecedes(const TaskDescription& a, const TaskDescription& b) {
  return a.task < b.task;
}

Registry<TaskDescription>& descriptions() {
  static Registry<TaskDescription> tasks(taskPrecedes);
  return tasks;
}

}  // namespace

const std::vector<TaskDescription>& describedTasks() {
  return descriptions().all();
}

TaskRegistration::TaskRegistration(std::string task, std::string help) {
  const std::string name = "task \"" + task + "\"";
  descriptions().add({std::move(task), std::move(help)}, name, {});
}

TaskCatalog registeredTasks() {
  TaskCatalog catalog;
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    TaskCatalog::Task& task = catalog.tasks[solution.task];
    task.name = solution.task;
    task.solutions.push_back(
        {solution.name, solution.help, solution.required, solution.optional, solution.outputs});
  }
  for (const TaskDescription& described : describedTasks()) {
    const auto task = catalog.tasks.find(described.task);
    if (task != catalog.tasks.end()) task->second.help = described.help;
  }
  return catalog;
}

std::map<std::string, const google::protobuf::Descriptor*> packageTypes() {
  std::map<std::string, const google::protobuf::Descriptor*> types;
  for (const SolutionDescription& solution : SolutionRegistry::all()) {
    for (const auto& [package, descriptor] : solution.types) types.emplace(package, descriptor());
  }
  return types;
}

std::map<std::string, const google::protobuf::Descriptor*> allPackageTypes() {
  auto types = packageTypes();
  types.insert(ownPackageTypes().begin(), ownPackageTypes().end());
  return types;
}

}  // namespace robotlink
