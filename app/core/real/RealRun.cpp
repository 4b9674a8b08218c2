// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/real/RealRun.h"

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RealHosting.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/SceneMessages.h"
#include "app/core/program/SolutionChoices.h"
#include "app/core/spread/SpreadProgram.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

using robotlink::Errors;

tl::expected<HostedRobot, Errors> hostedRobot(const RealRobotOptions& options) {
  auto description = readRobot(options.kind);
  if (!description) return tl::unexpected(description.error());
  const auto use = readUse(options.kind);
  if (!use) return tl::unexpected(use.error());
  const std::filesystem::path fieldOfKind = fieldFile(use->field);
  auto field = readField(fieldOfKind);
  if (!field) return tl::unexpected(field.error());
  HostedRobot robot{options.robot, use->teamOf(options.robot), *description, *field, nullptr, fieldOfKind};
  if (options.map.empty()) return robot;
  auto map = robotlink::GroundMap::load(options.map);
  if (!map) return tl::unexpected(map.error());
  robot.map = std::make_shared<const robotlink::GroundMap>(std::move(*map));
  return robot;
}

RealRun::RealRun(RealRobotOptions options, Listeners listeners, logplayer::Recorder* recorder)
    : options_(std::move(options)),
      listeners_(std::move(listeners)),
      tap_(recorder != nullptr ? std::make_unique<RecordingTap>(*recorder) : nullptr) {}

RealRun::~RealRun() {
  if (robot_) end();
  if (tap_) tap_->clear();
}

tl::expected<std::unique_ptr<RealRun>, Errors> RealRun::create(RealRobotOptions options, Listeners listeners,
                                                               logplayer::Recorder* recorder) {
  auto run = std::unique_ptr<RealRun>(new RealRun(std::move(options), std::move(listeners), recorder));
  if (Errors errors = run->load(); !errors.empty()) return tl::unexpected(std::move(errors));
  return run;
}

Errors RealRun::load() {
  if (Errors errors = describeRobot(); !errors.empty()) return errors;
  if (const auto plain = robotlink::readLayout(layout())) {
    Errors errors = checkSolutions(options_.solutions, robotlink::registeredTasks(), {&*plain});
    if (!errors.empty()) return errors;
  }
  auto platform = options_.platform(clock_, options_.robot, robot_->description());
  if (!platform) return {platform.error()};
  platform_ = platform->get();
  stopSwitch_ =
      std::make_shared<StopSwitch>(options_.robot, [this](bool engaged) { platform_->engageStop(engaged); });
  auto program = makeProgram(std::move(*platform), layout());
  if (!program) return program.error();
  if (tap_) tap_->restart();
  start(std::move(*program));
  return {};
}

Errors RealRun::describeRobot() {
  auto robot = hostedRobot(options_);
  if (!robot) return robot.error();
  robot_ = std::make_unique<RobotHost>(std::move(*robot), listeners_, tap_.get(), options_.overrides);
  return {};
}

std::filesystem::path RealRun::layout() const {
  return !options_.layout.empty() ? options_.layout : layoutFile(robot_->description());
}

tl::expected<RobotHost::Candidate, Errors> RealRun::makeProgram(std::unique_ptr<robotlink::Platform> platform,
                                                                const std::filesystem::path& file) {
  auto layout = readLayoutWith(file, options_.solutions);
  if (!layout) return tl::unexpected(layout.error());
  HostedProgram::Maker made = maker();
  if (!options_.spread.program.empty()) {
    auto spread = SpreadProgram::open(options_.spread, *layout, options_.robot, clock_,
                                      [this](const std::string& text) { reportSpread(text); });
    if (!spread) return tl::unexpected(Errors{spread.error()});
    spread_ = std::move(*spread);
    made = spread_->maker();
  }
  return robot_->make({.platform = std::move(platform),
                       .file = file,
                       .layout = std::move(*layout),
                       .maker = std::move(made)});
}

HostedProgram::Maker RealRun::maker() const {
  if (options_.instead || !options_.hosting.isOwn(options_.robot)) return options_.instead;
  OwnProgram::Options own = options_.own;
  own.threads = own.inRealTime = true;
  return OwnProgram::maker(own);
}

void RealRun::reportSpread(const std::string& text) const {
  if (options_.spreadReport) return options_.spreadReport(text);
  if (listeners_.platform) listeners_.platform(options_.robot, clock_.now(), text);
}

void RealRun::start(RobotHost::Candidate program) {
  robot_->adopt(std::move(program));
  executor_ = std::make_unique<ProgramExecutor>(ProgramExecutor::Options{
      .kind = ExecutorKind::kThreads,
      .trouble = [this](const auto& process, const auto& text) { robot_->reportTrouble(process, text); },
      .patience = kModulePatience,
      .stuck = [this](const auto&, const std::string& what) { robot_->noteStuck(what); }});
  lostChoices_ = robot_->begin(*executor_);
  if (const auto& known = map(); known && tap_)
    tap_->world({robotlink::streams::kMap, clock_.now(), mapMessage(*known, clock_.now())});
  executor_->start();
}

void RealRun::stop() {
  // The robot must not go on as the program commanded last. Who begins another one ends this.
  if (executor_ && platform_ != nullptr) {
    platform_->setUnattended(true);
    platform_->actuate();
  }
  if (robot_) leftOver_.end(std::move(executor_), {robot_.get()});
  if (robot_) robot_->stop();
}

void RealRun::end() {
  stop();
  if (stopSwitch_) stopSwitch_->forget();
  robot_->endPlatform();
}

bool RealRun::hasEnded() const {
  return leftOver_.haveEnded();
}

void RealRun::step() {
  leftOver_.forgetEnded();
  robot_->enqueueRequests();
  if (tap_) tap_->askForPackages();
  executor_->step();
  robot_->startStep();
  robot_->endStep();
  if (tap_) tap_->endStep();
}

Errors RealRun::setLayout(const std::filesystem::path& file) {
  if (spread_) return {SpreadProgram::refusalOfLayout(file)};
  auto program = makeProgram(nullptr, file);
  if (!program) return program.error();
  stop();
  options_.layout = file;
  start(std::move(*program));
  return {};
}

Errors RealRun::hostProgram(const std::string& name, const robotcontrol::HostProgram& choice) {
  using robotcontrol::HostProgram;
  if (options_.instead)
    return {{"program.elsewhere", "the program of this robot runs elsewhere; only its body is here", {}, {}}};
  if (Errors errors = refusalOfHosting(options_.robot, name, choice, spread_ != nullptr); !errors.empty())
    return errors;
  const HostingChoices before = options_.hosting;
  if (choice.where() != HostProgram::UNCHANGED)
    options_.hosting.choose(name, choice.where() == HostProgram::OWN_PROCESS);
  const bool same = options_.hosting.isOwn(options_.robot) == before.isOwn(options_.robot);
  if (same && !choice.start_again()) return {};
  auto program = makeProgram(nullptr, layout());
  if (!program) {
    options_.hosting = before;
    return program.error();
  }
  stop();
  start(std::move(*program));
  return {};
}

robotlink::Result<void> RealRun::request(const robotcontrol::Request& request) {
  if (request.robot() == options_.robot) return robot_->request(request);
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                            {request.robot()});
}

}  // namespace app
