// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/RobotHost.h"

#include <algorithm>
#include <cstdio>

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

using robotlink::Errors;

namespace {

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

}  // namespace

RobotHost::Candidate::Candidate() = default;
RobotHost::Candidate::Candidate(Candidate&&) noexcept = default;
RobotHost::Candidate& RobotHost::Candidate::operator=(Candidate&&) noexcept = default;
RobotHost::Candidate::~Candidate() = default;

RobotHost::RobotHost(HostedRobot robot, Listeners listeners, RecordingTap* tap, ProgramOverrides overrides)
    : robot_(std::move(robot)),
      listeners_(std::move(listeners)),
      tap_(tap),
      requests_(robot_.name, std::move(overrides)) {}

RobotHost::~RobotHost() {
  stop();
  if (platform_) platform_->shutDown();
}

// ---- The program

tl::expected<RobotHost::Candidate, Errors> RobotHost::make(std::unique_ptr<robotlink::Platform> platform,
                                                           const std::filesystem::path& file,
                                                           const robotlink::Layout& layout) {
  const robotlink::RobotSetup setup{robot_.name, robot_.team, description(), robot_.field, robot_.map};
  Candidate made;
  made.platform = std::move(platform);
  made.layout = file;
  auto program = robotlink::RobotProgram::create(setup, layout, made.platform ? *made.platform : *platform_,
                                                 {.folder = parameterFolder(description())});
  if (!program) return tl::unexpected(program.error());
  made.program = std::move(*program);
  made.program->debugProcess().setListener([this](auto queue) {
    requests_.answered(*queue);
    if (tap_ != nullptr) tap_->add(robot_.name, queue);
    if (listeners_.queue) listeners_.queue(robot_.name, std::move(queue));
  });
  return made;
}

void RobotHost::adopt(Candidate candidate) {
  program_ = std::move(candidate.program);
  layout_ = std::move(candidate.layout);
  if (!candidate.platform) return;
  if (platform_) platform_->shutDown();
  platform_ = std::move(candidate.platform);
  platformIsSetUp_ = false;
}

std::vector<std::string> RobotHost::begin(ProgramExecutor& executor) {
  if (tap_ != nullptr) record(executor.kind());
  setUp();
  std::vector<std::string> lost = requests_.begin(*program_);
  if (executor.kind() == ExecutorKind::kThreads) enqueueRequests();
  executor.add(*platform_, *program_);
  return lost;
}

void RobotHost::setUp() {
  if (std::exchange(platformIsSetUp_, true)) return;
  const std::string took = timeTaken([this] { platform_->initialize(); });
  if (listeners_.platform) listeners_.platform(robot_.name, "The platform was set up in " + took + ".");
  reportPlatform();
}

void RobotHost::record(ExecutorKind executor) {
  const ProgramFiles files{layout_, descriptionFile(description().name), robot_.fieldFile, nameOf(executor)};
  tap_->attach(robot_.name, *platform_, *program_, programSetup(*program_, *platform_, files));
}

void RobotHost::stop() {
  if (program_) program_->stop();
  program_.reset();
}

// ---- Requests

robotlink::Result<void> RobotHost::request(const robotcontrol::Request& request) {
  if (robotlink::kindOf(request).doer == robotlink::RequestDoer::kPlatform) return requestPlatform(request);
  if (requests_.ask(request)) return {};
  return robotlink::failure("request.queue-full",
                            "robot " + robot_.name + " does not take requests now: too many wait already", {},
                            {robot_.name});
}

robotlink::Result<void> RobotHost::requestPlatform(const robotcontrol::Request& request) {
  if (request.has_control_drive()) return platform_->control(request.control_drive());
  platform_->engageStop(request.stop().engaged());
  return {};
}

void RobotHost::enqueueRequests() {
  requests_.ran();
  requests_.hand([this](const robotcontrol::Request& request) {
    const bool accepted = program_->debugProcess().request(request);
    if (accepted && tap_ != nullptr) tap_->recordRequest(request);
    return accepted;
  });
}

std::shared_ptr<const robotlink::SharedDebugQueue> RobotHost::answersToCome() {
  return requests_.answersToCome(*program_, platform_->clock().now());
}

// ---- Reports

void RobotHost::reportPlatform() {
  for (const std::string& text : platform_->takeReports()) {
    if (listeners_.platform) listeners_.platform(robot_.name, text);
  }
}

bool RobotHost::owns(const robotlink::Process& process) const {
  if (&process == platform_.get()) return true;
  if (!program_) return false;
  const auto& processes = program_->processes();
  return std::find(processes.begin(), processes.end(), &process) != processes.end();
}

void RobotHost::reportTrouble(const robotlink::Process& process, const std::string& text) const {
  if (listeners_.trouble) listeners_.trouble(robot_.name, process, "Process " + process.name() + " " + text);
}

}  // namespace app
