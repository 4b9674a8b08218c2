// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/own/OwnProgram.h"

#include <algorithm>
#include <optional>

#include "app/core/own/MirrorPlatform.h"
#include "app/core/own/OwnPreview.h"
#include "app/core/own/PlatformPorts.h"
#include "app/core/own/ProgramChild.h"
#include "app/core/own/SpareChild.h"
#include "app/core/own/StandInProcess.h"
#include "app/core/own/WireSetups.h"
#include "app/core/program/HostedRobot.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"

namespace app {

using robotcontrol::HostingStatus;
using robotcontrol::WireAnswer;
using robotcontrol::WireOrder;
using robotlink::Errors;

namespace {

/// The number of requests that a debug process queues at most.
constexpr std::size_t kMaxWaitingRequests = 1000;
/// A limit above the number of frames of a debug process in the longest step.
constexpr std::uint64_t kMaxDebugFrames = 1000;
/// The name of the stand-in for the program in the executor.
constexpr char kExchange[] = "program";
/// How often to check whether the wait for an answer was cut short.
constexpr std::chrono::milliseconds kAnswerLook{10};
/// With threads, what a socket does not take within this time is sent in the next step.
constexpr std::chrono::milliseconds kSendTime{5};

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
  /// With threads: takes everything that has arrived.
  void takeNews();
  /// In lockstep: waits for the answer as long as the patience lasts, which begins when the step is sent. All
  /// robots' steps are sent at once, so several programs that hang are waited for together.
  ProgramLink::Outcome receiveAnswer();
  void take(const WireAnswer& arrived);
  void apply(const robotcontrol::WireResult& result);
  void applyEvent(const robotcontrol::WireResult::Event& event);
  // ---- Questions between steps
  bool answers();
  /// Null if it does not answer in time, or has ended.
  const WireAnswer* ask(const WireOrder& order);
  // ---- What may go wrong
  void silent();
  void heard();
  /// With threads: notes that something does not return there, or, if `what` is empty, that it has.
  void stuck(const std::string& what);
  void ended();
  /// The calls of what does not return, as far as they can be known.
  CrashReport lookIntoIt();
  std::string waited() const;
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
  PlatformPorts::Packages offers;
  PackageTap tap;
  /// A step was sent and its result has not come.
  bool waits = false;
  std::chrono::steady_clock::time_point sentAt;
  /// Whether the program takes no part in steps, and, with threads, whether one of them does not return.
  bool isSilent = false, isStuck = false;
  /// The first step was sent: its threads run.
  bool hasBegun = false;
  /// The frames of the platform when the last step was sent.
  std::uint64_t platformFrames = 0;
  /// The missing process according to the newest result.
  std::string missingProcess;
  WireOrder order;
  WireAnswer answer;
  HostingStatus status;
};

// ---- Making it

HostedProgram::Maker OwnProgram::maker(Options options) {
  return [options = std::move(options)](Parts parts) -> Made {
    robotcontrol::WireSetup setup = wireSetup(parts, options);
    auto child = options.spare ? options.spare->take(options.executable, parts.robot.name)
                               : ProgramChild::start(options.executable, parts.robot.name);
    if (!child) return tl::unexpected(Errors{child.error()});
    auto made = std::make_unique<Implementation>(options, std::move(parts), std::move(*child));
    if (Errors errors = made->make(std::move(setup)); !errors.empty())
      return tl::unexpected(std::move(errors));
    return std::unique_ptr<HostedProgram>(new OwnProgram(std::move(made)));
  };
}

Errors OwnProgram::Implementation::make(robotcontrol::WireSetup setup) {
  ports.describeTo(setup, options.turns);
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
  status.set_threads(options.threads);
  // Threads take the newest, as from any link.
  ports.setBehind(options.threads);
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
  // A program that does not answer does not listen either.
  const bool listens = !implementation_->waits && !implementation_->isStuck;
  if (implementation_->child && !listens) implementation_->child->kill();
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
  step.mutable_offers()->Swap(&offers);
  offers.Clear();
  waits = hasBegun = true;
  sentAt = std::chrono::steady_clock::now();
  const auto limit = options.threads ? kSendTime : options.patience;
  if (child->link().send(order, limit) == ProgramLink::Outcome::kEnded) ended();
}

void OwnProgram::Implementation::runStep() {
  if (options.threads) return takeNews();
  startStep();
  if (!child) return;
  switch (receiveAnswer()) {
    case ProgramLink::Outcome::kTimeout:
      if (!isSilent) silent();
      return;
    case ProgramLink::Outcome::kEnded:
      return ended();
    case ProgramLink::Outcome::kDone:
      return take(answer);
  }
}

ProgramLink::Outcome OwnProgram::Implementation::receiveAnswer() {
  ProgramLink& link = child->link();
  if (isSilent) return link.receive(answer, std::chrono::milliseconds(0));
  for (;;) {
    const auto outcome = link.receive(answer, kAnswerLook);
    const bool isOver = options.cut ? options.cut->isOver(sentAt)
                                    : std::chrono::steady_clock::now() - sentAt >= options.patience;
    if (outcome != ProgramLink::Outcome::kTimeout || isOver) return outcome;
  }
}

void OwnProgram::Implementation::takeNews() {
  while (child) {
    switch (child->link().receive(answer, std::chrono::milliseconds(0))) {
      case ProgramLink::Outcome::kTimeout:
        if (waits && !isSilent && std::chrono::steady_clock::now() - sentAt > options.patience) silent();
        return;
      case ProgramLink::Outcome::kEnded:
        return ended();
      case ProgramLink::Outcome::kDone:
        take(answer);
    }
  }
}

void OwnProgram::Implementation::take(const WireAnswer& arrived) {
  if (!arrived.result().unasked()) {
    waits = false;
    if (isSilent) heard();
  }
  // The result may be a late answer to an earlier question.
  if (arrived.has_result()) apply(arrived.result());
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
  missingProcess = result.missing_process();
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
  } else if (event.has_tapped()) {
    const auto package = packageIn(event.tapped().package());
    if (package && tap) tap(event.tapped().name(), package);
  } else if (event.has_stuck()) {
    stuck(event.stuck().what());
  }
}

// ---- What may go wrong

CrashReport OwnProgram::Implementation::lookIntoIt() {
  // A user who single-steps the program in a debugger must not be disturbed by a crash report.
  return child->isDebugged() ? CrashReport() : child->ask();
}

std::string OwnProgram::Implementation::waited() const {
  char text[32];
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - sentAt;
  std::snprintf(text, sizeof text, "%.1f s", time.count());
  return text;
}

void OwnProgram::Implementation::silent() {
  const CrashReport report = lookIntoIt();
  isSilent = true;
  ports.setBehind(true);
  setState(HostingStatus::NOT_ANSWERING,
           "The program of " + robot + " has not answered for " + waited() +
               (report.activity.empty() ? std::string() : ": it does not return" + report.place()) +
               ". The robot stays stopped until it answers or is restarted. To attach a debugger: gdb -p " +
               std::to_string(child->pid()),
           report.stack);
}

void OwnProgram::Implementation::heard() {
  isSilent = false;
  ports.setBehind(options.threads);
  if (!isStuck) setState(HostingStatus::RUNNING, "The program of " + robot + " answers again.", {});
}

void OwnProgram::Implementation::stuck(const std::string& what) {
  isStuck = !what.empty();
  if (!isStuck) {
    return setState(HostingStatus::RUNNING, "The program of " + robot + " has returned and continues.", {});
  }
  const CrashReport report = lookIntoIt();
  setState(HostingStatus::NOT_ANSWERING,
           "The program of " + robot + " does not return from " + what +
               ". The robot stays stopped until it returns or its program is restarted. To attach a "
               "debugger: gdb -p " +
               std::to_string(child->pid()),
           report.stack);
}

void OwnProgram::Implementation::ended() {
  const std::string how = endInWords(child->wait());
  const CrashReport report = child->report();
  child.reset();
  waits = false;
  ports.close();
  setState(HostingStatus::ENDED,
           "The program of " + robot + " " + how + report.place() +
               ". The robot stays stopped until its program is restarted.",
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
  // Among the news of threads an answer would not be found.
  return child && !waits && !(options.threads && hasBegun);
}

const WireAnswer* OwnProgram::Implementation::ask(const WireOrder& asked) {
  if (!answers()) return nullptr;
  ProgramLink& link = child->link();
  sentAt = std::chrono::steady_clock::now();
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

std::unique_ptr<ProgramPreview> OwnProgram::preview() {
  return std::make_unique<OwnPreview>(
      [made = implementation_.get()](const WireOrder& order) { return made->ask(order); },
      [this] { return refusal(); });
}

std::string OwnProgram::refusal() const {
  switch (implementation_->status.state()) {
    case HostingStatus::ENDED:
      return "the program of " + implementation_->robot + " has ended; restart it in the view Processes";
    case HostingStatus::NOT_ANSWERING:
      return "the program of " + implementation_->robot +
             " does not answer; restart it in the view Processes";
    default:
      return {};
  }
}

void OwnProgram::offer(const robotlink::PackagePtr& package) {
  assign(*implementation_->offers.Add(), 0, *package);
}

void OwnProgram::tap(const std::set<std::string>& packages, PackageTap tap) {
  implementation_->tap = std::move(tap);
  WireOrder order;
  order.mutable_tap()->mutable_packages()->Assign(packages.begin(), packages.end());
  (void)implementation_->ask(order);
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

std::string OwnProgram::missingProcess() const {
  return implementation_->missingProcess;
}

HostingStatus OwnProgram::hosting() const {
  return implementation_->status;
}

}  // namespace app
