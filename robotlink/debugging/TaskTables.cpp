// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/TaskTables.h"

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/debugging/DebugRoutes.h"

namespace robotlink {

const StopwatchKey kTimingKey{"timing/tasks", "How long each task took, in real time"};

namespace {

/// Adds the keys by which solutions of a task run in the shadow of the active one. They have no stream of
/// their own, as a shadow publishes on many.
void fillShadowKeys(const TaskRunner& task, robotcontrol::KeyTable& to) {
  if (task.solutions().size() < 2) return;
  for (const SolutionDescription* solution : task.solutions()) {
    auto& key = *to.add_keys();
    key.set_name(shadowKey(task.task(), solution->name));
    key.set_help("Runs " + solution->name + " of " + task.task() +
                 " in the shadow of the active solution: on the same inputs, without being used");
    key.add_solutions(task.task() + "/" + solution->name);
    *key.mutable_mode() = task.shadowMode(solution->name);
    key.set_in_use(true);
  }
}

}  // namespace

void fillKeyTable(const TaskRunners& tasks, const PackageBoard& board, const DebugContext& debug,
                  robotcontrol::KeyTable& to, const std::map<std::string, std::string>& chosen) {
  // Keyed by index.
  std::map<int, robotcontrol::KeyTable::Key> keys;
  keys[kTimingKey.index()].set_in_use(true);
  for (const auto& task : tasks) {
    const auto other = chosen.find(task->task());
    const std::string& active = other == chosen.end() ? task->active() : other->second;
    for (const SolutionDescription* solution : task->solutions()) {
      for (const int index : solution->keys) {
        keys[index].add_solutions(task->task() + "/" + solution->name);
        if (solution->name == active) keys[index].set_in_use(true);
      }
    }
  }
  for (auto& [index, key] : keys) {
    const DebugKey::Entry& entry = DebugKey::all()[static_cast<std::size_t>(index)];
    key.set_name(entry.name);
    key.set_help(entry.help);
    key.set_stream(entry.stream);
    *key.mutable_mode() = debug.mode(index);
    *to.add_keys() = std::move(key);
  }
  for (const auto& task : tasks) fillShadowKeys(*task, to);
  for (const PackageBoard::Entry* entry : board.shown()) {
    fillPackageKey(entry->name, entry->mode.mode(), *to.add_keys());
  }
}

void fillPackageKey(const std::string& package, const robotcontrol::KeyMode& mode,
                    robotcontrol::KeyTable::Key& to) {
  to.set_name(packageKey(package));
  to.set_help("The package " + package + " as it is");
  to.set_stream(package);
  *to.mutable_mode() = mode;
  to.set_in_use(true);
}

namespace {

std::string defaultSolution(const Layout& layout, const std::string& process, const std::string& task) {
  for (const Layout::Process& candidate : layout.processes) {
    if (candidate.name != process) continue;
    for (const Layout::Task& known : candidate.tasks) {
      if (known.task == task) return known.ownSolution.empty() ? known.solution : known.ownSolution;
    }
  }
  return {};
}

void fillSolution(const SolutionDescription& solution, robotcontrol::SolutionTable::Solution& to) {
  to.set_name(solution.name);
  to.set_help(solution.source.empty() ? solution.help : solution.help + "\nSource: " + solution.source);
  to.set_has_parameters(solution.parameters != nullptr);
  for (const std::string& package : solution.required) to.add_required_inputs(package);
  for (const std::string& package : solution.optional) to.add_optional_inputs(package);
  for (const std::string& package : solution.outputs) to.add_outputs(package);
}

}  // namespace

void fillSolutionTable(const std::string& process, const TaskRunners& tasks, const Layout& layout,
                       const TaskCatalog& catalog, const PlatformPackages& platform,
                       robotcontrol::SolutionTable& to) {
  for (const auto& task : tasks) {
    auto& row = *to.add_tasks();
    row.set_name(task->task());
    row.set_process(process);
    row.set_active(task->active());
    row.set_default_solution(defaultSolution(layout, process, task->task()));
    if (const TaskCatalog::Task* known = catalog.find(task->task())) row.set_help(known->help);
    for (const SolutionDescription* solution : task->solutions()) {
      auto& cell = *row.add_solutions();
      fillSolution(*solution, cell);
      cell.set_unavailable(unavailability(layout, catalog, platform, task->task(), solution->name));
    }
  }
}

void addAbsentTasks(const std::vector<Layout::Absence>& absent, robotcontrol::SolutionTable& to) {
  for (const Layout::Absence& absence : absent) {
    auto& row = *to.add_tasks();
    row.set_name(absence.task);
    row.set_process(absence.process);
    for (const TaskDescription& described : describedTasks()) {
      if (described.task == absence.task) row.set_help(described.help);
    }
    for (const SolutionDescription& solution : SolutionRegistry::all()) {
      if (solution.task != absence.task) continue;
      auto& cell = *row.add_solutions();
      fillSolution(solution, cell);
      cell.set_unavailable("unavailable because " + absence.reason);
    }
  }
}

}  // namespace robotlink
