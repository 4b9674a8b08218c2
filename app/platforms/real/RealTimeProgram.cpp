// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/RealTimeProgram.h"

#include "app/core/program/ProgramSetups.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotFiles.h"
#include "app/core/program/SolutionChoices.h"
#include "app/core/spread/SpreadProgram.h"
#include "app/platforms/SceneMessages.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/Streams.h"

namespace app {

using robotcontrol::HostProgram;
using robotlink::Errors;

namespace {

/// Returns why it cannot be chosen where the program of a robot runs; empty if it can. `asked` is the robot
/// that a request names, empty for all.
Errors refusalOfHosting(const std::string& robot, const std::string& asked, const HostProgram& choice,
                        bool isSpread) {
  if (!asked.empty() && asked != robot)
    return {{"request.no-robot", "there is no robot " + asked, {asked}, {}}};
  if (isSpread)
    return {{"spread.hosting",
             "the processes of " + robot +
                 " are spread over several programs already; restart this program to change that",
             {robot},
             {}}};
  if (choice.executor() == HostProgram::LOCKSTEP)
    return {{"program.real-time",
             "a real robot does not wait for its program: its processes have a thread each",
             {robot},
             {}}};
  return {};
}

HostedRobot startingWith(std::shared_ptr<const robotlink::Preset> preset, HostedRobot robot) {
  robot.preset = std::move(preset);
  robot.presetFile = presetFile(robot.name);
  return robot;
}

}  // namespace

RealTimeProgram::RealTimeProgram(RealTimeOptions options, HostedRobot robot,
                                 std::unique_ptr<const robotlink::Clock> clock, Listeners listeners,
                                 logplayer::Recorder* recorder)
    : options_(std::move(options)),
      listeners_(std::move(listeners)),
      clock_(std::move(clock)),
      tap_(recorder != nullptr ? std::make_unique<RecordingTap>(*recorder) : nullptr),
      host_(startingWith(options_.preset, std::move(robot)), listeners_, tap_.get(), options_.overrides) {}

RealTimeProgram::~RealTimeProgram() {
  end();
  if (tap_) tap_->clear();
}

Errors RealTimeProgram::checkSolutions() const {
  const auto plain = robotlink::readLayout(layout());
  // Errors in the layout itself are reported when it is read to make the program.
  if (!plain) return {};
  return app::checkSolutions(options_.solutions, robotlink::registeredTasks(), {&*plain});
}

Errors RealTimeProgram::start(std::unique_ptr<robotlink::Platform> platform) {
  stopSwitch_ = std::make_shared<StopSwitch>(
      name(), [robot = platform.get()](bool engaged) { robot->engageStop(engaged); });
  if (auto joined = joinTeam(*platform); !joined) return {joined.error()};
  auto program = makeProgram(std::move(platform), layout());
  if (!program) return program.error();
  if (tap_) tap_->restart();
  adopt(std::move(*program));
  return {};
}

robotlink::Result<void> RealTimeProgram::joinTeam(robotlink::Platform& platform) {
  if (!options_.team.port) return {};
  auto team = TeamLink::open(options_.team, name(), host_.robot().team);
  if (!team) return tl::unexpected(team.error());
  team_ = std::move(*team);
  return team_->attach(platform);
}

std::filesystem::path RealTimeProgram::layout() const {
  return !options_.layout.empty() ? options_.layout : layoutFile(host_.description());
}

tl::expected<RobotHost::Candidate, Errors> RealTimeProgram::makeProgram(
    std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file) {
  auto layout = readLayoutWith(file, options_.solutions);
  if (!layout) return tl::unexpected(layout.error());
  auto made = maker(*layout);
  if (!made) return tl::unexpected(made.error());
  return host_.make({.platform = std::move(platform),
                     .file = file,
                     .layout = std::move(*layout),
                     .maker = std::move(*made)});
}

tl::expected<HostedProgram::Maker, Errors> RealTimeProgram::maker(const robotlink::Layout& layout) {
  if (!options_.spread.program.empty()) {
    auto spread = SpreadProgram::open(options_.spread, layout, name(), *clock_,
                                      [this](const std::string& text) { reportSpread(text); });
    if (!spread) return tl::unexpected(Errors{spread.error()});
    spread_ = std::move(*spread);
    return spread_->maker();
  }
  if (options_.instead || !options_.hosting.isOwn(name())) return options_.instead;
  OwnProgram::Options own = options_.own;
  own.threads = own.inRealTime = true;
  return OwnProgram::maker(own);
}

void RealTimeProgram::reportSpread(const std::string& text) const {
  if (options_.spreadReport) return options_.spreadReport(text);
  if (listeners_.platform) listeners_.platform(name(), clock_->now(), text);
}

void RealTimeProgram::adopt(RobotHost::Candidate program) {
  host_.adopt(std::move(program));
  executor_ = std::make_unique<ProgramExecutor>(ProgramExecutor::Options{
      .kind = ExecutorKind::kThreads,
      .trouble = [this](const auto& process, const auto& text) { host_.reportTrouble(process, text); },
      .patience = kModulePatience,
      .stuck = [this](const auto&, const std::string& what) { host_.noteStuck(what); }});
  lostChoices_ = host_.begin(*executor_);
  if (const auto known = map(); known && tap_)
    tap_->world({robotlink::streams::kMap, clock_->now(), mapMessage(*known, clock_->now())});
  executor_->start();
}

void RealTimeProgram::stop() {
  // The robot must not continue with the program's last commands. The next program ends this.
  if (executor_) {
    robotlink::Platform& platform = *host_.platform();
    platform.setUnattended(true);
    platform.guard([&platform] { platform.actuate(); });
  }
  leftOver_.end(std::move(executor_), {&host_});
  host_.stop();
}

void RealTimeProgram::end() {
  stop();
  if (stopSwitch_) stopSwitch_->forget();
  host_.endPlatform();
}

void RealTimeProgram::step() {
  leftOver_.forgetEnded();
  host_.enqueueRequests();
  if (tap_) tap_->askForPackages();
  executor_->step();
  if (team_) team_->step(clock_->now());
  host_.startStep();
  host_.endStep();
  if (tap_) tap_->endStep();
}

Errors RealTimeProgram::replace(const std::filesystem::path& file) {
  auto program = makeProgram(nullptr, file);
  if (!program) return program.error();
  stop();
  adopt(std::move(*program));
  return {};
}

Errors RealTimeProgram::setLayout(const std::filesystem::path& file) {
  if (spread_) return {SpreadProgram::refusalOfLayout(file)};
  Errors errors = replace(file);
  if (errors.empty()) options_.layout = file;
  return errors;
}

Errors RealTimeProgram::hostProgram(const std::string& robot, const HostProgram& choice) {
  if (isBody())
    return {{"program.elsewhere", "the program of this robot runs elsewhere; only its body is here", {}, {}}};
  if (Errors errors = refusalOfHosting(name(), robot, choice, spread_ != nullptr); !errors.empty())
    return errors;
  const HostingChoices before = options_.hosting;
  if (choice.where() != HostProgram::UNCHANGED)
    options_.hosting.choose(robot, choice.where() == HostProgram::OWN_PROCESS);
  const bool same = options_.hosting.isOwn(name()) == before.isOwn(name());
  if (same && !choice.start_again()) return {};
  Errors errors = replace(layout());
  if (!errors.empty()) options_.hosting = before;
  return errors;
}

robotlink::Result<void> RealTimeProgram::request(const robotcontrol::Request& request) {
  if (request.robot() == name()) return host_.request(request);
  return robotlink::failure("request.no-robot", "there is no robot " + request.robot(), {},
                            {request.robot()});
}

}  // namespace app
