// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/DebugProcess.h"

#include <algorithm>
#include <set>

#include "robotlink/base/BoundedQueue.h"
#include "robotlink/debugging/DebugContext.h"
#include "robotlink/debugging/ProcessChannel.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/TaskTables.h"
#include "robotlink/debugging/program/JoinedTables.h"
#include "robotlink/debugging/program/OtherPrograms.h"
#include "robotlink/debugging/program/ProcessTable.h"
#include "robotlink/debugging/program/RequestedPackages.h"
#include "robotlink/debugging/program/UserPackages.h"
#include "robotlink/packages/Packages.h"

namespace robotlink {

using robotcontrol::Request;

namespace {

constexpr std::size_t kMaxWaitingRequests = 1000;
constexpr Duration kProcessTablePeriod = std::chrono::milliseconds(500);

}  // namespace

struct DebugProcess::Implementation {
  Implementation(DebugProcess& owner, const Clock& clock, DebugRoutes given)
      : process(owner),
        routes(std::move(given)),
        debug(owner.name(), clock, {}),
        requested(owner, debug),
        packages(owner, debug, routes.joints),
        others(owner),
        solutionsDue(!routes.absent.empty()) {
    for (const auto& list : routes.processes) {
      names.push_back(list.process);
      channels.push_back(std::make_unique<ProcessChannel>(owner, list.process));
    }
  }

  void followPrograms();
  void takeQueues();
  void takeRequested();
  void joinOwnKeys();
  /// The process that handles a request, and the task, key or package that it is about. An empty or unknown
  /// process means that none handles it.
  struct Target {
    std::string process;
    std::string what;
  };
  void takeRequests();
  void route(const Request& request);
  std::optional<Target> targetOf(const Request& request) const;
  std::string refusal(const Request& request) const;
  // The handlers of requests that no task process handles.
  void setKey(const Request& request);
  void sendTablesAgain(const Request& request);
  void recordPackages(const Request& request);
  void setPackage(const Request& request);
  std::string whyNotBy(const Target& target) const;
  std::string whyNobodyHas(const std::string& what) const;
  bool isForLater(const Request& request, const AnySender& sender) const;
  std::string whyNotSent(const Request& request) const;
  std::string whyNotSet(const std::string& package) const;
  void sendToAll(const Request& request);
  /// `taken` is the checksum of the value that was passed on.
  void answer(const Request& request, const std::string& refusal, std::uint64_t taken = 0);
  void noticeStopped();
  void sendTables();
  void fillProcesses(robotcontrol::ProcessTable& to) const;
  const Process* watchedProcess(const std::string& name) const;
  std::string stoppedText(const Process& stopped) const;

  DebugProcess& process;
  DebugRoutes routes;
  DebugContext debug;
  RequestedPackages requested;
  UserPackages packages;
  std::vector<std::string> names;
  std::vector<std::unique_ptr<ProcessChannel>> channels;
  OtherPrograms others;
  std::vector<const Process*> watched;
  // Processes that are known to have stopped.
  std::set<std::string> known;
  std::map<std::string, std::uint64_t> dropped;
  JoinedTables tables;
  std::optional<Instant> processTableDue;
  bool solutionsDue = false;  // to be sent although no process has sent its own
  Listener listener;
  BoundedQueue<Request> inbox{kMaxWaitingRequests};

  using Handler = void (Implementation::*)(const Request& request);
  static constexpr RequestRow<Handler> kRows[]{{Request::kSetKey, &Implementation::setKey},
                                               {Request::kSendTables, &Implementation::sendTablesAgain},
                                               {Request::kRecordPackages, &Implementation::recordPackages},
                                               {Request::kSetPackage, &Implementation::setPackage}};
};

bool DebugProcess::fulfills(const Request& request) {
  return UserPackages::has(request) || rowOf(Implementation::kRows, request.what_case()) != nullptr;
}

DebugProcess::DebugProcess(std::string name, const Clock& clock, const DebugRoutes& routes)
    : Process(std::move(name), clock),
      implementation_(std::make_unique<Implementation>(*this, clock, routes)) {}

DebugProcess::~DebugProcess() {
  stop();
}

void DebugProcess::setListener(Listener listener) {
  implementation_->listener = std::move(listener);
}

void DebugProcess::watch(const Process& process) {
  implementation_->watched.push_back(&process);
}

std::string DebugProcess::missingProcess() const {
  return implementation_->others.missingProcess();
}

void DebugProcess::addProgram(const std::string& program, const OtherPrograms::Questions& processes,
                              const std::set<std::string>& commanding) {
  std::vector<ProcessChannel*> channels;
  for (const auto& channel : implementation_->channels) {
    if (processes.contains(channel->process())) channels.push_back(channel.get());
  }
  implementation_->others.add(program, std::move(channels), processes, commanding);
}

void DebugProcess::askOtherPrograms(const Request& request) {
  implementation_->others.rememberForAll(request);
}

void DebugProcess::showOnRequest(AnySender& sender) {
  implementation_->requested.add(sender);
  implementation_->joinOwnKeys();
}

PackagePtr DebugProcess::newest(const std::string& package) const {
  return implementation_->requested.newest(package);
}

void DebugProcess::offer(const PackagePtr& package) {
  implementation_->packages.offer(package);
}

bool DebugProcess::request(const Request& request) {
  return implementation_->inbox.push(request);
}

std::string DebugProcess::refusal(const Request& request) const {
  return stopped() ? implementation_->stoppedText(*this) : implementation_->refusal(request);
}

std::string DebugProcess::processAsked(const Request& request) const {
  const auto target = implementation_->targetOf(request);
  return target ? target->process : std::string();
}

void DebugProcess::setTables(Tables ofProcesses) {
  for (auto& [process, tables] : ofProcesses) {
    implementation_->tables.setKeys(process, std::move(tables.first));
    implementation_->tables.setSolutions(process, std::move(tables.second));
  }
}

void DebugProcess::describe(const Tables& ofProcesses, robotcontrol::KeyTable& keys,
                            robotcontrol::SolutionTable& solutions,
                            robotcontrol::ProcessTable& processes) const {
  const Implementation& self = *implementation_;
  JoinedTables joined;
  robotcontrol::KeyTable own;
  self.requested.fillKeys(own);
  joined.setKeys(name(), std::move(own));
  for (const auto& [process, tables] : ofProcesses) {
    joined.setKeys(process, tables.first);
    joined.setSolutions(process, tables.second);
  }
  joined.fillKeys(keys);
  joined.fillSolutions(self.names, solutions);
  addAbsentTasks(self.routes.absent, solutions);
  self.fillProcesses(processes);
}

std::optional<robotcontrol::ColorTable> DebugProcess::colorTableInUse() const {
  return implementation_->packages.colorTableInUse();
}

std::optional<robotcontrol::MotionTable> DebugProcess::motions(
    const std::vector<robotcontrol::MotionText>& more) const {
  return implementation_->packages.motions(more);
}

void DebugProcess::execute() {
  Implementation& self = *implementation_;
  self.debug.beginFrame(frameTime(), frames() + 1);
  self.followPrograms();
  self.takeQueues();
  self.takeRequested();
  self.noticeStopped();
  self.takeRequests();
  for (const auto& channel : self.channels) channel->send();
  self.sendTables();
  self.debug.endFrame();
  auto queue = self.debug.takeQueue();
  if (self.listener) self.listener(std::move(queue));
}

void DebugProcess::Implementation::followPrograms() {
  for (const std::string& news : others.update()) {
    debug.text(Level::kWarning, process.name(), news);
    processTableDue.reset();
  }
}

void DebugProcess::Implementation::takeQueues() {
  for (const auto& channel : channels) {
    auto queue = channel->takeQueue();
    if (!queue) continue;
    dropped[channel->process()] = queue->dropped;
    tables.notice(*queue);
    if (listener) listener(std::move(queue));
  }
}

void DebugProcess::Implementation::takeRequested() {
  if (!requested.publishNews()) return;
  joinOwnKeys();
  tables.publishKeys();
}

void DebugProcess::Implementation::joinOwnKeys() {
  robotcontrol::KeyTable keys;
  requested.fillKeys(keys);
  tables.setKeys(process.name(), std::move(keys));
}

// ---- Requests

void DebugProcess::Implementation::takeRequests() {
  for (const Request& request : inbox.drain()) route(request);
}

void DebugProcess::Implementation::route(const Request& request) {
  if (const std::string why = refusal(request); !why.empty()) return answer(request, why);
  if (const auto target = targetOf(request)) {
    const auto channel = std::find_if(channels.begin(), channels.end(),
                                      [&](const auto& entry) { return entry->process() == target->process; });
    others.remember(target->process, request);
    return (*channel)->add(request);
  }
  if (UserPackages::has(request)) return answer(request, "", packages.send(request));
  (this->*rowOf(kRows, request.what_case())->handler)(request);
}

/// Returns nothing if the debug process itself handles the request.
std::optional<DebugProcess::Implementation::Target> DebugProcess::Implementation::targetOf(
    const Request& request) const {
  const RequestKind& kind = kindOf(request);
  if (kind.task != nullptr) return Target{routes.processOf(kind.task(request)), kind.task(request)};
  if (const auto shadow = shadowOfKey(request.set_key().name()))
    return Target{routes.processOf(shadow->task), shadow->task};
  const std::string package = request.has_set_key() ? packageOfKey(request.set_key().name()) : "";
  if (package.empty() || requested.has(package)) return std::nullopt;
  const auto owner = routes.packages.find(package);
  return Target{owner != routes.packages.end() ? owner->second : "", request.set_key().name()};
}

/// Empty if the request will be done here or forwarded.
std::string DebugProcess::Implementation::refusal(const Request& request) const {
  if (std::string wrong = wrongWith(request); !wrong.empty()) return wrong;
  if (const auto target = targetOf(request)) return whyNotBy(*target);
  if (UserPackages::has(request)) return whyNotSent(request);
  if (request.has_set_package()) return whyNotSet(request.set_package().package());
  return rowOf(kRows, request.what_case()) != nullptr
             ? ""
             : "a robot's program cannot do this; ask its platform or the simulation";
}

/// Empty if a task can use the package that is asked for.
std::string DebugProcess::Implementation::whyNotSent(const Request& request) const {
  const AnySender& sender = packages.senderFor(request);
  if (sender.connected()) return packages.whyNot(request);
  if (isForLater(request, sender)) return "";
  const auto receiver = routes.packages.find(sender.package());
  const std::string why =
      receiver == routes.packages.end() ? "" : whyNotBy({receiver->second, receiver->second});
  return why.empty() ? std::string("no task of this layout ") + UserPackages::useOf(request) : why;
}

/// Whether a program that does not run now is told about a cancellation when it runs again: it
/// must not continue to a goal that was given up.
bool DebugProcess::Implementation::isForLater(const Request& request, const AnySender& sender) const {
  const RequestKind& kind = kindOf(request);
  const auto receiver = routes.packages.find(sender.package());
  return kind.removes != nullptr && kind.removes(request) && receiver != routes.packages.end() &&
         others.runs(receiver->second);
}

void DebugProcess::Implementation::setKey(const Request& request) {
  if (requested.show(packageOfKey(request.set_key().name()), request.set_key().mode())) {
    joinOwnKeys();
    tables.publishKeys();
  } else {
    sendToAll(request);
  }
  answer(request, "");
}

void DebugProcess::Implementation::sendTablesAgain(const Request& request) {
  sendToAll(request);
  processTableDue.reset();
  solutionsDue = !routes.absent.empty();
  packages.publishAgain();
  answer(request, "");
}

void DebugProcess::Implementation::recordPackages(const Request& request) {
  sendToAll(request);
  answer(request, "");
}

/// Processes know themselves whether a value replaces the package there: all that receive readings do.
void DebugProcess::Implementation::setPackage(const Request& request) {
  sendToAll(request);
  processTableDue.reset();
  answer(request, "");
}

/// Empty if there is a task that sends or receives the package, and whose process runs.
std::string DebugProcess::Implementation::whyNotSet(const std::string& package) const {
  const auto owner = routes.packages.find(package);
  return whyNotBy({owner == routes.packages.end() ? "" : owner->second, package});
}

std::string DebugProcess::Implementation::whyNotBy(const Target& target) const {
  if (std::find(names.begin(), names.end(), target.process) == names.end()) return whyNobodyHas(target.what);
  if (std::string why = others.whyNot(target.process); !why.empty()) return why;
  const Process* asked = watchedProcess(target.process);
  return asked != nullptr && asked->stopped() ? stoppedText(*asked) : "";
}

std::string DebugProcess::Implementation::whyNobodyHas(const std::string& what) const {
  for (const Layout::Absence& absence : routes.absent) {
    if (absence.task == what) return "task " + what + " does not run because " + absence.reason;
  }
  return "no process of this layout has '" + what + "'";
}

void DebugProcess::Implementation::sendToAll(const Request& request) {
  for (const auto& channel : channels) {
    const Process* target = watchedProcess(channel->process());
    others.remember(channel->process(), request);
    if (!others.whyNot(channel->process()).empty()) continue;  // the process gets it when it runs
    if (target == nullptr || !target->stopped()) channel->add(request);
  }
}

void DebugProcess::Implementation::answer(const Request& request, const std::string& refusal,
                                          std::uint64_t taken) {
  auto& published = debug.add<robotcontrol::RequestResult>(streams::kResults);
  published.set_id(request.id());
  published.set_accepted(refusal.empty());
  published.set_reason(refusal);
  published.set_checksum(taken);
}

// ---- Processes

const Process* DebugProcess::Implementation::watchedProcess(const std::string& name) const {
  const auto found =
      std::find_if(watched.begin(), watched.end(), [&](const Process* p) { return p->name() == name; });
  return found == watched.end() ? nullptr : *found;
}

std::string DebugProcess::Implementation::stoppedText(const Process& stopped) const {
  const std::string failure = stopped.failure();
  return "process " + stopped.name() + (failure.empty() ? " has stopped" : " has failed: " + failure);
}

/// Logs the end of a process once, and answers the requests that it will never process.
void DebugProcess::Implementation::noticeStopped() {
  for (const Process* watchedOne : watched) {
    if (!watchedOne->stopped() || !known.insert(watchedOne->name()).second) continue;
    if (!watchedOne->failure().empty())
      debug.text(Level::kError, watchedOne->name(), stoppedText(*watchedOne));
    processTableDue.reset();
  }
  for (const auto& channel : channels) {
    const std::string why = known.contains(channel->process())
                                ? stoppedText(*watchedProcess(channel->process()))
                                : others.whyNot(channel->process());
    if (why.empty()) continue;
    for (const Request& request : channel->takePending()) {
      // Requests to all processes were answered here.
      if (targetOf(request)) answer(request, why);
    }
  }
}

void DebugProcess::Implementation::sendTables() {
  if (tables.takeKeysChanged()) tables.fillKeys(debug.add<robotcontrol::KeyTable>(streams::kKeys));
  if (tables.takeSolutionsChanged() || solutionsDue) {
    solutionsDue = false;
    auto& table = debug.add<robotcontrol::SolutionTable>(streams::kSolutions);
    tables.fillSolutions(names, table);
    addAbsentTasks(routes.absent, table);
  }
  packages.publishChanged();
  const Instant now = process.frameTime();
  const bool due =
      !processTableDue || now >= *processTableDue || now + kProcessTablePeriod < *processTableDue;
  if (!due) return;
  processTableDue = now + kProcessTablePeriod;
  fillProcesses(debug.add<robotcontrol::ProcessTable>(streams::kProcesses));
}

void DebugProcess::Implementation::fillProcesses(robotcontrol::ProcessTable& to) const {
  for (const Process* watchedOne : watched) robotlink::describe(*watchedOne, *to.add_processes());
  others.fillProcesses(to);
  for (auto& row : *to.mutable_processes()) {
    if (const auto count = dropped.find(row.name()); count != dropped.end()) row.set_dropped(count->second);
    for (const auto& list : routes.processes) {
      if (list.process != row.name()) continue;
      for (const std::string& task : list.tasks) row.add_tasks(task);
    }
  }
}

}  // namespace robotlink
