// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnProgram.h"

#include <algorithm>
#include <optional>

#include "app/core/own/MirrorPlatform.h"
#include "app/core/own/PlatformPorts.h"
#include "app/core/own/ProgramChild.h"
#include "app/core/own/StandInProcess.h"
#include "app/core/program/HostedRobot.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"

namespace app {

using robotcontrol::HostingStatus;
using robotcontrol::WireAnswer;
using robotcontrol::WireOrder;
using robotlink::Errors;

namespace {

/// As many as a debug process takes.
constexpr std::size_t kMaxWaitingRequests = 1000;
/// More than a debug process has in the longest step.
constexpr std::uint64_t kMaxDebugFrames = 1000;
/// The name of what stands for the program in the executor.
constexpr char kExchange[] = "program";

robotcontrol::WireSetup setupOf(const HostedProgram::Parts& parts, const OwnProgram::Options& options) {
  const HostedRobot& robot = parts.robot;
  robotcontrol::WireSetup setup;
  setup.set_robot(robot.name);
  setup.set_team(robot.team);
  setup.set_kind(robot.description->name);
  setup.set_field_file(robot.fieldFile.string());
  setup.set_map_file(robot.mapFile.string());
  setup.set_layout_file(parts.file.string());
  for (const auto& process : parts.layout.processes) {
    for (const auto& task : process.tasks) {
      if (task.ownSolution.empty()) continue;
      auto& choice = *setup.add_solutions();
      choice.set_task(task.task);
      choice.set_solution(task.solution);
    }
  }
  for (const auto& values : parts.parameters.recorded) *setup.add_parameters() = values;
  setup.set_time(parts.platform.clock().now().time_since_epoch().count());
  setup.set_memory_limit(options.memoryLimit);
  return setup;
}

Errors errorsIn(const robotcontrol::WireProgram& program) {
  Errors errors;
  for (const auto& problem : program.problems()) {
    errors.push_back({problem.id(),
                      problem.text(),
                      {problem.arguments().begin(), problem.arguments().end()},
                      {problem.file(), problem.line(), problem.column()}});
  }
  return errors;
}

}  // namespace

struct OwnProgram::Implementation {
  Implementation(Options given, Parts parts, ProgramChild started)
      : options(std::move(given)),
        robot(parts.robot.name),
        platform(parts.platform),
        layout(std::move(parts.layout)),
        child(std::move(started)),
        exchange(kExchange, parts.platform.clock()),
        ports(parts.platform, exchange) {
    exchange.setFrame([this] { runStep(); });
    executed.push_back(&exchange);
  }

  Errors make(robotcontrol::WireSetup setup);
  void makeStandIns();
  // ---- Steps
  void startStep();
  void runStep();
  void apply(const robotcontrol::WireResult& result);
  void applyEvent(const robotcontrol::WireResult::Event& event);
  // ---- Questions between steps
  bool answers();
  /// Null if it does not answer in time, or has ended.
  const WireAnswer* ask(const WireOrder& order);
  // ---- What may go wrong
  void silent();
  void heard();
  void ended();
  void setState(HostingStatus::State state, const std::string& what, const std::string& stack);

  const Options options;
  const std::string robot;
  robotlink::Platform& platform;
  const robotlink::Layout layout;
  std::optional<ProgramChild> child;  // none: it has ended
  Listeners listeners;
  StandInProcess exchange;
  PlatformPorts ports;
  robotcontrol::WireProgram program;
  std::unique_ptr<StandInProcess> debugProcess;
  std::vector<std::unique_ptr<StandInProcess>> taskProcesses;
  std::vector<robotlink::Process*> executed;
  /// The requests of the next step.
  std::vector<robotcontrol::Request> requests;
  /// A step was sent and its result has not come.
  bool waits = false;
  /// The frames of the platform when the last step was sent.
  std::uint64_t platformFrames = 0;
  WireOrder order;
  WireAnswer answer;
  HostingStatus status;
};

// ---- Making it

HostedProgram::Maker OwnProgram::maker(Options options) {
  return [options = std::move(options)](Parts parts) -> Made {
    robotcontrol::WireSetup setup = setupOf(parts, options);
    auto child = ProgramChild::start(options.executable, parts.robot.name);
    if (!child) return tl::unexpected(Errors{child.error()});
    auto made = std::make_unique<Implementation>(options, std::move(parts), std::move(*child));
    if (Errors errors = made->make(std::move(setup)); !errors.empty())
      return tl::unexpected(std::move(errors));
    return std::unique_ptr<HostedProgram>(new OwnProgram(std::move(made)));
  };
}

Errors OwnProgram::Implementation::make(robotcontrol::WireSetup setup) {
  ports.describeTo(setup);
  *order.mutable_setup() = std::move(setup);
  ProgramLink& link = child->link();
  auto outcome = link.send(order, options.startLimit);
  if (outcome == ProgramLink::Outcome::kDone) outcome = link.receive(answer, options.startLimit);
  if (outcome != ProgramLink::Outcome::kDone || !answer.has_program()) {
    const bool late = outcome == ProgramLink::Outcome::kTimeout;
    const CrashReport report = late ? child->ask() : CrashReport();
    const std::string how = late ? "did not finish" : endInWords(child->wait());
    const std::string stack = late ? report.stack : child->report().stack;
    return {{"program.ended",
             "the program of " + robot + " " + how + " while its solutions were made" +
                 (stack.empty() ? "" : ":\n" + stack),
             {robot},
             {}}};
  }
  program.Swap(answer.mutable_program());
  if (Errors errors = errorsIn(program); !errors.empty()) return errors;
  makeStandIns();
  ports.connect(program.fed(), program.connected());
  platformFrames = platform.frames();
  status.set_own_process(true);
  status.set_pid(static_cast<std::uint32_t>(child->pid()));
  return {};
}

void OwnProgram::Implementation::makeStandIns() {
  for (const std::string& name : program.processes()) {
    auto made = std::make_unique<StandInProcess>(name, platform.clock());
    if (name == program.debug_process()) {
      for (const std::string& package : program.debug_senders()) made->addSender(package);
      debugProcess = std::move(made);
    } else {
      taskProcesses.push_back(std::move(made));
    }
  }
}

OwnProgram::OwnProgram(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

OwnProgram::~OwnProgram() {
  OwnProgram::stop();
}

void OwnProgram::stop() {
  implementation_->ports.close();
  implementation_->exchange.stop();
  // One that does not answer does not listen either.
  if (implementation_->child && implementation_->waits) implementation_->child->kill();
  implementation_->child.reset();
}

// ---- Steps

void OwnProgram::startStep() {
  implementation_->startStep();
}

void OwnProgram::Implementation::startStep() {
  if (!child || waits) return;
  order.Clear();
  auto& step = *order.mutable_step();
  step.set_time(platform.clock().now().time_since_epoch().count());
  step.set_platform_ran(std::exchange(platformFrames, platform.frames()) != platform.frames());
  ports.takeTo(*step.mutable_packages());
  for (auto& request : requests) *step.add_requests() = std::move(request);
  requests.clear();
  waits = true;
  if (child->link().send(order, options.patience) == ProgramLink::Outcome::kEnded) ended();
}

void OwnProgram::Implementation::runStep() {
  startStep();
  if (!child) return;
  const bool late = status.state() == HostingStatus::NOT_ANSWERING;
  switch (child->link().receive(answer, late ? std::chrono::milliseconds(0) : options.patience)) {
    case ProgramLink::Outcome::kTimeout:
      if (!late) silent();
      return;
    case ProgramLink::Outcome::kEnded:
      return ended();
    case ProgramLink::Outcome::kDone:
      break;
  }
  waits = false;
  if (late) heard();
  // It may be the late answer to a question.
  if (answer.has_result()) apply(answer.result());
}

void OwnProgram::Implementation::apply(const robotcontrol::WireResult& result) {
  // The debug process had at most one frame; those before published nothing. A program whose memory is
  // damaged may claim any number.
  const std::uint64_t ran = std::min(result.debug_frames(), debugProcess->frames() + kMaxDebugFrames);
  debugProcess->setFrame({});
  while (debugProcess->frames() + 1 < ran) debugProcess->runFrame();
  const auto events = [&] {
    for (const auto& event : result.events()) applyEvent(event);
  };
  if (debugProcess->frames() < ran) {
    debugProcess->setFrame(events);
    debugProcess->runFrame();
  } else {
    events();
  }
  ports.send(result.packages());
  ports.setConnected(result.connected());
}

void OwnProgram::Implementation::applyEvent(const robotcontrol::WireResult::Event& event) {
  if (event.has_queue()) {
    listeners.queue(robotlink::fromWire(event.queue()));
  } else if (event.has_debug_package()) {
    const auto& senders = debugProcess->senders();
    const auto package = packageIn(event.debug_package());
    if (package && event.debug_package().port() < senders.size())
      senders[event.debug_package().port()]->send(package);
  } else if (event.has_trouble()) {
    const auto found = std::ranges::find_if(
        taskProcesses, [&](const auto& process) { return process->name() == event.trouble().process(); });
    const robotlink::Process& process = found == taskProcesses.end() ? *debugProcess : **found;
    listeners.trouble(process, event.trouble().text());
  }
}

// ---- What may go wrong

void OwnProgram::Implementation::silent() {
  // Someone who looks at it step by step wants it to stay as it is.
  const CrashReport report = child->isDebugged() ? CrashReport() : child->ask();
  const auto seconds = std::chrono::duration<double>(options.patience).count();
  char text[32];
  std::snprintf(text, sizeof text, "%.3g s", seconds);
  ports.setBehind(true);
  setState(
      HostingStatus::NOT_ANSWERING,
      "The program of " + robot + " has not answered for " + text +
          (report.activity.empty() ? std::string() : ": it does not return" + report.place()) +
          ". The robot stands until it answers or is started again. A debugger looks at it with: gdb -p " +
          std::to_string(child->pid()),
      report.stack);
}

void OwnProgram::Implementation::heard() {
  ports.setBehind(false);
  setState(HostingStatus::RUNNING, "The program of " + robot + " answers again.", {});
}

void OwnProgram::Implementation::ended() {
  const std::string how = endInWords(child->wait());
  const CrashReport report = child->report();
  child.reset();
  waits = false;
  ports.close();
  setState(HostingStatus::ENDED,
           "The program of " + robot + " " + how + report.place() +
               ". The robot stands until its program is started again.",
           report.stack);
}

void OwnProgram::Implementation::setState(HostingStatus::State state, const std::string& what,
                                          const std::string& stack) {
  status.set_state(state);
  status.set_text(what);
  status.set_stack(stack);
  if (state == HostingStatus::ENDED) status.set_pid(0);
  if (listeners.hosting) listeners.hosting();
}

// ---- Questions between steps

bool OwnProgram::Implementation::answers() {
  return child && !waits;
}

const WireAnswer* OwnProgram::Implementation::ask(const WireOrder& asked) {
  if (!answers()) return nullptr;
  ProgramLink& link = child->link();
  auto outcome = link.send(asked, options.patience);
  if (outcome == ProgramLink::Outcome::kDone) outcome = link.receive(answer, options.patience);
  if (outcome == ProgramLink::Outcome::kDone) return &answer;
  if (outcome == ProgramLink::Outcome::kEnded) {
    ended();
  } else {
    // Its answer will be taken for that of a step, and contains nothing.
    waits = true;
    silent();
  }
  return nullptr;
}

namespace {

/// A preview of a program elsewhere; without effect once the program does not answer.
class OwnPreview final : public ProgramPreview {
 public:
  using Ask = std::function<const WireAnswer*(const WireOrder& order)>;
  OwnPreview(Ask ask, std::function<std::string()> refusal)
      : ask_(std::move(ask)), refusal_(std::move(refusal)) {
    WireOrder order;
    order.set_begin_preview(true);
    ask_(order);
  }

  std::string add(const robotcontrol::Request& request) override { return asked(request, false); }
  bool answer(const robotcontrol::Request& request) override {
    const std::string why = asked(request, true);
    // The program itself says in its queue why it refuses a request.
    if (const std::string gone = refusal_(); !gone.empty()) refuse(request, gone);
    return why.empty();
  }
  std::shared_ptr<const robotlink::SharedDebugQueue> takeQueue(robotlink::Instant now) override {
    WireOrder order;
    order.set_take_preview(now.time_since_epoch().count());
    const WireAnswer* answer = ask_(order);
    if (answer != nullptr && answer->has_queue()) return robotlink::fromWire(answer->queue());
    return std::exchange(refused_, nullptr);
  }

 private:
  std::string asked(const robotcontrol::Request& request, bool withResult) {
    WireOrder order;
    *order.mutable_preview()->mutable_request() = request;
    order.mutable_preview()->set_with_result(withResult);
    const WireAnswer* answer = ask_(order);
    return answer != nullptr ? answer->refusal() : refusal_();
  }
  void refuse(const robotcontrol::Request& request, const std::string& why) {
    if (!refused_) refused_ = std::make_shared<robotlink::SharedDebugQueue>();
    auto& result = refused_->add<robotcontrol::RequestResult>(robotlink::streams::kResults);
    result.set_id(request.id());
    result.set_reason(why);
  }

  const Ask ask_;
  const std::function<std::string()> refusal_;
  std::shared_ptr<robotlink::SharedDebugQueue> refused_;
};

}  // namespace

std::unique_ptr<ProgramPreview> OwnProgram::preview() {
  return std::make_unique<OwnPreview>(
      [made = implementation_.get()](const WireOrder& order) { return made->ask(order); },
      [this] { return refusal(); });
}

std::string OwnProgram::refusal() const {
  switch (implementation_->status.state()) {
    case HostingStatus::ENDED:
      return "the program of " + implementation_->robot + " has ended; start it again in the view Processes";
    case HostingStatus::NOT_ANSWERING:
      return "the program of " + implementation_->robot +
             " does not answer; start it again in the view Processes";
    default:
      return {};
  }
}

bool OwnProgram::request(const robotcontrol::Request& request) {
  auto& waiting = implementation_->requests;
  if (!implementation_->child || waiting.size() >= kMaxWaitingRequests) return false;
  waiting.push_back(request);
  return true;
}

void OwnProgram::recordPackages(const std::set<std::string>& packages) {
  WireOrder order;
  order.mutable_record_packages()->mutable_packages()->Assign(packages.begin(), packages.end());
  (void)implementation_->ask(order);
}

void OwnProgram::setKeys(const std::map<std::string, robotcontrol::KeyMode>& modes) {
  WireOrder order;
  for (const auto& [name, mode] : modes) (*order.mutable_set_keys()->mutable_modes())[name] = mode;
  (void)implementation_->ask(order);
}

// ---- What it is

void OwnProgram::setListeners(Listeners listeners) {
  implementation_->listeners = std::move(listeners);
}

std::vector<robotcontrol::ParameterValues> OwnProgram::parameters() const {
  const auto& values = implementation_->program.parameters();
  return {values.begin(), values.end()};
}

const robotlink::Layout& OwnProgram::layout() const {
  return implementation_->layout;
}

std::vector<std::string> OwnProgram::yieldedPackages() const {
  const auto& yielded = implementation_->program.yielded();
  return {yielded.begin(), yielded.end()};
}

const std::vector<robotlink::Process*>& OwnProgram::processes() const {
  return implementation_->executed;
}

const robotlink::Process& OwnProgram::debugProcess() const {
  return *implementation_->debugProcess;
}

HostingStatus OwnProgram::hosting() const {
  return implementation_->status;
}

}  // namespace app
