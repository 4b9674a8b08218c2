// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayPlan.h"

#include <algorithm>

#include "robotlink/base/TextParts.h"
#include "robotlink/packages/PackageTitles.h"

namespace app {

using robotcontrol::ControlReplay;
using robotlink::contains;
using robotlink::Errors;
using robotlink::Layout;
using robotlink::TaskCatalog;

namespace {

/// The period of a process whose pace nothing else sets: so short that it runs at every instant of any log.
constexpr robotlink::Duration kEveryInstant = std::chrono::microseconds(1);

/// The packages that any solution of a task yields; none for null.
std::set<std::string> outputsOf(const TaskCatalog::Task* task) {
  std::set<std::string> outputs;
  if (task == nullptr) return outputs;
  for (const auto& solution : task->solutions)
    outputs.insert(solution.outputs.begin(), solution.outputs.end());
  return outputs;
}

/// The algorithm of planReplay(); one object makes one plan.
class Planner {
 public:
  Planner(ReplaySelection selection, const TaskCatalog& catalog)
      : selection_(std::move(selection)), catalog_(catalog) {
    plan_.layout = selection_.layout;
    plan_.layout.programs.clear();  // a log is replayed in one program
  }

  tl::expected<ReplayPlan, Errors> make() {
    findObtainable();
    listPackages();
    choose();
    if (!errors_.empty()) return tl::unexpected(std::move(errors_));
    replaceTasks();
    removeUnavailable();
    for (Layout::Process& process : plan_.layout.processes) {
      setPace(process);
      process.blockingOutputs.clear();  // how they held the process back is in the log
    }
    Errors errors = checkLayout(plan_.layout, catalog_, platform_);
    if (!errors.empty()) return tl::unexpected(std::move(errors));
    return std::move(plan_);
  }

 private:
  /// Finds all packages that are logged or that some task could yield, whatever is chosen.
  void findObtainable();
  /// The first required package that is not obtainable; null if there is none.
  const std::string* missing(const TaskCatalog::Solution& solution) const;
  /// Lists all packages of log and layout in the plan.
  void listPackages();
  /// Fills in who yields a package and whether that is possible here.
  void describeProducer(ReplayPlan::Package& package) const;
  /// Decides where each package comes from.
  void choose();
  /// Whether a package that is not logged need not be computed: no task requires it, the requested solution
  /// does not yield it, and other packages of its task are logged.
  bool isDispensable(const ReplayPlan::Package& package) const;
  /// Removes tasks whose packages all come from the log.
  void replaceTasks();
  /// Removes tasks that cannot run.
  void removeUnavailable();
  /// Removes one of them, since others may need what it yields. Returns false if there is none.
  bool removeOneUnavailable();
  /// Chooses another solution if the requested one cannot run. Returns why no solution can; empty if one can.
  std::string makeAvailable(Layout::Task& task);
  /// Removes processes without tasks, except the debug process.
  void removeEmptyProcesses();
  /// Lets a process run as often as in the recording, even if no task is left that reads what it waited for.
  void setPace(Layout::Process& process) const;
  /// Whether a process can get a package from the log or another process.
  bool isOffered(const std::string& package, const Layout::Process& to) const;
  /// Whether any solution of a process's tasks uses a package.
  bool isRead(const std::string& package, const Layout::Process& by) const;
  /// The first logged package that the tasks of a process require; empty if there is none.
  std::string paceOf(const Layout::Process& process) const;

  ReplaySelection selection_;
  const TaskCatalog& catalog_;
  ReplayPlan plan_;
  /// See findObtainable().
  std::set<std::string> obtainable_;
  /// The packages that the log and the debug process offer.
  robotlink::PlatformPackages platform_;
  Errors errors_;
};

// ---- Packages

void Planner::findObtainable() {
  obtainable_ = selection_.logged;
  obtainable_.insert(selection_.debugOffers.begin(), selection_.debugOffers.end());
  for (std::size_t before = 0; before != obtainable_.size();) {
    before = obtainable_.size();
    for (const Layout::Process& process : selection_.layout.processes) {
      for (const Layout::Task& task : process.tasks) {
        const TaskCatalog::Task* known = catalog_.find(task.task);
        if (known == nullptr) continue;
        for (const auto& solution : known->solutions) {
          if (missing(solution) == nullptr)
            obtainable_.insert(solution.outputs.begin(), solution.outputs.end());
        }
      }
    }
  }
}

const std::string* Planner::missing(const TaskCatalog::Solution& solution) const {
  const auto found = std::ranges::find_if(
      solution.required, [&](const std::string& package) { return !obtainable_.contains(package); });
  return found == solution.required.end() ? nullptr : &*found;
}

void Planner::listPackages() {
  std::set<std::string> names = selection_.logged;
  for (const Layout::Process& process : selection_.layout.processes) {
    for (const Layout::Task& task : process.tasks) names.merge(outputsOf(catalog_.find(task.task)));
  }
  for (const std::string& name : names) {
    ReplayPlan::Package package;
    package.name = name;
    package.logged = selection_.logged.contains(name);
    package.whyNot = "no task of layout " + selection_.layout.name + " yields it";
    describeProducer(package);
    plan_.packages.push_back(std::move(package));
  }
}

void Planner::describeProducer(ReplayPlan::Package& package) const {
  for (const Layout::Process& process : selection_.layout.processes) {
    for (const Layout::Task& task : process.tasks) {
      const TaskCatalog::Task* known = catalog_.find(task.task);
      if (!outputsOf(known).contains(package.name)) continue;
      package.process = process.name;
      const std::string* wanting = nullptr;
      for (const auto& solution : known->solutions) {
        if (!contains(solution.outputs, package.name)) continue;
        const std::string* lacks = missing(solution);
        if (lacks == nullptr) package.canRecompute = true;
        // The input that the requested solution lacks is more informative than those that others lack.
        if (wanting == nullptr || solution.name == task.solution) wanting = lacks;
      }
      package.whyNot = package.canRecompute || wanting == nullptr ? "" : robotlink::notProvided(*wanting);
      return;
    }
  }
}

void Planner::choose() {
  for (ReplayPlan::Package& package : plan_.packages) {
    const auto choice = selection_.packages.find(package.name);
    const auto source = choice == selection_.packages.end() ? ControlReplay::AUTOMATIC : choice->second;
    package.chosen = source != ControlReplay::AUTOMATIC;
    const bool recomputed =
        package.logged || isDispensable(package) ? selection_.recomputeAll && package.canRecompute : true;
    package.source = recomputed ? ControlReplay::RECOMPUTED : ControlReplay::AS_LOGGED;
    if (source == ControlReplay::RECOMPUTED && !package.canRecompute) {
      errors_.push_back({"replay.cannot-recompute",
                         package.name + " cannot be recomputed: " + package.whyNot,
                         {package.name, package.whyNot},
                         {}});
    } else if (source == ControlReplay::AS_LOGGED && !package.logged) {
      errors_.push_back({"replay.not-logged", package.name + " is not in the log", {package.name}, {}});
    } else if (package.chosen) {
      package.source = source;
    }
  }
  for (const auto& [name, source] : selection_.packages) {
    if (source == ControlReplay::AUTOMATIC || plan_.find(name) != nullptr) continue;
    errors_.push_back(
        {"replay.no-package",
         "there is no package " + name + ", neither in the log nor of layout " + selection_.layout.name,
         {name},
         {}});
  }
}

bool Planner::isDispensable(const ReplayPlan::Package& package) const {
  bool isBesideLogged = false;
  for (const Layout::Process& process : selection_.layout.processes) {
    for (const Layout::Task& task : process.tasks) {
      const TaskCatalog::Task* known = catalog_.find(task.task);
      if (known == nullptr) continue;
      const std::set<std::string> outputs = outputsOf(known);
      isBesideLogged = isBesideLogged || (outputs.contains(package.name) &&
                                          std::ranges::any_of(outputs, [&](const auto& output) {
                                            return selection_.logged.contains(output);
                                          }));
      for (const TaskCatalog::Solution& solution : known->solutions) {
        const bool isSent = solution.name == task.solution && contains(solution.outputs, package.name);
        if (isSent || contains(solution.required, package.name)) return false;
      }
    }
  }
  return isBesideLogged;
}

// ---- Tasks

void Planner::replaceTasks() {
  for (const auto& package : plan_.packages) {
    if (package.source == ControlReplay::AS_LOGGED) platform_.offers.push_back(package.name);
  }
  platform_.debugOffers = selection_.debugOffers;
  for (Layout::Process& process : plan_.layout.processes) {
    std::erase_if(process.tasks, [&](const Layout::Task& task) {
      std::set<std::string> replaced;
      const std::set<std::string> outputs = outputsOf(catalog_.find(task.task));
      for (const std::string& output : outputs) {
        if (plan_.isAsLogged(output)) replaced.insert(output);
      }
      const bool goes = !outputs.empty() && replaced.size() == outputs.size();
      if (goes) {
        plan_.layout.absent.push_back(
            {process.name, task.task, "its output is taken from the log: " + robotlink::joined(replaced)});
      } else {
        plan_.layout.withheld.merge(replaced);
      }
      return goes;
    });
  }
  removeEmptyProcesses();
}

void Planner::removeUnavailable() {
  while (removeOneUnavailable()) removeEmptyProcesses();
}

bool Planner::removeOneUnavailable() {
  for (Layout::Process& process : plan_.layout.processes) {
    for (auto task = process.tasks.begin(); task != process.tasks.end(); ++task) {
      const std::string reason = makeAvailable(*task);
      if (reason.empty()) continue;
      plan_.unavailable.push_back(task->task + ": " + reason);
      plan_.layout.absent.push_back({process.name, task->task, reason});
      process.tasks.erase(task);
      return true;
    }
  }
  return false;
}

std::string Planner::makeAvailable(Layout::Task& task) {
  const auto reasonOf = [&](const std::string& solution) {
    constexpr std::string_view kPrefix = "unavailable because ";
    if (const auto broken = selection_.broken.find({task.task, solution});
        broken != selection_.broken.end()) {
      return broken->second;
    }
    const std::string reason = unavailability(plan_.layout, catalog_, platform_, task.task, solution);
    return reason.starts_with(kPrefix) ? reason.substr(kPrefix.size()) : reason;
  };
  const TaskCatalog::Task* known = catalog_.find(task.task);
  const bool misspelled = catalog_.find(task.task, task.solution) == nullptr;
  // checkLayout() reports it later.
  if (misspelled && !selection_.fromLog) return {};
  if (known == nullptr) return "this program has no such task";
  const std::string reason = misspelled ? "this program has no such solution" : reasonOf(task.solution);
  if (reason.empty()) return {};
  for (const auto& other : known->solutions) {
    if (!reasonOf(other.name).empty()) continue;
    plan_.notes.push_back("task " + task.task + " is done by " + other.name + ", because " + task.solution +
                          " is unavailable: " + reason);
    plan_.replaced[task.task] = reason;
    task.solution = other.name;
    return {};
  }
  return reason;
}

void Planner::removeEmptyProcesses() {
  std::erase_if(plan_.layout.processes,
                [](const Layout::Process& process) { return !process.debug && process.tasks.empty(); });
}

// ---- Pace

void Planner::setPace(Layout::Process& process) const {
  if (process.debug) {
    // Every instant, so that what programs publish is collected at once.
    process.period = kEveryInstant;
    return;
  }
  const bool waited = !process.blocking.empty();
  std::erase_if(process.blocking,
                [&](const Layout::Input& input) { return !isOffered(input.package, process); });
  for (Layout::Input& input : process.blocking) input.paceOnly = !isRead(input.package, process);
  if (!waited || !process.blocking.empty()) return;
  if (const std::string pace = paceOf(process); !pace.empty()) {
    process.blocking.push_back({pace, process.where});
  } else if (process.period == robotlink::Duration::zero()) {
    process.period = kEveryInstant;
  }
}

bool Planner::isOffered(const std::string& package, const Layout::Process& to) const {
  if (contains(platform_.offers, package) || contains(platform_.debugOffers, package)) return true;
  return std::ranges::any_of(plan_.layout.processes, [&](const Layout::Process& from) {
    return &from != &to && std::ranges::any_of(from.tasks, [&](const Layout::Task& task) {
      return outputsOf(catalog_.find(task.task)).contains(package);
    });
  });
}

bool Planner::isRead(const std::string& package, const Layout::Process& by) const {
  return std::ranges::any_of(by.tasks, [&](const Layout::Task& task) {
    const TaskCatalog::Task* known = catalog_.find(task.task);
    return known != nullptr && std::ranges::any_of(known->solutions, [&](const auto& solution) {
             return contains(solution.required, package) || contains(solution.optional, package);
           });
  });
}

std::string Planner::paceOf(const Layout::Process& process) const {
  for (const Layout::Task& task : process.tasks) {
    const TaskCatalog::Solution* solution = catalog_.find(task.task, task.solution);
    if (solution == nullptr) continue;
    for (const std::string& package : solution->required) {
      if (contains(platform_.offers, package)) return package;
    }
  }
  return {};
}

}  // namespace

bool ReplayPlan::runs(const std::string& task) const {
  return std::ranges::any_of(layout.processes, [&](const Layout::Process& process) {
    return std::ranges::any_of(process.tasks, [&](const Layout::Task& entry) { return entry.task == task; });
  });
}

const ReplayPlan::Package* ReplayPlan::find(const std::string& package) const {
  const auto found = std::ranges::find(packages, package, &Package::name);
  return found == packages.end() ? nullptr : &*found;
}

bool ReplayPlan::isAsLogged(const std::string& package) const {
  const Package* found = find(package);
  return found != nullptr && found->source == ControlReplay::AS_LOGGED;
}

tl::expected<ReplayPlan, Errors> planReplay(ReplaySelection selection, const TaskCatalog& catalog) {
  return Planner(std::move(selection), catalog).make();
}

}  // namespace app
