// SPDX-License-Identifier: GPL-3.0-or-later
// SolutionRegistry and SolutionRegistration of Solution.h.
#include <algorithm>
#include <tuple>

#include "robotlink/base/Registrations.h"
#include "robotlink/debugging/Solution.h"

namespace robotlink {
namespace {

bool precedes(const SolutionDescription& a, const SolutionDescription& b) {
  return std::tie(a.task, a.name) < std::tie(b.task, b.name);
}

Registry<SolutionDescription>& solutions() {
  static Registry<SolutionDescription> solutions(precedes);
  return solutions;
}

/// Empty if the solution can be registered.
std::string problemOf(const SolutionDescription& solution) {
  if (solution.task.empty() || solution.name.empty()) return "task and solution need names";
  if (std::ranges::any_of(solution.keys, [](int key) { return key < 0; }))
    return "names a debug key that is declared in another file; declare its keys above it";
  return SolutionRegistry::find(solution.task, solution.name) != nullptr
             ? "registered twice; names of solutions are unique in a task"
             : "";
}

}  // namespace

const std::vector<SolutionDescription>& SolutionRegistry::all() {
  return solutions().all();
}

const SolutionDescription* SolutionRegistry::find(const std::string& task, const std::string& solution) {
  const auto& all = SolutionRegistry::all();
  const auto found = std::lower_bound(all.begin(), all.end(), std::tie(task, solution),
                                      [](const SolutionDescription& entry, const auto& wanted) {
                                        return std::tie(entry.task, entry.name) < wanted;
                                      });
  return found != all.end() && found->task == task && found->name == solution ? &*found : nullptr;
}

SolutionRegistration::SolutionRegistration(SolutionDescription description) {
  const std::string name = "solution \"" + description.name + "\" of task \"" + description.task + "\"";
  const std::string problem = problemOf(description);
  solutions().add(std::move(description), name, problem);
}

}  // namespace robotlink
