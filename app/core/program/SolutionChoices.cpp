// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/SolutionChoices.h"

#include <algorithm>
#include <set>

#include "robotlink/debugging/Solution.h"
#include "robotlink/process/Layout.h"

namespace app {

using robotlink::Error;
using robotlink::Errors;
using robotlink::Layout;
using robotlink::TaskCatalog;

namespace {

/// Names in a sentence: "a, b, c".
std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::set<std::string> tasksOf(const std::vector<const Layout*>& layouts) {
  std::set<std::string> tasks;
  for (const Layout* layout : layouts) {
    for (const auto& process : layout->processes) {
      for (const auto& task : process.tasks) tasks.insert(task.task);
    }
  }
  return tasks;
}

/// `known`: some layout could have the task. `tasks`: those that these layouts have.
Error noTask(const std::string& task, bool known, const std::set<std::string>& tasks) {
  const std::string head =
      known ? "no robot here has the task '" + task + "' in its layout" : "there is no task '" + task + "'";
  return {"solution.no-task",
          head + (tasks.empty() ? "; no robot has any task" : "; there are " + joined(tasks)),
          {task},
          {}};
}

Error noSolution(const TaskCatalog::Task& task, const std::string& solution) {
  std::set<std::string> names;
  for (const auto& known : task.solutions) names.insert(known.name);
  return {"solution.unknown",
          "task " + task.name + " has no solution '" + solution + "'; it has " + joined(names),
          {task.name, solution},
          {}};
}

}  // namespace

std::optional<std::pair<std::string, std::string>> assignmentOf(const std::string& text) {
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) return std::nullopt;
  return std::pair(text.substr(0, equals), text.substr(equals + 1));
}

robotlink::Result<std::map<std::string, std::string>> solutionsOf(const std::vector<std::string>& texts) {
  std::map<std::string, std::string> solutions;
  for (const std::string& text : texts) {
    const auto choice = assignmentOf(text);
    if (!choice) return robotlink::failure("usage", "--solution takes TASK=SOLUTION, not '" + text + "'");
    solutions[choice->first] = choice->second;
  }
  return solutions;
}

robotlink::Result<std::vector<robotlink::ShadowName>> shadowsOf(const std::vector<std::string>& texts) {
  std::vector<robotlink::ShadowName> shadows;
  for (const std::string& text : texts) {
    const auto choice = assignmentOf(text);
    if (!choice || robotlink::SolutionRegistry::find(choice->first, choice->second) == nullptr)
      return robotlink::failure("usage", "--shadow takes TASK=SOLUTION; there is no '" + text + "'", {},
                                {text});
    shadows.push_back({choice->first, choice->second});
  }
  return shadows;
}

Errors checkSolutions(const std::map<std::string, std::string>& solutions, const TaskCatalog& catalog,
                      const std::vector<const Layout*>& layouts) {
  Errors errors;
  const std::set<std::string> tasks = tasksOf(layouts);
  for (const auto& [task, solution] : solutions) {
    const TaskCatalog::Task* known = catalog.find(task);
    if (known == nullptr || !tasks.contains(task)) {
      errors.push_back(noTask(task, known != nullptr, tasks));
    } else if (catalog.find(task, solution) == nullptr) {
      errors.push_back(noSolution(*known, solution));
    }
  }
  return errors;
}

}  // namespace app
