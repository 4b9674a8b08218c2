// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/pioneer/PioneerRun.h"

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RealHosting.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/SceneMessages.h"
#include "app/core/program/SolutionChoices.h"
#include "app/core/spread/SpreadProgram.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/arcos/stream/StreamUrl.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/config/RobotUse.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/debugging/program/RobotProgram.h"

namespace app {

using robotlink::Errors;

PioneerRun::PioneerRun(PioneerOptions options, Listeners listeners, logplayer::Recorder* recorder)
    : options_(std::move(options)),
      listeners_(std::move(listeners)),
      tap_(recorder != nullptr ? std::make_unique<RecordingTap>(*recorder) : nullptr) {}

PioneerRun::~PioneerRun() {
  if (robot_) end();
  if (tap_) tap_->clear();
}

tl::expected<std::unique_ptr<PioneerRun>, Errors> PioneerRun::create(PioneerOptions options,
                                                                     Listeners listeners,
                                                                     logplayer::Recorder* recorder) {
  const auto url = robotlink::arcos::parseUrl(options.url);
  if (!url) return tl::unexpected(Errors{url.error()});
  // Normalized, so that the same robot always has the same address.
  options.url = robotlink::arcos::toString(*url);
  auto run = std::unique_ptr<PioneerRun>(new PioneerRun(std::move(options), std::move(listeners), recorder));
  if (Errors errors = run->load(); !errors.empty()) return tl::unexpected(std::move(errors));
  return run;
}

Errors PioneerRun::load() {
  if (Errors errors = describeRobot(); !errors.empty()) return errors;
  if (const auto plain = robotlink::readLayout(layout())) {
    Errors errors = checkSolutions(options_.solutions, robotlink::registeredTasks(), {&*plain});
    if (!errors.empty()) return errors;
  }
  auto platform = std::make_unique<PioneerPlatform>(
      clock_, options_.robot, robot_->description(),
      PioneerDriver::Options{.address = options_.url, .motorsOn = options_.motorsOn});
  platform_ = platform.get();
  stopSwitch_ =
      std::make_shared<StopSwitch>(options_.robot, [this](bool engaged) { platform_->engageStop(engaged); });
  auto program = makeProgram(std::move(platform), layout());
  if (!program) return program.error();
  if (tap_) tap_->restart();
  start(std::move(*program));
  return {};
}

Errors PioneerRun::describeRobot() {
  auto description = readRobot(options_.kind);
  if (!description) return description.error();
  const auto use = readUse(options_.kind);
  if (!use) return use.error();
  const std::filesystem::path fieldOfKind = fieldFile(use->field);
  auto field = readField(fieldOfKind);
  if (!field) return field.error();
  std::shared_ptr<const robotlink::GroundMap> map;
  if (!options_.map.empty()) {
    auto read = robotlink::GroundMap::load(options_.map);
    if (!read) return read.error();
    map = std::make_shared<const robotlink::GroundMap>(std::move(*read));
  }
  robot_ = std::make_unique<RobotHost>(
      HostedRobot{options_.robot, use->teamOf(options_.robot), *description, *field, map, fieldOfKind},
      listeners_, tap_.get(), options_.overrides);
  return {};
}

std::filesystem::path PioneerRun::layout() const {
  return !options_.layout.empty() ? options_.layout : layoutFile(robot_->description());
}

tl::expected<RobotHost::Candidate, Errors> PioneerRun::makeProgram(
    std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file) {
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

HostedProgram::Maker PioneerRun::maker() const {
  if (options_.instead || !options_.hosting.isOwn(options_.robot)) return options_.instead;
  OwnProgram::Options own = options_.own;
  own.threads = own.inRealTime = true;
  return OwnProgram::maker(own);
}

void PioneerRun::reportSpread(const std::string& text) const {
  if (options_.spreadReport) return options_.spreadReport(text);
  if (listeners_.platform) listeners_.platform(options_.robot, clock_.now(), text);
}

void PioneerRun::start(RobotHost::Candidate program) {
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

void PioneerRun::stop() {
  // The robot must not go on as the program commanded last. Who begins another one ends this.
  if (executor_ && platform_ != nullptr) {
    platform_->setUnattended(true);
    platform_->actuate();
  }
  if (robot_) leftOver_.end(std::move(executor_), {robot_.get()});
  if (robot_) robot_->stop();
}

void PioneerRun::end() {
  stop();
  if (stopSwitch_) stopSwitch_->forget();
  robot_->endPlatform();
}

bool PioneerRun::hasEnded() const {
  return leftOver_.haveEnded();
}

void PioneerRun::step() {
  leftOver_.forgetEnded();
  robot_->enqueueRequests();
  if (tap_) tap_->askForPackages();
  if (spread_) platform_->setUnattended(robot_->isUnattended());
  executor_->step();
  robot_->startStep();
  robot_->reportPlatform();
  if (tap_) tap_->endStep();
}

Errors PioneerRun::setLayout(const std::filesystem::path& file) {
  if (spread_) return {SpreadProgram::refusalOfLayout(file)};
  auto program = makeProgram(nullptr, file);
  if (!program) return program.error();
  stop();
  options_.layout = file;
  start(std::move(*program));
  return {};
}

Errors PioneerRun::hostProgram(const std::string& name, const robotcontrol::HostProgram& choice) {
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

robotlink::Result<void> PioneerRun::request(const robotcontrol::Request& request) {
  if (request.robot() == options_.robot) return robot_->request(request);
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                            {request.robot()});
}

}  // namespace app
