// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/program/RequestPreview.h"

#include "robotlink/debugging/ColorTableInUse.h"
#include "robotlink/debugging/DebugRoutes.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"
#include "robotlink/packages/Checksum.h"

namespace robotlink {

using robotcontrol::Request;

namespace {

std::string reasonOf(const Result<void>& result) {
  return result ? std::string() : result.error().text;
}

}  // namespace

const TaskProcess* RequestPreview::processOf(const Request& request) const {
  const std::string name = program_.debugProcess().processAsked(request);
  for (const Process* process : program_.processes()) {
    if (process->name() == name) return dynamic_cast<const TaskProcess*>(process);
  }
  return nullptr;
}

/// The effect of a request here, and the publication when it is accepted; null: none.
struct RequestPreview::Handlers {
  struct Handler {
    std::string (RequestPreview::*add)(const Request& request);
    void (RequestPreview::*describe)(const Request& request);
  };
  static constexpr RequestRow<Handler> kRows[]{
      {Request::kSetKey, {&RequestPreview::setKey, &RequestPreview::describePackage}},
      {Request::kSelectSolution, {&RequestPreview::selectSolution, nullptr}},
      {Request::kGetParameters, {&RequestPreview::getParameters, &RequestPreview::describeGotten}},
      {Request::kSetParameters, {&RequestPreview::setParameters, &RequestPreview::describeSet}},
      {Request::kSetColorTable, {&RequestPreview::setColorTable, nullptr}},
      {Request::kSetMotion, {&RequestPreview::setMotion, &RequestPreview::describeMotion}},
      {Request::kSetPackage, {&RequestPreview::setPackage, nullptr}}};
};

bool RequestPreview::handles(const Request& request) {
  return rowOf(Handlers::kRows, request.what_case()) != nullptr;
}

std::string RequestPreview::add(const Request& request) {
  std::string refusal = program_.debugProcess().refusal(request);
  const auto* row = rowOf(Handlers::kRows, request.what_case());
  if (refusal.empty() && row != nullptr) refusal = (this->*row->handler.add)(request);
  return refusal;
}

std::string RequestPreview::setKey(const Request& request) {
  const auto shadow = shadowOfKey(request.set_key().name());
  if (shadow && request.set_key().mode().kind() != robotcontrol::KeyMode::OFF) {
    const auto tried = processOf(request)->trySolution(shadow->task, shadow->solution);
    if (!tried) return tried.error().text;
  }
  keys_[request.set_key().name()] = request.set_key().mode();
  return "";
}

std::string RequestPreview::selectSolution(const Request& request) {
  const robotcontrol::SelectSolution& details = request.select_solution();
  std::string refusal = reasonOf(processOf(request)->trySolution(details.task(), details.solution()));
  if (refusal.empty()) solutions_[details.task()] = details.solution();
  return refusal;
}

std::string RequestPreview::getParameters(const Request& request) {
  const robotcontrol::GetParameters& details = request.get_parameters();
  const auto known = parametersOf(*processOf(request), details.task(), details.solution());
  return known ? std::string() : known.error().text;
}

std::string RequestPreview::setParameters(const Request& request) {
  const robotcontrol::SetParameters& details = request.set_parameters();
  const TaskProcess& process = *processOf(request);
  const auto known = parametersOf(process, details.task(), details.solution());
  if (!known) return known.error().text;
  const std::string solution = solutionOf(process, details.task(), details.solution());
  const auto entry = parameters_.try_emplace({details.task(), solution}, (*known)->clone()).first;
  const auto done = entry->second.set(details.value());
  if (done && details.saved()) entry->second.markSaved();
  return reasonOf(done);
}

std::string RequestPreview::setColorTable(const Request& request) {
  colorTable_ = colorTableInUse(&request.set_color_table().table());
  return "";
}

std::string RequestPreview::setMotion(const Request& request) {
  motions_.push_back(request.set_motion().motion());
  return "";
}

std::string RequestPreview::setPackage(const Request& request) {
  const auto& set = request.set_package();
  if (set.mode() != robotcontrol::SetPackage::ONCE)
    held_[set.package()] = set.mode() == robotcontrol::SetPackage::HOLD;
  return "";
}

/// Marks a process's packages that values of the user will replace.
void RequestPreview::describeHeld(robotcontrol::ProcessTable::Process& process) const {
  const TaskProcess* tasks = nullptr;
  for (const Process* one : program_.processes()) {
    if (one->name() == process.name()) tasks = dynamic_cast<const TaskProcess*>(one);
  }
  if (tasks == nullptr) return;
  for (auto* ports : {process.mutable_receivers(), process.mutable_senders()}) {
    for (auto& port : *ports) {
      const auto held = held_.find(port.package());
      if (held != held_.end() && tasks->canSet(port.package())) port.set_held(held->second);
    }
  }
}

void RequestPreview::describePackage(const Request& request) {
  const std::string package = packageOfKey(request.set_key().name());
  if (package.empty() || request.set_key().mode().kind() == robotcontrol::KeyMode::OFF) return;
  PackagePtr newest = program_.debugProcess().newest(package);
  for (const Process* process : program_.processes()) {
    const auto* tasks = dynamic_cast<const TaskProcess*>(process);
    if (tasks != nullptr && !newest) newest = tasks->newest(package);
  }
  if (newest) queue().messages.push_back({package, {}, std::move(newest)});
}

void RequestPreview::describeMotion(const Request&) {
  if (auto table = program_.debugProcess().motions(motions_))
    queue().add<robotcontrol::MotionTable>(streams::kMotions) = std::move(*table);
}

Result<const SolutionParameters*> RequestPreview::parametersOf(const TaskProcess& process,
                                                               const std::string& task,
                                                               const std::string& solution) const {
  const std::string meant = solutionOf(process, task, solution);
  const SolutionParameters* known = process.solutionParameters(task, meant);
  if (known == nullptr)
    return failure("solution.unknown", "task " + task + " has no solution '" + solution + "'");
  if (known->message() == nullptr)
    return failure("parameters.none", "solution " + meant + " of " + task + " has no parameters");
  return known;
}

/// The solution that is meant: the task's active one if `solution` is empty.
std::string RequestPreview::solutionOf(const TaskProcess& process, const std::string& task,
                                       const std::string& solution) const {
  if (!solution.empty()) return solution;
  const auto chosen = solutions_.find(task);
  return chosen != solutions_.end() ? chosen->second : process.activeSolution(task);
}

bool RequestPreview::answer(const Request& request) {
  const std::string refusal = add(request);
  const auto* row = rowOf(Handlers::kRows, request.what_case());
  if (refusal.empty()) {
    tablesAsked_ |= kindOf(request).publishesTables;
    if (row != nullptr && row->handler.describe != nullptr) (this->*row->handler.describe)(request);
  }
  auto& result = queue().add<robotcontrol::RequestResult>(streams::kResults);
  result.set_id(request.id());
  result.set_accepted(refusal.empty());
  result.set_reason(refusal);
  if (refusal.empty() && request.has_set_color_table()) {
    result.set_checksum(checksum(request.set_color_table().table()));
    describeColorTable();
  }
  return refusal.empty();
}

void RequestPreview::describeGotten(const Request& request) {
  describeParameters(*processOf(request), request.get_parameters().task(),
                     request.get_parameters().solution());
}

void RequestPreview::describeSet(const Request& request) {
  describeParameters(*processOf(request), request.set_parameters().task(),
                     request.set_parameters().solution());
}

void RequestPreview::describeParameters(const TaskProcess& process, const std::string& task,
                                        const std::string& asked) {
  const std::string solution = solutionOf(process, task, asked);
  auto& values = queue().add<robotcontrol::ParameterValues>(streams::kParameters + (task + "/" + solution));
  values.set_task(task);
  values.set_solution(solution);
  const auto changed = parameters_.find({task, solution});
  if (changed != parameters_.end()) {
    changed->second.describe(values);
  } else {
    process.solutionParameters(task, solution)->describe(values);
  }
}

void RequestPreview::describeTables() {
  auto& keys = queue().add<robotcontrol::KeyTable>(streams::kKeys);
  auto& solutions = queue().add<robotcontrol::SolutionTable>(streams::kSolutions);
  auto& processes = queue().add<robotcontrol::ProcessTable>(streams::kProcesses);
  program_.debugProcess().describe(program_.tables(solutions_), keys, solutions, processes);
  for (auto& process : *processes.mutable_processes()) describeHeld(process);
  for (auto& key : *keys.mutable_keys()) {
    if (const auto mode = keys_.find(key.name()); mode != keys_.end()) *key.mutable_mode() = mode->second;
  }
  describeColorTable();
  describeMotion({});
}

void RequestPreview::describeColorTable() {
  const auto inUse = colorTable_ ? colorTable_ : program_.debugProcess().colorTableInUse();
  if (inUse) queue().add<robotcontrol::ColorTable>(streams::kColorTableInUse) = *inUse;
}

SharedDebugQueue& RequestPreview::queue() {
  if (!queue_) queue_ = std::make_shared<SharedDebugQueue>();
  return *queue_;
}

std::shared_ptr<const SharedDebugQueue> RequestPreview::takeQueue(Instant now) {
  if (std::exchange(tablesAsked_, false)) describeTables();
  if (!queue_) return nullptr;
  for (SharedDebugMessage& message : queue_->messages) message.time = now;
  return std::exchange(queue_, nullptr);
}

}  // namespace robotlink
