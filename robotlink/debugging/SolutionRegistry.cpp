// SPDX-License-Identifier: GPL-3.0-or-later
// SolutionRegistry and SolutionRegistration of Solution.h.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <tuple>

#include "robotlink/debugging/Solution.h"

namespace robotlink {
namespace {

// By task and name, so that nothing depends on the order in which files are linked.
std::vector<SolutionDescription>& solutions() {
  static std::vector<SolutionDescription> solutions;
  return solutions;
}

bool before(const SolutionDescription& a, const SolutionDescription& b) {
  return std::tie(a.task, a.name) < std::tie(b.task, b.name);
}

[[noreturn]] void refuseSolution(const SolutionDescription& solution, const char* why) {
  std::fprintf(stderr, "solution \"%s\" of task \"%s\": %s\n", solution.name.c_str(), solution.task.c_str(),
               why);
  std::abort();
}

}  // namespace

const std::vector<SolutionDescription>& SolutionRegistry::all() {
  return solutions();
}

const SolutionDescription* SolutionRegistry::find(const std::string& task, const std::string& solution) {
  const auto& all = solutions();
  const auto found = std::lower_bound(all.begin(), all.end(), std::tie(task, solution),
                                      [](const SolutionDescription& entry, const auto& wanted) {
                                        return std::tie(entry.task, entry.name) < wanted;
                                      });
  return found != all.end() && found->task == task && found->name == solution ? &*found : nullptr;
}

SolutionRegistration::SolutionRegistration(SolutionDescription description) {
  if (description.task.empty() || description.name.empty())
    refuseSolution(description, "task and solution need names");
  for (const int key : description.keys) {
    if (key < 0)
      refuseSolution(description,
                     "names a debug key that is declared in another file; declare its keys above it");
  }
  if (SolutionRegistry::find(description.task, description.name)) {
    refuseSolution(description, "registered twice; names of solutions are unique in a task");
  }
  auto& all = solutions();
  all.insert(std::upper_bound(all.begin(), all.end(), description, before), std::move(description));
}

}  // namespace robotlink
