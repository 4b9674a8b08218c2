// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/SolutionChoices.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "robotlink/base/TextParts.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/process/Layout.h"

namespace app {

using robotlink::Error;
using robotlink::Errors;
using robotlink::Layout;
using robotlink::TaskCatalog;

namespace {

std::set<std::string> tasksOf(const std::vector<const Layout*>& layouts) {
  std::set<std::string> tasks;
  for (const Layout* layout : layouts) {
    for (const auto& process : layout->processes) {
      for (const auto& task : process.tasks) tasks.insert(task.task);
    }
  }
  return tasks;
}

/// Whether all of these layouts that have the task do it by this solution.
bool isUsedByAll(const std::string& task, const std::string& solution,
                 const std::vector<const Layout*>& layouts) {
  for (const Layout* layout : layouts) {
    for (const auto& process : layout->processes) {
      for (const auto& one : process.tasks)
        if (one.task == task && one.solution != solution) return false;
    }
  }
  return true;
}

/// `known`: some layout could have the task. `tasks`: those that these layouts have.
Error noTask(const std::string& task, bool known, const std::set<std::string>& tasks) {
  const std::string head =
      known ? "no robot here has the task '" + task + "' in its layout" : "there is no task '" + task + "'";
  return {"solution.no-task",
          head + (tasks.empty() ? "; no robot has any task" : "; there are " + robotlink::joined(tasks)),
          {task},
          {}};
}

Error noSolution(const TaskCatalog::Task& task, const std::string& solution) {
  std::set<std::string> names;
  for (const auto& known : task.solutions) names.insert(known.name);
  return {"solution.unknown",
          "task " + task.name + " has no solution '" + solution + "'; it has " + robotlink::joined(names),
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

robotlink::Result<SolutionChoice> solutionChoiceOf(const std::string& text, const std::string& option) {
  const auto choice = assignmentOf(text);
  const std::size_t slash = choice ? choice->first.find('/') : 0;
  if (!choice || slash == 0 || slash + 1 == choice->first.size())
    return robotlink::failure(
        "usage",
        option + " takes TASK=SOLUTION, or NAME/TASK=SOLUTION for a robot or team, not '" + text + "'", {},
        {text});
  const auto& [what, solution] = *choice;
  if (slash == std::string::npos) return SolutionChoice{{}, what, solution};
  return SolutionChoice{what.substr(0, slash), what.substr(slash + 1), solution};
}

robotlink::Result<void> checkShadow(const robotlink::ShadowName& shadow) {
  const TaskCatalog catalog = robotlink::registeredTasks();
  std::set<std::string> tasks;
  for (const auto& [name, task] : catalog.tasks) tasks.insert(name);
  const TaskCatalog::Task* known = catalog.find(shadow.task);
  if (known != nullptr && catalog.find(shadow.task, shadow.solution) != nullptr) return {};
  Error error = known == nullptr ? noTask(shadow.task, false, tasks) : noSolution(*known, shadow.solution);
  error.id = "usage";
  error.text = "--shadow: " + error.text;
  return tl::unexpected(std::move(error));
}

robotlink::Result<std::vector<robotlink::ShadowName>> shadowsOf(const std::vector<std::string>& texts) {
  std::vector<robotlink::ShadowName> shadows;
  for (const std::string& text : texts) {
    const auto choice = assignmentOf(text);
    if (!choice)
      return robotlink::failure("usage", "--shadow takes TASK=SOLUTION, not '" + text + "'", {}, {text});
    shadows.push_back({choice->first, choice->second});
    if (auto known = checkShadow(shadows.back()); !known) return tl::unexpected(known.error());
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

Errors checkShadows(const std::vector<robotlink::ShadowName>& shadows, const TaskCatalog& catalog,
                    const std::vector<const Layout*>& layouts) {
  Errors errors;
  for (const auto& [task, solution] : shadows) {
    Errors unknown = checkSolutions({{task, solution}}, catalog, layouts);
    if (unknown.empty() && isUsedByAll(task, solution, layouts))
      unknown.push_back({"solution.shadow",
                         "--shadow: " + solution + " is the solution that is used for " + task +
                             "; name another one, or choose another one for the task (--solution)",
                         {task, solution},
                         {}});
    std::ranges::move(unknown, std::back_inserter(errors));
  }
  return errors;
}

}  // namespace app
