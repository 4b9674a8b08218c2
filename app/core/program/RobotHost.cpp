// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RobotHost.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/core/program/InsideProgram.h"
#include "app/core/program/PresetOverrides.h"
#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

using robotlink::Errors;

namespace {

constexpr std::size_t kMaxPresetBytes = 1U << 20U;

/// Calls a function and returns how long that took, as a text: "1.2 ms".
template <typename Call>
std::string timeTaken(Call call) {
  const auto begin = std::chrono::steady_clock::now();
  call();
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", took.count());
  return text;
}

/// Returns the contents of the file; unset: there is none.
std::optional<std::string> presetTextIn(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  auto text = robotlink::readFile(file, kMaxPresetBytes);
  // A read error counts as contents, so that it is reported once.
  return text ? *std::move(text) : text.error().text;
}

}  // namespace

RobotHost::Candidate::Candidate() = default;
RobotHost::Candidate::Candidate(Candidate&&) noexcept = default;
RobotHost::Candidate& RobotHost::Candidate::operator=(Candidate&&) noexcept = default;
RobotHost::Candidate::~Candidate() = default;

RobotHost::RobotHost(HostedRobot robot, Listeners listeners, RecordingTap* tap, ProgramOverrides overrides)
    : robot_(std::move(robot)),
      listeners_(std::move(listeners)),
      tap_(tap),
      requests_(robot_.name, std::move(overrides), listeners_.overridden) {}

RobotHost::~RobotHost() {
  stop();
  shutDown();
}

// ---- The program

tl::expected<RobotHost::Candidate, Errors> RobotHost::make(Parts parts) {
  Candidate made;
  made.robot = parts.robot ? std::move(*parts.robot) : robot_;
  made.platform = std::move(parts.platform);
  made.layout = std::move(parts.file);
  made.overridden = parts.overridden;
  const HostedProgram::Maker maker = parts.maker ? std::move(parts.maker) : [](HostedProgram::Parts inside) {
    return InsideProgram::create(std::move(inside));
  };
  auto program = maker({.robot = made.robot,
                        .platform = made.platform ? *made.platform : *platform_,
                        .file = made.layout,
                        .layout = std::move(parts.layout),
                        .parameters = {.folder = parameterFolder(*made.robot.description),
                                       .recorded = std::move(parts.parameters)}});
  if (!program) return tl::unexpected(program.error());
  made.program = std::move(*program);
  made.processes = made.program->processes();
  if (parts.overridden) {
    const ProgramOverrides chosen = overrides();
    const std::vector<std::string> recorded = chosen.recordedPackages();
    made.program->setKeys(chosen.keys());
    made.program->recordPackages({recorded.begin(), recorded.end()});
  }
  made.program->setListeners({[this](auto queue) {
                                requests_.answered(*queue);
                                report([this, queue = std::move(queue)] { publish(queue); });
                              },
                              [this](const auto& process, const auto& text) { reportTrouble(process, text); },
                              [this] { reportHosting(); }});
  return made;
}

void RobotHost::adopt(Candidate candidate) {
  robot_ = std::move(candidate.robot);
  program_ = std::move(candidate.program);
  layout_ = std::move(candidate.layout);
  overridden_ = candidate.overridden;
  processes_ = std::move(candidate.processes);
  if (!candidate.platform) return;
  shutDown();
  platform_ = std::move(candidate.platform);
}

std::vector<std::string> RobotHost::begin(ProgramExecutor& executor) {
  executor_ = executor.kind();
  stuck_.clear();
  stuckText_.clear();
  missingText_.clear();
  if (const std::string missing = program_->missingProcess(); !missing.empty()) {
    isComplete_ = false;
    missingText_ = "The robot stays stopped until process " + missing + ", which decides what it does, runs.";
  } else {
    isComplete_ = true;
  }
  if (tap_ != nullptr) record(executor.kind());
  setUp();
  std::vector<std::string> lost;
  // A file that was changed since an earlier start is the newest choice.
  const bool isFirst = !std::exchange(hasBegun_, true);
  if (const auto preset = presetToBegin()) {
    const auto chosen = requestsOf(*preset, program_->parameters());
    if (isFirst)
      requests_.choose(chosen);
    else
      requests_.replaceChoices(chosen);
  }
  if (overridden_) {
    requests_.beginOverridden();
  } else {
    lost = requests_.begin(*program_);
  }
  if (executor.kind() == ExecutorKind::kThreads) enqueueRequests();
  continueIn(executor);
  reportHosting();
  return lost;
}

std::shared_ptr<const robotlink::Preset> RobotHost::presetToBegin() {
  const auto text = robot_.presetFile.empty() ? std::nullopt : presetTextIn(robot_.presetFile);
  const bool isOther = text && text != presetText_;
  if (text) presetText_ = text;
  if (auto given = std::exchange(robot_.preset, nullptr)) return given;
  if (!isOther) return nullptr;
  auto preset = presetToStartWith(robot_.presetFile.string());
  if (preset) return std::make_shared<const robotlink::Preset>(*std::move(preset));
  reportPlatform("The robot's preset is not used: " + robotlink::describe(preset.error()));
  return nullptr;
}

void RobotHost::continueIn(ProgramExecutor& executor) {
  using Guard = ProgramExecutor::Guard;
  const Guard elsewhere = program_->hosting().own_process() ? Guard::kStandIn : Guard::kNo;
  executor.add(*platform_, processes_, insideProgram() != nullptr ? Guard::kYes : elsewhere);
}

void RobotHost::setUp() {
  if (std::exchange(platformIsSetUp_, true)) return;
  const std::string took = timeTaken([this] { platform_->initialize(); });
  reportPlatform("The platform was set up in " + took + ".");
  reportPlatform();
}

void RobotHost::shutDown() {
  if (!platform_) return;
  const std::string took = timeTaken([this] { platform_->shutDown(); });
  reportPlatform();
  // A platform that was not set up, since its program could not be run, is not reported.
  if (std::exchange(platformIsSetUp_, false)) reportPlatform("The platform was shut down in " + took + ".");
}

void RobotHost::record(ExecutorKind executor) {
  const ProgramFiles files{layout_, descriptionFile(description().name), robot_.fieldFile, nameOf(executor)};
  tap_->attach(robot_.name, *platform_, *program_, programSetup(robot_, *program_, *platform_, files));
}

void RobotHost::stop() {
  forgetReports();
  if (program_) program_->stop();
  program_.reset();
}

std::unique_ptr<HostedProgram> RobotHost::release() {
  forgetReports();
  if (program_) program_->stop();
  return std::move(program_);
}

std::unique_ptr<robotlink::Platform> RobotHost::releasePlatform() {
  shutDown();
  return std::move(platform_);
}

void RobotHost::noteStuck(const std::string& what) {
  stuck_ = what;
  stuckText_ = what.empty() ? "The program of " + robot_.name + " has returned and continues."
                            : "The program of " + robot_.name + " does not return from " + what +
                                  ". The robot stays stopped until it returns or its program is restarted.";
  reportHosting();
}

// ---- Requests

/// The requests that the table of requests assigns to platforms.
struct RobotHost::Handlers {
  using Request = robotcontrol::Request;
  static constexpr robotlink::RequestRow<robotlink::Result<void> (RobotHost::*)(const Request&)> kRows[]{
      {Request::kStop, &RobotHost::engageStop},
      {Request::kControlDrive, &RobotHost::controlDrive},
      {Request::kSetCamera, &RobotHost::setCamera}};
};

bool RobotHost::fulfills(const robotcontrol::Request& request) {
  return robotlink::rowOf(Handlers::kRows, request.what_case()) != nullptr;
}

robotlink::Result<void> RobotHost::request(const robotcontrol::Request& request) {
  if (const auto* row = robotlink::rowOf(Handlers::kRows, request.what_case()))
    return (this->*row->handler)(request);
  const std::string takenBack =
      requests_.takeBack(request) ? "; " + robotlink::kindOf(request).choice(request) + " is forgotten" : "";
  if (const std::string why = program_ ? program_->refusal() : std::string(); !why.empty())
    return robotlink::failure("program.ended", why + takenBack, {}, {robot_.name});
  if (isStuck())
    return robotlink::failure("program.stuck",
                              "the program of " + robot_.name + " does not return from " + stuck_ +
                                  "; restart it in the view Processes" + takenBack,
                              {}, {robot_.name});
  if (requests_.ask(request)) return {};
  return robotlink::failure(
      "request.queue-full",
      "robot " + robot_.name + " does not accept requests now: too many are waiting already", {},
      {robot_.name});
}

robotlink::Result<void> RobotHost::whetherMoved() const {
  if (std::string why = platform_->refusal(); !why.empty())
    return robotlink::failure("platform.refused", std::move(why), {}, {robot_.name});
  return {};
}

robotlink::Result<void> RobotHost::engageStop(const robotcontrol::Request& request) {
  if (auto moved = whetherMoved(); !moved) return moved;
  platform_->engageStop(robotlink::engagesStop(request));
  return {};
}

robotlink::Result<void> RobotHost::controlDrive(const robotcontrol::Request& request) {
  if (auto moved = whetherMoved(); !moved) return moved;
  return platform_->control(request.control_drive());
}

robotlink::Result<void> RobotHost::setCamera(const robotcontrol::Request& request) {
  return platform_->setCamera(request.set_camera());
}

void RobotHost::enqueueRequests() {
  requests_.ran();
  requests_.hand([this](const robotcontrol::Request& request) {
    return tap_ != nullptr ? tap_->request(robot_.name, request) : program_->request(request);
  });
}

std::shared_ptr<const robotlink::SharedDebugQueue> RobotHost::answersToCome() {
  if (isStuck()) return nullptr;
  return requests_.answersToCome(*program_, platform_->clock().now());
}

// ---- Reports

void RobotHost::report(std::function<void()> call) const {
  if (!keepsReports_) return call();
  const std::lock_guard lock(keptMutex_);
  kept_.push_back(std::move(call));
}

void RobotHost::forgetReports() {
  // The processes that they name end.
  const std::lock_guard lock(keptMutex_);
  kept_.clear();
}

void RobotHost::publish(std::shared_ptr<const robotlink::SharedDebugQueue> queue) {
  if (tap_ != nullptr) tap_->add(robot_.name, queue);
  if (listeners_.queue) listeners_.queue(robot_.name, std::move(queue));
}

void RobotHost::deliver() {
  if (isStuck()) return;
  std::vector<std::function<void()>> kept;
  {
    const std::lock_guard lock(keptMutex_);
    kept.swap(kept_);
  }
  for (const auto& call : kept) call();
}

void RobotHost::reportPlatform() {
  for (const std::string& text : platform_->takeReports()) reportPlatform(text);
  for (const std::string& text : platform_->takeProblems()) {
    if (!listeners_.problem) {
      reportPlatform(text);
    } else {
      listeners_.problem(robot_.name, platform_->clock().now(), text);
    }
  }
}

void RobotHost::reportPlatform(const std::string& text) const {
  if (listeners_.platform) listeners_.platform(robot_.name, platform_->clock().now(), text);
}

void RobotHost::endStep() {
  if (program_ && program_->missingProcess().empty() != isComplete_) {
    noteMissing();
    reportHosting();
  }
  reportPlatform();
}

void RobotHost::noteMissing() {
  const std::string missing = program_->missingProcess();
  isComplete_ = missing.empty();
  missingText_ =
      isComplete_
          ? "All processes that decide what " + robot_.name + " does run."
          : "Process " + missing + ", which decides what " + robot_.name +
                " does, has stopped, does not return, or cannot be reached. The robot stays stopped until it "
                "is back or its program is restarted.";
}

void RobotHost::reportHosting() {
  if (!program_) return;
  using robotcontrol::HostingStatus;
  HostingStatus status = program_->hosting();
  status.set_threads(executor_ == ExecutorKind::kThreads);
  if (isStuck()) status.set_state(HostingStatus::NOT_ANSWERING);
  if (!stuckText_.empty()) status.set_text(stuckText_);
  if (status.state() == HostingStatus::RUNNING && !missingText_.empty()) {
    if (!isComplete_) status.set_state(HostingStatus::INCOMPLETE);
    status.set_text(missingText_);
  }
  platform_->setUnattended(status.state() != HostingStatus::RUNNING);
  if (listeners_.hosting) listeners_.hosting(robot_.name, platform_->clock().now(), status);
}

bool RobotHost::owns(const robotlink::Process& process) const {
  if (&process == platform_.get()) return true;
  if (!program_) return false;
  const auto& processes = program_->processes();
  return std::ranges::find(processes, &process) != processes.end();
}

void RobotHost::reportTrouble(const robotlink::Process& process, const std::string& text) const {
  if (!listeners_.trouble) return;
  report([this, &process, text = "Process " + process.name() + " " + text] {
    listeners_.trouble(robot_.name, process, text);
  });
}

}  // namespace app
