// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/debugging/RegisteredTasks.h"

#include <algorithm>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/program/OtherPrograms.h"
#include "robotlink/debugging/program/ProcessReporter.h"
#include "robotlink/process/LayoutPrograms.h"

namespace robotlink {
namespace {

AnySender* senderOf(const Process& process, const std::string& package) {
  const auto& all = process.senders();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const AnySender* s) { return s->package() == package; });
  return found == all.end() ? nullptr : *found;
}

AnyReceiver* receiverOf(const Process& process, const std::string& package) {
  const auto& all = process.receivers();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const AnyReceiver* r) { return r->package() == package; });
  return found == all.end() ? nullptr : *found;
}

void connectPackage(const std::string& package, const Process& from, const Process& to) {
  AnySender* sender = senderOf(from, package);
  AnyReceiver* receiver = receiverOf(to, package);
  if (sender != nullptr && receiver != nullptr) connectUnchecked(*sender, *receiver);
}

PlatformPackages packagesOf(const Platform& platform) {
  PlatformPackages packages;
  for (const AnySender* sender : platform.senders()) packages.offers.push_back(sender->package());
  for (const AnyReceiver* receiver : platform.receivers()) packages.takes.push_back(receiver->package());
  packages.debugOffers = debugPackages();
  return packages;
}

}  // namespace

struct RobotProgram::Implementation {
  Implementation(RobotSetup givenRobot, Layout givenLayout, Part givenPart)
      : robot(std::move(givenRobot)), layout(std::move(givenLayout)), part(std::move(givenPart)) {}

  Errors build(const PlatformPackages& packages, const Clock& clock, const ParameterSource& parameters);
  Errors connectPackages(Platform& platform, const PlatformPackages& packages);
  Errors connectDebugging();
  Errors connectPrograms(const std::set<std::string>& commanding);
  void noteCommanding(const Platform& platform, const std::set<std::string>& commanding);
  std::vector<robotcontrol::Request> questionsTo(const std::string& process) const;
  /// Links two ends of which one or both are in this program; null: it is in another.
  Result<void> connect(const std::string& package, Process* from, const std::string& fromName, Process* to);
  Result<void> link(AnySender* sender, const std::string& from);
  Result<void> link(AnyReceiver* receiver, const std::string& from);
  void watchAll(Platform& platform, const PlatformPackages& packages);
  void reportTables();
  DebugProcess::Tables tables(const std::map<std::string, std::string>& chosenSolutions) const;
  bool isHere(const std::string& process) const;
  Process* find(const std::string& name) const;

  const RobotSetup robot;
  const Layout layout;
  const Part part;
  TaskCatalog catalog = registeredTasks();
  std::vector<std::unique_ptr<Process>> owned;
  std::vector<Process*> processes;
  /// The debug process or the reporter; one of the two is null.
  DebugProcess* debugProcess = nullptr;
  ProcessReporter* reporter = nullptr;
  /// The platform, and the processes here that decide what it does.
  std::vector<const Process*> commandedBy;
};

RobotProgram::RobotProgram() = default;

RobotProgram::~RobotProgram() {
  stop();
}

tl::expected<std::unique_ptr<RobotProgram>, Errors> RobotProgram::create(RobotSetup robot, Layout layout,
                                                                         Platform& platform,
                                                                         const ParameterSource& parameters,
                                                                         const Part& part) {
  std::unique_ptr<RobotProgram> program(new RobotProgram);
  program->implementation_ = std::make_unique<Implementation>(std::move(robot), std::move(layout), part);
  Implementation& made = *program->implementation_;
  const PlatformPackages packages = packagesOf(platform);
  Errors errors = checkLayout(made.layout, made.catalog, packages);
  if (errors.empty()) errors = made.build(packages, platform.clock(), parameters);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  // The platform is untouched so far, so a program that already runs on it keeps running if this one is
  // refused.
  const auto commanding = commandingProcesses(layoutLinks(made.layout, made.catalog, packages));
  errors = made.connectPackages(platform, packages);
  if (errors.empty()) errors = made.connectDebugging();
  if (errors.empty()) errors = made.connectPrograms(commanding);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  made.watchAll(platform, packages);
  made.noteCommanding(platform, commanding);
  made.reportTables();
  return program;
}

void RobotProgram::Implementation::watchAll(Platform& platform, const PlatformPackages& packages) {
  if (debugProcess == nullptr) return;
  for (const Process* process : processes) debugProcess->watch(*process);
  debugProcess->watch(platform);
  // The key of a package that a task receives belongs to that task's process.
  const auto links = layoutLinks(layout, catalog, packages);
  for (AnySender* sender : platform.onRequest()) {
    const auto isOfTask = [&](const LayoutLink& link) {
      return link.from.empty() && link.package == sender->package();
    };
    if (std::none_of(links.begin(), links.end(), isOfTask)) debugProcess->showOnRequest(*sender);
  }
}

void RobotProgram::Implementation::noteCommanding(const Platform& platform,
                                                  const std::set<std::string>& commanding) {
  commandedBy = {&platform};
  for (const std::string& name : commanding) {
    if (const Process* here = find(name)) commandedBy.push_back(here);
  }
}

/// Sets the first tables of the debug process to those of the whole program, since processes report theirs
/// only in their first frames, one after the other.
void RobotProgram::Implementation::reportTables() {
  if (debugProcess != nullptr) debugProcess->setTables(tables({}));
}

DebugProcess::Tables RobotProgram::Implementation::tables(
    const std::map<std::string, std::string>& chosenSolutions) const {
  DebugProcess::Tables all;
  for (const Process* process : processes) {
    const auto* tasks = dynamic_cast<const TaskProcess*>(process);
    if (tasks == nullptr) continue;
    auto& [keys, solutions] = all[process->name()];
    tasks->describe(chosenSolutions, keys, solutions);
  }
  return all;
}

bool RobotProgram::Implementation::isHere(const std::string& process) const {
  if (part.program.empty()) return true;
  const Layout::Program* program = process.empty() ? layout.mainProgram() : layout.programOf(process);
  return program != nullptr && program->name == part.program;
}

Errors RobotProgram::Implementation::build(const PlatformPackages& packages, const Clock& clock,
                                           const ParameterSource& parameters) {
  Errors errors;
  for (const Layout::Process& description : layout.processes) {
    if (!isHere(description.name)) continue;
    if (description.debug) {
      DebugRoutes routes = debugRoutes(layout, catalog, packages);
      for (const auto& joint : robot.description.joints) routes.joints.push_back(joint.name);
      auto made = std::make_unique<DebugProcess>(description.name, clock, routes);
      made->setPeriod(description.period);
      made->setPriority(description.priority);
      debugProcess = made.get();
      owned.push_back(std::move(made));
    } else if (auto made = TaskProcess::create({robot, layout, description, packages, parameters}, clock)) {
      owned.push_back(std::move(*made));
    } else {
      errors.insert(errors.end(), made.error().begin(), made.error().end());
    }
  }
  if (debugProcess == nullptr) {
    auto made = std::make_unique<ProcessReporter>(part.program, clock);
    for (const auto& process : owned) made->watch(*process);
    reporter = made.get();
    owned.push_back(std::move(made));
  }
  for (const auto& process : owned) processes.push_back(process.get());
  return errors;
}

Process* RobotProgram::Implementation::find(const std::string& name) const {
  const auto found =
      std::find_if(processes.begin(), processes.end(), [&](const Process* p) { return p->name() == name; });
  return found == processes.end() ? nullptr : *found;
}

Result<void> RobotProgram::Implementation::link(AnySender* sender, const std::string& from) {
  return sender == nullptr ? Result<void>() : part.links->link(*sender, from);
}

Result<void> RobotProgram::Implementation::link(AnyReceiver* receiver, const std::string& from) {
  return receiver == nullptr ? Result<void>() : part.links->link(*receiver, from);
}

Result<void> RobotProgram::Implementation::connect(const std::string& package, Process* from,
                                                   const std::string& fromName, Process* to) {
  if (from != nullptr && to != nullptr) connectPackage(package, *from, *to);
  if (from != nullptr && to == nullptr) return link(senderOf(*from, package), fromName);
  if (from == nullptr && to != nullptr) return link(receiverOf(*to, package), fromName);
  return {};
}

Errors RobotProgram::Implementation::connectPackages(Platform& platform, const PlatformPackages& packages) {
  Errors errors;
  const auto processOf = [&](const std::string& name) -> Process* {
    if (!isHere(name)) return nullptr;
    return name.empty() ? &platform : find(name);
  };
  for (const LayoutLink& link : layoutLinks(layout, catalog, packages)) {
    const std::string from = link.from.empty() ? ProgramLinks::kPlatform : link.from;
    const auto made = connect(link.package, processOf(link.from), from, processOf(link.to));
    if (!made) errors.push_back(made.error());
  }
  return errors;
}

Errors RobotProgram::Implementation::connectDebugging() {
  Errors errors;
  const auto note = [&](const Result<void>& made) {
    if (!made) errors.push_back(made.error());
  };
  std::string debug;
  for (const Layout::Process& process : layout.processes) {
    if (process.debug) debug = process.name;
  }
  for (const Layout::Process& process : layout.processes) {
    if (process.debug) continue;
    Process* here = find(process.name);
    note(connect("debug/queue/" + process.name, here, process.name, debugProcess));
    note(connect("debug/requests/" + process.name, debugProcess, debug, here));
  }
  return errors;
}

/// Returns the requests for the parameters of a process, which only the program that has them knows.
std::vector<robotcontrol::Request> RobotProgram::Implementation::questionsTo(
    const std::string& process) const {
  std::vector<robotcontrol::Request> questions;
  for (const Layout::Process& one : layout.processes) {
    if (one.name != process) continue;
    for (const Layout::Task& task : one.tasks) {
      for (const SolutionDescription& solution : SolutionRegistry::all()) {
        if (solution.task != task.task || solution.parameters == nullptr) continue;
        auto& question = *questions.emplace_back().mutable_get_parameters();
        question.set_task(task.task);
        question.set_solution(solution.name);
      }
    }
  }
  return questions;
}

/// Connects the programs to the one with the debug process, to which they report.
Errors RobotProgram::Implementation::connectPrograms(const std::set<std::string>& commanding) {
  Errors errors;
  for (const Layout::Program& program : layout.programs) {
    if (part.program.empty() || &program == layout.mainProgram()) continue;
    if (debugProcess != nullptr) {
      OtherPrograms::Questions questions;
      for (const auto& process : program.processes) questions[process.process] = questionsTo(process.process);
      debugProcess->addProgram(program.name, questions, commanding);
    } else if (program.name != part.program) {
      continue;
    }
    const auto made = connect("debug/processes/" + program.name, find("report/" + program.name),
                              "report/" + program.name, debugProcess);
    if (!made) errors.push_back(made.error());
  }
  return errors;
}

std::vector<std::string> debugPackages() {
  return {kRemoteMotion.name, kColorTable.name, kMotionTexts.name, kDriveGoal.name};
}

bool isDebugPackage(const std::string& package) {
  const auto all = debugPackages();
  return std::find(all.begin(), all.end(), package) != all.end();
}

const RobotSetup& RobotProgram::robot() const {
  return implementation_->robot;
}
const Layout& RobotProgram::layout() const {
  return implementation_->layout;
}
const std::vector<Process*>& RobotProgram::processes() const {
  return implementation_->processes;
}
DebugProcess& RobotProgram::debugProcess() {
  return *implementation_->debugProcess;
}
bool RobotProgram::hasDebugProcess() const {
  return implementation_->debugProcess != nullptr;
}
DebugProcess::Tables RobotProgram::tables(const std::map<std::string, std::string>& chosenSolutions) const {
  return implementation_->tables(chosenSolutions);
}
std::string RobotProgram::missingProcess() const {
  for (const Process* process : implementation_->commandedBy) {
    // A process that has stopped has closed its ends itself.
    if (process->stopped()) return process->name();
    for (const AnyReceiver* receiver : process->receivers()) {
      if (receiver->connected()) continue;
      // A receiver that no task sends to has no peer.
      if (std::string peer = receiver->peer(); !peer.empty()) return peer;
    }
  }
  return implementation_->debugProcess->missingProcess();
}

void RobotProgram::noteStuck(const std::string& process, const std::string& task) {
  implementation_->reporter->noteStuck(process, task);
}

std::vector<std::string> RobotProgram::yieldedPackages() const {
  std::set<std::string> packages;
  for (const Layout::Process& process : implementation_->layout.processes) {
    for (const Layout::Task& task : process.tasks) {
      const TaskCatalog::Task* known = implementation_->catalog.find(task.task);
      if (known == nullptr) continue;
      for (const auto& solution : known->solutions)
        packages.insert(solution.outputs.begin(), solution.outputs.end());
    }
  }
  for (const std::string& package : implementation_->layout.withheld) packages.erase(package);
  return {packages.begin(), packages.end()};
}

void RobotProgram::recordPackages(const std::set<std::string>& packages) {
  for (Process* process : implementation_->processes) {
    if (auto* tasks = dynamic_cast<TaskProcess*>(process)) tasks->recordPackages(packages);
  }
  if (!hasDebugProcess()) return;
  robotcontrol::Request request;
  request.mutable_record_packages()->mutable_packages()->Assign(packages.begin(), packages.end());
  debugProcess().askOtherPrograms(request);
}

void RobotProgram::setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) {
  for (Process* process : implementation_->processes) {
    if (auto* tasks = dynamic_cast<TaskProcess*>(process)) tasks->setKeys(modes);
  }
  if (!hasDebugProcess()) return;
  implementation_->reportTables();
  for (const auto& [name, mode] : modes) {
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(name);
    *request.mutable_set_key()->mutable_mode() = mode;
    debugProcess().askOtherPrograms(request);
  }
}

std::vector<robotcontrol::ParameterValues> RobotProgram::parameters() const {
  std::vector<robotcontrol::ParameterValues> result;
  for (const Process* process : implementation_->processes) {
    const auto* tasks = dynamic_cast<const TaskProcess*>(process);
    if (tasks == nullptr) continue;
    for (auto& values : tasks->parameters()) result.push_back(std::move(values));
  }
  return result;
}

void RobotProgram::stop() {
  if (!implementation_) return;
  for (Process* process : implementation_->processes) process->stop();
}

}  // namespace robotlink
