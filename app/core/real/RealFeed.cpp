// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/real/RealFeed.h"

#include "app/core/platform/HostingMemory.h"
#include "app/core/platform/RobotPublishing.h"
#include "app/core/program/SceneMessages.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kStep{10};
constexpr std::chrono::milliseconds kRealStatusEvery{100};

}  // namespace

PlatformOpening RealFeed::opening(RealRobotOptions options) {
  return {options.adapter, {options.url}, [options](const PlatformContext& context) -> PlatformOpening::Made {
            RealRobotOptions chosen = options;
            const auto before = context.overrides.find(chosen.robot);
            if (before != context.overrides.end()) chosen.overrides = before->second;
            chosen.hosting = hostingAtOpening(chosen.hosting, context.hosting, chosen.adapter);
            return create(std::move(chosen), context.session, context.recorder, context.hosting);
          }};
}

tl::expected<std::unique_ptr<RealFeed>, robotlink::Errors> RealFeed::create(RealRobotOptions options,
                                                                            robotlink::Session& session,
                                                                            logplayer::Recorder& recorder,
                                                                            HostingMemory* hosting) {
  auto feed = std::unique_ptr<RealFeed>(new RealFeed(session, recorder));
  feed->hosting_ = hosting;
  auto run = RealRun::create(std::move(options), listenersOf(feed->gate_), &recorder);
  if (!run) return tl::unexpected(std::move(run.error()));
  feed->run_ = std::move(*run);
  return feed;
}

std::vector<std::string> RealFeed::end() {
  gate_.keepReports();
  run_->end();
  if (run_->hasEnded()) run_.reset();
  return gate_.keptReports();
}

void RealFeed::begin() {
  gate_.open();
  due_ = Clock::now();
  if (const auto map = run_->map()) {
    const auto now = run_->clock().now();
    gate_.publish({robotlink::streams::kMap, now, mapMessage(*map, now)});
    gate_.publishMapNotes(run_->options().robot, now, *map);
  }
  publishStatus();
}

void RealFeed::step() {
  run_->step();
  const auto real = Clock::now();
  // Missed steps are not made up for.
  due_ = std::max(due_ + kStep, real);
  if (isRead_ && real - lastStatus_ >= kRealStatusEvery) publishStatus();
}

robotlink::Result<void> RealFeed::requestRobot(const robotcontrol::Request& request) {
  return run_->request(request);
}

std::map<std::string, ProgramOverrides> RealFeed::overrides() const {
  return {{run_->options().robot, run_->overrides()}};
}

robotlink::Errors RealFeed::setLayout(const std::filesystem::path& file) {
  return run_->setLayout(file);
}

void RealFeed::publishLostOverrides() {
  for (const std::string& lost : run_->lostChoices()) {
    gate_.publishText(run_->options().robot, "layout", run_->clock().now(), foxglove::Log::WARNING, lost);
  }
}

robotlink::Result<void> RealFeed::requestSimulation(const robotcontrol::Request& request) {
  if (!request.has_host_program()) return PlatformFeed::requestSimulation(request);
  const robotlink::Errors errors = run_->hostProgram(request.robot(), request.host_program());
  if (!errors.empty()) return tl::unexpected(errors.front());
  rememberHosting(hosting_, run_->options().adapter, request.host_program(), run_->options().hosting);
  publishLostOverrides();
  return {};
}

LoadedPlatform RealFeed::describe() const {
  LoadedPlatform loaded;
  loaded.adapter = run_->options().adapter;
  loaded.time = TimeKind::kReal;
  loaded.sources = {run_->options().url};
  loaded.title = run_->options().url;
  loaded.lostChoices = run_->lostChoices();
  loaded.robots[run_->options().robot] = run_->robot().description;
  if (!run_->robot().fieldFile.empty()) loaded.field = run_->robot().field;
  loaded.areBodies = run_->options().instead != nullptr;
  if (!loaded.areBodies) loaded.layout = run_->layout();
  return loaded;
}

void RealFeed::setDemand(const Demand& demand) {
  gate_.setRead(demand.anything);
  if (!std::exchange(isRead_, demand.anything) && demand.anything) publishStatus();
}

void RealFeed::publishStatus() {
  lastStatus_ = Clock::now();
  const auto now = run_->clock().now();
  auto status = std::make_shared<robotcontrol::SimulationStatus>();
  status->set_time(robotlink::seconds(now));
  status->set_speed(1);
  status->set_requested_speed(1);
  status->set_running(true);
  status->set_is_real(true);
  status->set_scene(run_->options().url);
  status->add_robots(run_->options().robot);
  if (run_->platform().stopEngaged()) status->add_stopped_robots(run_->options().robot);
  gate_.publish({robotlink::streams::kSimulation, now, std::move(status)});
  gate_.publish({robotlink::streams::kRecording, now,
                 std::make_shared<robotcontrol::RecordingStatus>(recorder_.status())});
}

}  // namespace app
