// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/TaskProcess.h"

#include <algorithm>
#include <chrono>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/TaskTables.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/ParsedMessage.h"

namespace robotlink {

using robotcontrol::Request;
using robotcontrol::RequestQueue;

namespace {

// The only real time in a process, for measuring its tasks.
using Stopwatch = std::chrono::steady_clock;

tl::unexpected<Error> refused(std::string id, std::string text) {
  return failure(std::move(id), std::move(text));
}

}  // namespace

struct TaskProcess::Implementation {
  Implementation(TaskProcess& owner, const Setup& given, const Clock& clock)
      : process(owner),
        setup(given),
        catalog(registeredTasks()),
        debug(given.process.name, clock, {}),
        board(owner, debug),
        requests(owner, "debug/requests/" + given.process.name, Blocking::kNo),
        queue(owner, "debug/queue/" + given.process.name, Blocking::kNo) {
    debug.setRobot(given.robot.name);
  }

  Errors build(const Clock& clock);
  void startShadows();
  Blocking blockingOutput(const std::string& package) const;
  void connectPackages();
  bool isOfTask(const LayoutLink& link) const;
  void runTasks();
  void takeRequests();
  // The handlers of requests.
  void setKey(const Request& request);
  void selectSolution(const Request& request);
  void getParameters(const Request& request);
  void setParameters(const Request& request);
  void recordPackages(const Request& request);
  void setPackage(const Request& request);
  void sendTablesAgain(const Request& request);

  void setKey(int key, const robotcontrol::KeyMode& mode);
  Result<void> select(const std::string& task, const std::string& solution);
  Result<void> setShadow(const ShadowName& shadow, const robotcontrol::KeyMode& mode);
  Result<TaskRunner*> selectable(const std::string& task, const std::string& solution) const;
  Result<void> publishParameters(const std::string& task, const std::string& solution);
  void answer(const Request& request, const Result<void>& result);
  Result<std::pair<TaskRunner*, SolutionParameters*>> parametersOf(const std::string& task,
                                                                   const std::string& solution);
  TaskRunner* runner(const std::string& task) const;
  void noticeExpiredKeys();
  void sendTables();
  void sendQueue();

  TaskProcess& process;
  Setup setup;
  TaskCatalog catalog;
  DebugContext debug;
  PackageBoard board;
  AnyReceiver requests;
  AnySender queue;
  TaskRunners tasks;
  void noticeRestart();
  /// The debug process in another program whose requests are counted.
  std::uint64_t generation = 0;
  // The number of the last one.
  std::uint64_t requestsDone = 0;
  // The id of this request.
  std::uint64_t requestDone = 0;
  std::uint64_t queuesSent = 0;
  std::uint64_t queuesTaken = 0;
  bool keysChanged = true;
  bool solutionsChanged = true;
  // Keys that are on for n times.
  std::vector<int> limitedKeys;

  /// The requests that a task process gets.
  static constexpr RequestRow<void (Implementation::*)(const Request&)> kRows[]{
      {Request::kSetKey, &Implementation::setKey},
      {Request::kSelectSolution, &Implementation::selectSolution},
      {Request::kGetParameters, &Implementation::getParameters},
      {Request::kSetParameters, &Implementation::setParameters},
      {Request::kRecordPackages, &Implementation::recordPackages},
      {Request::kSetPackage, &Implementation::setPackage},
      {Request::kSendTables, &Implementation::sendTablesAgain}};
};

bool TaskProcess::fulfills(const Request& request) {
  return rowOf(Implementation::kRows, request.what_case()) != nullptr;
}

// ---- Construction

TaskProcess::TaskProcess(const Setup& setup, const Clock& clock)
    : Process(setup.process.name, clock),
      implementation_(std::make_unique<Implementation>(*this, setup, clock)) {
  setPeriod(setup.process.period);
  setPriority(setup.process.priority);
}

TaskProcess::~TaskProcess() {
  stop();
}

tl::expected<std::unique_ptr<TaskProcess>, Errors> TaskProcess::create(const Setup& setup,
                                                                       const Clock& clock) {
  std::unique_ptr<TaskProcess> process(new TaskProcess(setup, clock));
  Errors errors = process->implementation_->build(clock);
  if (!errors.empty()) return tl::unexpected(std::move(errors));
  return process;
}

Errors TaskProcess::Implementation::build(const Clock& clock) {
  connectPackages();
  Errors errors;
  for (const Layout::Task& task : setup.process.tasks) {
    auto& runner = *tasks.emplace_back(std::make_unique<TaskRunner>(
        task.task, TaskRunner::Environment{setup.robot, clock, debug, board, setup.layout.withheld,
                                           &process.activitySlot()}));
    const Errors wrong = runner.loadParameters(setup.parameters);
    errors.insert(errors.end(), wrong.begin(), wrong.end());
    if (!wrong.empty()) continue;
    if (auto selected = runner.select(task.solution); !selected) {
      selected.error().where = task.where;
      errors.push_back(selected.error());
    }
  }
  if (errors.empty()) startShadows();
  return errors;
}

/// Starts the shadows. One that cannot run, such as an oracle without a simulator, is left out: it is unused.
void TaskProcess::Implementation::startShadows() {
  robotcontrol::KeyMode always;
  always.set_kind(robotcontrol::KeyMode::ALWAYS);
  for (const Layout::Task& shadow : setup.layout.shadows) {
    if (runner(shadow.task) == nullptr) continue;
    if (const auto started = setShadow({shadow.task, shadow.solution}, always); !started)
      debug.text(Level::kWarning, shadow.task, "no shadow: " + started.error().text);
  }
}

Blocking TaskProcess::Implementation::blockingOutput(const std::string& package) const {
  const auto& outputs = setup.process.blockingOutputs;
  return std::any_of(outputs.begin(), outputs.end(),
                     [&](const Layout::Input& output) { return output.package == package; })
             ? Blocking::kYes
             : Blocking::kNo;
}

/// Whether a task sends the package, rather than the platform or the debug process.
bool TaskProcess::Implementation::isOfTask(const LayoutLink& link) const {
  return std::ranges::any_of(setup.layout.processes, [&](const Layout::Process& process) {
    return process.name == link.from && !process.debug;
  });
}

void TaskProcess::Implementation::connectPackages() {
  for (const LayoutLink& link : layoutLinks(setup.layout, catalog, setup.platform)) {
    if (link.to == setup.process.name) {
      board.addReceiver(link.package, link.blocking ? Blocking::kYes : Blocking::kNo);
      board.entry(link.package).settable = !isOfTask(link);
    }
  }
  for (const Layout::Task& task : setup.process.tasks) {
    for (const TaskCatalog::Solution& solution : catalog.tasks[task.task].solutions) {
      for (const std::string& package : solution.outputs) {
        if (setup.layout.withheld.contains(package)) continue;
        board.addSender(package, blockingOutput(package));
        board.entry(package).settable = true;
      }
    }
  }
  for (const auto* names : {&setup.platform.offers, &setup.platform.takes}) {
    for (const std::string& package : *names) board.entry(package).ofPlatform = true;
  }
  for (const auto& [package, owner] : debugRoutes(setup.layout, catalog, setup.platform).packages) {
    if (owner == setup.process.name) board.entry(package).shown = true;
  }
}

void TaskProcess::recordPackages(const std::set<std::string>& packages) {
  implementation_->board.record(packages);
}

void TaskProcess::setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) {
  for (const auto& [name, mode] : modes) {
    if (const std::string package = packageOfKey(name); !package.empty()) {
      implementation_->board.show(package, mode);
    } else if (const auto shadow = shadowOfKey(name)) {
      if (implementation_->runner(shadow->task) != nullptr) (void)implementation_->setShadow(*shadow, mode);
    } else {
      implementation_->setKey(DebugKey::find(name), mode);
    }
  }
}

std::vector<robotcontrol::ParameterValues> TaskProcess::parameters() const {
  std::vector<robotcontrol::ParameterValues> result;
  for (const auto& task : implementation_->tasks) {
    for (const SolutionDescription* solution : task->solutions()) {
      const SolutionParameters* values = task->parameters(solution->name);
      if (values == nullptr || values->message() == nullptr) continue;
      auto& described = result.emplace_back();
      described.set_task(task->task());
      described.set_solution(solution->name);
      values->describe(described);
    }
  }
  return result;
}

std::string TaskProcess::activeSolution(const std::string& task) const {
  const TaskRunner* found = implementation_->runner(task);
  return found != nullptr ? found->active() : std::string();
}

TaskRunner* TaskProcess::Implementation::runner(const std::string& task) const {
  const auto found =
      std::find_if(tasks.begin(), tasks.end(), [&](const auto& entry) { return entry->task() == task; });
  return found == tasks.end() ? nullptr : found->get();
}

// ---- A frame

void TaskProcess::execute() {
  Implementation& self = *implementation_;
  self.debug.beginFrame(frameTime(), frames() + 1);
  self.takeRequests();
  self.board.beginFrame();
  try {
    self.runTasks();
  } catch (...) {
    // Messages sent before the failure help to find its cause.
    self.debug.endFrame();
    self.sendQueue();
    throw;
  }
  self.board.endFrame();
  self.noticeExpiredKeys();
  self.sendTables();
  self.debug.endFrame();
  self.sendQueue();
}

void TaskProcess::Implementation::runTasks() {
  if (!debug.on(kTimingKey)) {
    for (const auto& task : tasks) task->execute();
    return;
  }
  robotcontrol::StopwatchTimes times;
  {
    const PackageBoard::Watch watch(board, times);
    const auto start = Stopwatch::now();
    for (const auto& task : tasks) task->execute(&times);
    times.add_entries()->set_seconds(std::chrono::duration<double>(Stopwatch::now() - start).count());
  }
  times.set_clock_stands(process.clock().now() == process.frameTime());
  assign(*times.mutable_timestamp(), process.frameTime());
  debug.add<robotcontrol::StopwatchTimes>(streams::kStopwatches + process.name()) = std::move(times);
}

void TaskProcess::Implementation::noticeExpiredKeys() {
  const std::size_t limited = limitedKeys.size();
  std::erase_if(limitedKeys,
                [this](int key) { return debug.mode(key).kind() != robotcontrol::KeyMode::N_TIMES; });
  if (limitedKeys.size() != limited || board.takeModeChange()) keysChanged = true;
  for (const auto& task : tasks) keysChanged |= task->takeShadowEnd();
}

void TaskProcess::Implementation::sendTables() {
  if (std::exchange(keysChanged, false)) {
    fillKeyTable(tasks, board, debug,
                 debug.add<robotcontrol::KeyTable>(streams::kKeys + ("/" + process.name())));
  }
  if (std::exchange(solutionsChanged, false)) {
    fillSolutionTable(process.name(), tasks, setup.layout, catalog, setup.platform,
                      debug.add<robotcontrol::SolutionTable>(streams::kSolutions + ("/" + process.name())));
  }
}

/// Sends a queue only after the previous one was acknowledged, because a newer package would replace it.
void TaskProcess::Implementation::sendQueue() {
  if (queuesSent > queuesTaken || !debug.hasQueue() || !queue.connected()) return;
  const std::shared_ptr<SharedDebugQueue> taken = debug.takeQueue();
  taken->number = ++queuesSent;
  taken->requestsDone = requestsDone;
  taken->requestDone = requestDone;
  queue.send(packageOf(taken));
}

// ---- Requests

/// A debug process that was started again, in another program, counts requests from the beginning, and waits
/// for no queue. Queues are counted on, so that what it confirms is never taken for a confirmation of another
/// one.
void TaskProcess::Implementation::noticeRestart() {
  if (std::exchange(generation, requests.generation()) == generation) return;
  requestsDone = 0;
  queuesTaken = queuesSent;
  keysChanged = solutionsChanged = true;
}

void TaskProcess::Implementation::takeRequests() {
  noticeRestart();
  if (!requests.isNew()) return;
  const auto& package = static_cast<const RequestQueue&>(*requests.value());
  // After a restart it confirms whatever was sent so far, but nothing that is still to be sent.
  queuesTaken = std::max(queuesTaken, std::min(package.queues_taken(), queuesSent));
  for (int i = 0; i < package.requests_size(); ++i) {
    const std::uint64_t number = package.first_number() + static_cast<std::uint64_t>(i);
    // An earlier package contained this request already.
    if (number <= requestsDone) continue;
    // The debug process passes on no others.
    if (const auto* row = rowOf(kRows, package.requests(i).what_case()))
      (this->*row->handler)(package.requests(i));
    requestsDone = number;
    requestDone = package.requests(i).id();
  }
}

/// Keys of the code belong to all processes, so the debug process answers for them; the key of a package
/// belongs to the process that publishes it.
void TaskProcess::Implementation::setKey(const Request& request) {
  const robotcontrol::SetKey& details = request.set_key();
  keysChanged = true;
  if (const std::string package = packageOfKey(details.name()); !package.empty()) {
    if (board.show(package, details.mode())) return answer(request, {});
    return answer(request, refused("key.unknown", "process " + process.name() + " does not show " + package));
  }
  if (const auto shadow = shadowOfKey(details.name()))
    return answer(request, setShadow(*shadow, details.mode()));
  setKey(DebugKey::find(details.name()), details.mode());
}

Result<void> TaskProcess::Implementation::setShadow(const ShadowName& shadow,
                                                    const robotcontrol::KeyMode& mode) {
  const auto found = selectable(shadow.task, shadow.solution);
  if (!found && mode.kind() != robotcontrol::KeyMode::OFF) return tl::unexpected(found.error());
  return found ? (*found)->setShadow(shadow.solution, mode) : Result<void>();
}

void TaskProcess::Implementation::setKey(int key, const robotcontrol::KeyMode& mode) {
  debug.setMode(key, mode);
  for (const auto& task : tasks) task->setKey(key, mode);
  std::erase(limitedKeys, key);
  if (debug.mode(key).kind() == robotcontrol::KeyMode::N_TIMES) limitedKeys.push_back(key);
}

Result<TaskRunner*> TaskProcess::Implementation::selectable(const std::string& task,
                                                            const std::string& solution) const {
  TaskRunner* found = runner(task);
  if (found == nullptr)
    return refused("solution.task", "process " + process.name() + " does not do task " + task);
  if (SolutionRegistry::find(task, solution) != nullptr) {
    const std::string reason = unavailability(setup.layout, catalog, setup.platform, task, solution);
    if (!reason.empty())
      return refused("solution.unavailable", "solution " + solution + " of " + task + " is " + reason);
  }
  return found;
}

Result<void> TaskProcess::Implementation::select(const std::string& task, const std::string& solution) {
  const auto found = selectable(task, solution);
  if (!found) return tl::unexpected(found.error());
  auto selected = (*found)->select(solution);
  if (selected) keysChanged = solutionsChanged = true;
  return selected;
}

Result<void> TaskProcess::trySolution(const std::string& task, const std::string& solution) const {
  const auto found = implementation_->selectable(task, solution);
  if (!found) return tl::unexpected(found.error());
  return (*found)->trySolution(solution);
}

PackagePtr TaskProcess::newest(const std::string& package) const {
  for (const PackageBoard::Entry* entry : implementation_->board.shown()) {
    if (entry->name == package) return entry->value;
  }
  return nullptr;
}

bool TaskProcess::canSet(const std::string& package) const {
  return implementation_->board.isSettable(package);
}

const SolutionParameters* TaskProcess::solutionParameters(const std::string& task,
                                                          const std::string& solution) const {
  const TaskRunner* found = implementation_->runner(task);
  return found == nullptr ? nullptr : found->parameters(solution.empty() ? found->active() : solution);
}

void TaskProcess::describe(const std::map<std::string, std::string>& chosen, robotcontrol::KeyTable& keys,
                           robotcontrol::SolutionTable& solutions) const {
  const Implementation& self = *implementation_;
  fillKeyTable(self.tasks, self.board, self.debug, keys, chosen);
  fillSolutionTable(name(), self.tasks, self.setup.layout, self.catalog, self.setup.platform, solutions);
  for (auto& task : *solutions.mutable_tasks()) {
    if (const auto other = chosen.find(task.name()); other != chosen.end()) task.set_active(other->second);
  }
}

Result<std::pair<TaskRunner*, SolutionParameters*>> TaskProcess::Implementation::parametersOf(
    const std::string& task, const std::string& solution) {
  TaskRunner* found = runner(task);
  if (found == nullptr)
    return refused("solution.task", "process " + process.name() + " does not do task " + task);
  SolutionParameters* parameters = found->parameters(solution.empty() ? found->active() : solution);
  if (parameters == nullptr)
    return refused("solution.unknown", "task " + task + " has no solution '" + solution + "'");
  if (parameters->message() == nullptr) {
    return refused("parameters.none", "solution " + (solution.empty() ? found->active() : solution) + " of " +
                                          task + " has no parameters");
  }
  return std::pair(found, parameters);
}

void TaskProcess::Implementation::selectSolution(const Request& request) {
  answer(request, select(request.select_solution().task(), request.select_solution().solution()));
}

void TaskProcess::Implementation::getParameters(const Request& request) {
  answer(request, publishParameters(request.get_parameters().task(), request.get_parameters().solution()));
}

void TaskProcess::Implementation::setParameters(const Request& request) {
  const robotcontrol::SetParameters& details = request.set_parameters();
  const auto found = parametersOf(details.task(), details.solution());
  if (!found) return answer(request, tl::unexpected(found.error()));
  auto done = found->second->set(details.value());
  if (done && details.saved()) found->second->markSaved();
  // The new values go to everyone who displays them.
  if (done) done = publishParameters(details.task(), details.solution());
  answer(request, done);
}

Result<void> TaskProcess::Implementation::publishParameters(const std::string& task,
                                                            const std::string& solution) {
  const auto found = parametersOf(task, solution);
  if (!found) return tl::unexpected(found.error());
  const std::string name = solution.empty() ? found->first->active() : solution;
  auto& values = debug.add<robotcontrol::ParameterValues>(streams::kParameters + (task + "/" + name));
  values.set_task(task);
  values.set_solution(name);
  found->second->describe(values);
  return {};
}

void TaskProcess::Implementation::recordPackages(const Request& request) {
  const auto& packages = request.record_packages().packages();
  board.record({packages.begin(), packages.end()});
}

/// The debug process has checked the value, and answers.
void TaskProcess::Implementation::setPackage(const Request& request) {
  using robotcontrol::SetPackage;
  const SetPackage& set = request.set_package();
  if (set.mode() == SetPackage::RELEASE) return board.release(set.package());
  const PackagePtr value = parsedMessage(set.value().type(), set.value().data());
  if (!value) return;
  if (set.mode() == SetPackage::HOLD) {
    board.hold(set.package(), value);
  } else {
    board.setOnce(set.package(), value);
  }
}

void TaskProcess::Implementation::sendTablesAgain(const Request&) {
  keysChanged = solutionsChanged = true;
}

void TaskProcess::Implementation::answer(const Request& request, const Result<void>& result) {
  auto& published = debug.add<robotcontrol::RequestResult>(streams::kResults);
  published.set_id(request.id());
  published.set_accepted(result.has_value());
  if (!result) published.set_reason(result.error().text);
}

}  // namespace robotlink
