// SPDX-License-Identifier: GPL-3.0-or-later
// checkLayout() of Layout.h: everything that makes a layout unusable.
#include <algorithm>

#include "robotlink/base/Spelling.h"
#include "robotlink/process/LayoutIndex.h"
#include "robotlink/process/LayoutPrograms.h"

namespace robotlink {
namespace {

using Place = LayoutIndex::Place;

std::string line(const FilePosition& where) {
  return "line " + std::to_string(where.line);
}

class Checker {
 public:
  Checker(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform)
      : layout_(layout),
        catalog_(catalog),
        index_(layout, catalog, platform),
        links_(index_.debugProcess() != nullptr ? layoutLinks(layout, catalog, platform)
                                                : std::vector<LayoutLink>()) {}

  Errors check() {
    checkDebugProcesses();
    for (const Layout::Process& process : layout_.processes) checkProcess(process);
    checkTasks();
    for (const Layout::Task& shadow : layout_.shadows) checkTask(shadow);
    checkOutputs();
    for (const Place& place : index_.places()) checkDefaultSolution(place);
    for (const Layout::Process& process : layout_.processes) {
      for (const Layout::Input& input : process.blocking) checkBlocking(process, input);
    }
    for (const Layout::Process& process : layout_.processes) {
      for (const Layout::Input& output : process.blockingOutputs) checkBlockingOutput(process, output);
    }
    checkBlockingCycles();
    const Errors ofPrograms = checkPrograms(layout_);
    errors_.insert(errors_.end(), ofPrograms.begin(), ofPrograms.end());
    std::stable_sort(errors_.begin(), errors_.end(), [](const Error& a, const Error& b) {
      return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
    });
    return std::move(errors_);
  }

 private:
  void add(const FilePosition& where, const char* id, std::string text, std::vector<std::string> arguments) {
    errors_.push_back({std::string("layout.") + id, std::move(text), std::move(arguments), where});
  }

  void checkDebugProcesses();
  void checkProcess(const Layout::Process& process);
  void checkTasks();
  void checkTask(const Layout::Task& task);
  void checkOutputs();
  void checkDefaultSolution(const Place& place);
  void reportMissing(const Place& place, const std::string& package);
  void reportLater(const Place& place, const Place& later, const std::string& package);
  bool dependsOn(const Place& place, const Place& on, std::vector<const Place*>& seen) const;
  void checkBlocking(const Layout::Process& process, const Layout::Input& input);
  void checkBlockingOutput(const Layout::Process& process, const Layout::Input& output);
  bool isRead(const Layout::Process& process, const std::string& package) const;
  void checkBlockingCycles();
  void followBlocking(const Layout::Process& process, std::vector<const Layout::Process*>& path,
                      std::set<const Layout::Process*>& done);

  const Layout& layout_;
  const TaskCatalog& catalog_;
  LayoutIndex index_;
  std::vector<LayoutLink> links_;  // empty if there is no debug process
  Errors errors_;
};

void Checker::checkDebugProcesses() {
  const Layout::Process* first = index_.debugProcess();
  if (first == nullptr) {
    add({layout_.file, 0, 0}, "no-debug-process",
        "no process collects the debug messages of the others; add '- {name: debug, debug: true, period_ms: "
        "16}'",
        {});
  }
  for (const Layout::Process& process : layout_.processes) {
    if (!process.debug || &process == first) continue;
    add(process.where, "debug-twice",
        "process " + process.name + " is a second debug process, in addition to " + first->name +
            "; remove one of them",
        {process.name, first->name});
  }
}

void Checker::checkProcess(const Layout::Process& process) {
  for (const Layout::Process& other : layout_.processes) {
    if (&other == &process) break;
    if (other.name != process.name) continue;
    add(process.where, "process-twice",
        "there is a process " + process.name + " already, in " + line(other.where) + "; rename one of them",
        {process.name});
    break;
  }
  if (process.debug && (!process.tasks.empty() || !process.blocking.empty())) {
    add(process.where, "debug-with-tasks",
        "the debug process " + process.name +
            " has neither tasks nor blocking inputs; move them to another process",
        {process.name});
  }
  if (!process.debug && process.tasks.empty()) {
    add(process.where, "no-tasks", "process " + process.name + " has no tasks; give it one or remove it",
        {process.name});
  }
  if (process.blocking.empty() && process.period == Duration::zero()) {
    add(process.where, "never-waits",
        "process " + process.name +
            " waits for nothing and would run without pause; give it a blocking input or a period_ms",
        {process.name});
  }
}

void Checker::checkTasks() {
  std::map<std::string, const Layout::Task*> seen;
  for (const Layout::Process& process : layout_.processes) {
    for (const Layout::Task& task : process.tasks) {
      const auto [first, isFirst] = seen.emplace(task.task, &task);
      if (isFirst) {
        checkTask(task);
        continue;
      }
      add(task.where, "task-twice",
          "task " + task.task + " is done already, in " + line(first->second->where) + "; remove one of them",
          {task.task});
    }
  }
}

void Checker::checkTask(const Layout::Task& task) {
  const TaskCatalog::Task* known = catalog_.find(task.task);
  std::vector<std::string> names;
  if (known == nullptr) {
    for (const auto& [name, entry] : catalog_.tasks) names.push_back(name);
    add(task.where, "unknown-task", "there is no task '" + task.task + "'" + suggestion(task.task, names),
        {task.task});
    return;
  }
  if (catalog_.find(task.task, task.solution) != nullptr) return;
  for (const TaskCatalog::Solution& solution : known->solutions) names.push_back(solution.name);
  add(task.where, "unknown-solution",
      "task " + task.task + " has no solution '" + task.solution + "'" + suggestion(task.solution, names),
      {task.task, task.solution});
}

void Checker::checkOutputs() {
  for (const Place& place : index_.places()) {
    for (const std::string& package : index_.outputsOf(*place.task)) {
      const Place* first = index_.producer(package);
      std::string other;
      if (index_.platformOffers(package)) other = "the platform";
      if (index_.debugOffers(package)) other = "the debug process";
      if (first != &place) other = "task " + first->entry->task + " (" + line(first->entry->where) + ")";
      if (other.empty()) continue;
      std::string text = "task " + place.entry->task;
      text.append(" yields ").append(package).append(", which ").append(other);
      text += " also yields; remove one of them";
      add(place.entry->where, "output-twice", std::move(text), {place.entry->task, package});
    }
  }
}

void Checker::checkDefaultSolution(const Place& place) {
  const TaskCatalog::Solution* solution = catalog_.find(place.entry->task, place.entry->solution);
  if (solution == nullptr) return;
  for (const std::string& package : solution->required) {
    const LayoutIndex::Obstacle obstacle = index_.obstacle(place, package);
    if (obstacle.reason.empty()) continue;
    if (obstacle.later != nullptr) {
      reportLater(place, *obstacle.later, package);
    } else {
      reportMissing(place, package);
    }
  }
}

void Checker::reportMissing(const Place& place, const std::string& package) {
  std::vector<std::string> makers;  // tasks that the layout could have
  for (const auto& [name, task] : catalog_.tasks) {
    if (index_.outputsOf(task).count(package) > 0 && index_.placeOf(name) == nullptr) makers.push_back(name);
  }
  const std::string who = "task " + place.entry->task + " (" + place.entry->solution + ") needs " + package;
  if (!makers.empty()) {
    std::string text = who + ", which no task yields here; add a task that does: ";
    for (std::size_t i = 0; i < makers.size(); ++i) text += (i > 0 ? " or " : "") + makers[i];
    add(place.entry->where, "input-missing", std::move(text), {place.entry->task, package});
    return;
  }
  std::string others;
  for (const TaskCatalog::Solution& solution : place.task->solutions) {
    if (index_.obstacle(place, solution).empty()) others += (others.empty() ? "" : ", ") + solution.name;
  }
  add(place.entry->where, "solution-unavailable",
      who + ", which neither the platform nor a task offers; " +
          (others.empty() ? "remove the task" : "choose another solution: " + others),
      {place.entry->task, place.entry->solution, package});
}

void Checker::reportLater(const Place& place, const Place& later, const std::string& package) {
  const std::string& task = place.entry->task;
  const std::string& from = later.entry->task;
  std::vector<const Place*> seen;
  if (&later == &place || dependsOn(later, place, seen)) {
    add(place.entry->where, "cycle",
        "a cycle in process " + place.process->name + ": " + task + " needs " + package + " of " + from +
            ", which needs what " + task + " yields; put one of them into another process",
        {task, package, from});
    return;
  }
  add(place.entry->where, "order",
      task + " needs " + package + " of " + from + ", which runs after it; move " + from + " up, above " +
          task,
      {task, package, from});
}

/// Whether a task needs, directly or through other tasks of its process, what another one yields. Only
/// default solutions are considered.
bool Checker::dependsOn(const Place& place, const Place& on, std::vector<const Place*>& seen) const {
  if (std::find(seen.begin(), seen.end(), &place) != seen.end()) return false;
  seen.push_back(&place);
  const TaskCatalog::Solution* solution = catalog_.find(place.entry->task, place.entry->solution);
  if (solution == nullptr) return false;
  for (const std::string& package : solution->required) {
    const Place* from = index_.producer(package);
    if (from == nullptr || from->process != place.process) continue;
    if (from == &on || dependsOn(*from, on, seen)) return true;
  }
  return false;
}

bool Checker::isRead(const Layout::Process& process, const std::string& package) const {
  return std::any_of(index_.places().begin(), index_.places().end(), [&](const Place& place) {
    const auto& solutions = place.task->solutions;
    return place.process == &process &&
           std::any_of(solutions.begin(), solutions.end(),
                       [&](const auto& solution) { return LayoutIndex::reads(solution, package); });
  });
}

void Checker::checkBlocking(const Layout::Process& process, const Layout::Input& input) {
  const auto first = std::find_if(process.blocking.begin(), process.blocking.end(),
                                  [&](const Layout::Input& other) { return other.package == input.package; });
  const auto complain = [&](const char* id, const std::string& text) {
    add(input.where, id,
        "process " + process.name + " waits for " + input.package + text + "; remove it from 'blocking'",
        {process.name, input.package});
  };
  const Place* from = index_.producer(input.package);
  if (&*first != &input) return complain("blocking-twice", " twice");
  // Reported with the process.
  if (process.debug) return;
  if (!input.paceOnly && !isRead(process, input.package))
    return complain("blocking-unused", ", which none of its tasks uses");
  if (from != nullptr && from->process == &process)
    return complain("blocking-own", ", which it yields itself");
  if (from == nullptr && !index_.platformOffers(input.package) && !index_.debugOffers(input.package)) {
    complain("blocking-missing", ", which no task yields here");
  }
}

/// Cycles of blocking outputs need no check: a process takes packages while it waits, too.
void Checker::checkBlockingOutput(const Layout::Process& process, const Layout::Input& output) {
  const auto first =
      std::find_if(process.blockingOutputs.begin(), process.blockingOutputs.end(),
                   [&](const Layout::Input& other) { return other.package == output.package; });
  const auto complain = [&](const char* id, const std::string& text) {
    add(output.where, id,
        "process " + process.name + " waits until " + output.package + text +
            "; remove it from 'blocking_outputs'",
        {process.name, output.package});
  };
  if (&*first != &output) return complain("blocking-output-twice", " is taken, twice");
  const Place* from = index_.producer(output.package);
  if (from == nullptr || from->process != &process)
    return complain("blocking-output-missing", " is taken, which none of its tasks yields");
  const bool isTaken = std::any_of(links_.begin(), links_.end(), [&](const LayoutLink& link) {
    return link.package == output.package && link.from == process.name;
  });
  if (!isTaken)
    complain("blocking-output-unused", " is taken, but no other process and no platform receives it");
}

void Checker::checkBlockingCycles() {
  std::set<const Layout::Process*> done;
  for (const Layout::Process& process : layout_.processes) {
    std::vector<const Layout::Process*> path;
    followBlocking(process, path, done);
  }
}

void Checker::followBlocking(const Layout::Process& process, std::vector<const Layout::Process*>& path,
                             std::set<const Layout::Process*>& done) {
  if (done.count(&process) > 0) return;
  path.push_back(&process);
  for (const Layout::Input& input : process.blocking) {
    const Place* from = index_.producer(input.package);
    if (from == nullptr || from->process == &process) continue;
    const auto start = std::find(path.begin(), path.end(), from->process);
    if (start == path.end()) {
      followBlocking(*from->process, path, done);
      continue;
    }
    std::string names;
    for (auto at = start; at != path.end(); ++at) names += (*at)->name + " waits for ";
    add(input.where, "blocking-cycle",
        names + (*start)->name + ", so that none of them ever runs; remove a blocking input, such as " +
            input.package + " here",
        {input.package});
  }
  path.pop_back();
  done.insert(&process);
}

}  // namespace

Errors checkLayout(const Layout& layout, const TaskCatalog& catalog, const PlatformPackages& platform) {
  return Checker(layout, catalog, platform).check();
}

}  // namespace robotlink
