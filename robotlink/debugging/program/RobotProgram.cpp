// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/debugging/RegisteredTasks.h"

#include <algorithm>

#include "robotlink/debugging/DebugRoutes.h"

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
  Implementation(RobotSetup givenRobot, Layout givenLayout)
      : robot(std::move(givenRobot)), layout(std::move(givenLayout)) {}

  Errors build(const PlatformPackages& packages, const Clock& clock, const ParameterSource& parameters);
  void connectPackages(Platform& platform, const PlatformPackages& packages);
  void connectDebugging();
  Process* find(const std::string& name) const;

  const RobotSetup robot;
  const Layout layout;
  TaskCatalog catalog = registeredTasks();
  std::vector<std::unique_ptr<Process>> owned;
  std::vector<Process*> processes;
  DebugProcess* debugProcess = nullptr;
};

RobotProgram::RobotProgram() = default;

RobotProgram::~RobotProgram() {
  stop();
}

tl::expected<std::unique_ptr<RobotProgram>, Errors> RobotProgram::create(RobotSetup robot, Layout layout,
                                                                         Platform& platform,
                                                                         const ParameterSource& parameters) {
  std::unique_ptr<RobotProgram> program(new RobotProgram);
  program->implementation_ = std::make_unique<Implementation>(std::move(robot), std::move(layout));
  Implementation& made = *program->implementation_;
  const PlatformPackages packages = packagesOf(platform);
  Errors errors = checkLayout(made.layout, made.catalog, packages);
  if (errors.empty()) errors = made.build(packages, platform.clock(), parameters);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  // The platform is untouched so far, so a program that already runs on it keeps running if this one is
  // refused.
  made.connectPackages(platform, packages);
  made.connectDebugging();
  for (const Process* process : made.processes) made.debugProcess->watch(*process);
  made.debugProcess->watch(platform);
  // The key of a package that a task receives belongs to that task's process.
  const auto links = layoutLinks(made.layout, made.catalog, packages);
  for (AnySender* sender : platform.onRequest()) {
    const auto isOfTask = [&](const LayoutLink& link) {
      return link.from.empty() && link.package == sender->package();
    };
    if (std::none_of(links.begin(), links.end(), isOfTask)) made.debugProcess->showOnRequest(*sender);
  }
  return program;
}

Errors RobotProgram::Implementation::build(const PlatformPackages& packages, const Clock& clock,
                                           const ParameterSource& parameters) {
  Errors errors;
  for (const Layout::Process& description : layout.processes) {
    if (description.debug) {
      auto made =
          std::make_unique<DebugProcess>(description.name, clock, debugRoutes(layout, catalog, packages));
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
  for (const auto& process : owned) processes.push_back(process.get());
  return errors;
}

Process* RobotProgram::Implementation::find(const std::string& name) const {
  const auto found =
      std::find_if(processes.begin(), processes.end(), [&](const Process* p) { return p->name() == name; });
  return found == processes.end() ? nullptr : *found;
}

void RobotProgram::Implementation::connectPackages(Platform& platform, const PlatformPackages& packages) {
  for (const LayoutLink& link : layoutLinks(layout, catalog, packages)) {
    const Process* from = link.from.empty() ? &platform : find(link.from);
    const Process* to = link.to.empty() ? &platform : find(link.to);
    if (from != nullptr && to != nullptr) connectPackage(link.package, *from, *to);
  }
}

void RobotProgram::Implementation::connectDebugging() {
  for (const Process* process : processes) {
    if (process == debugProcess) continue;
    connectPackage("debug/queue/" + process->name(), *process, *debugProcess);
    connectPackage("debug/requests/" + process->name(), *debugProcess, *process);
  }
}

std::vector<std::string> debugPackages() {
  return {kRemoteMotion.name, kColorTable.name, kDriveGoal.name};
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
}

void RobotProgram::setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) {
  for (Process* process : implementation_->processes) {
    if (auto* tasks = dynamic_cast<TaskProcess*>(process)) tasks->setKeys(modes);
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
