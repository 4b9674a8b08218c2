// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/real/RealTimeFeed.h"

#include "app/core/platform/HostingMemory.h"
#include "app/platforms/SceneMessages.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kRealStatusEvery{100};

}  // namespace

RealTimeFeed::RealTimeFeed(robotlink::Session& session, logplayer::Recorder& recorder, HostingMemory* hosting,
                           std::string adapter, std::chrono::milliseconds period)
    : gate_(session), recorder_(recorder), hosting_(hosting), adapter_(std::move(adapter)), period_(period) {}

void RealTimeFeed::begin() {
  gate_.open();
  due_ = Clock::now();
  if (const auto map = program_->map()) {
    const auto now = program_->clock().now();
    gate_.publish({robotlink::streams::kMap, now, mapMessage(*map, now)});
    gate_.publishMapNotes(program_->name(), now, *map);
  }
  publishStatus();
}

void RealTimeFeed::step() {
  stepProgram();
  const auto real = Clock::now();
  // Missed steps are not made up for.
  due_ = std::max(due_ + period_, real);
  if (isRead_ && real - lastStatus_ >= kRealStatusEvery) publishStatus();
}

std::vector<std::string> RealTimeFeed::end() {
  gate_.keepReports();
  program_->end();
  if (program_->hasEnded()) program_.reset();
  return gate_.keptReports();
}

robotlink::Errors RealTimeFeed::setLayout(const std::filesystem::path& file) {
  return program_->setLayout(file);
}

robotlink::Result<void> RealTimeFeed::requestRobot(const robotcontrol::Request& request) {
  return program_->request(request);
}

robotlink::Result<void> RealTimeFeed::requestSimulation(const robotcontrol::Request& request) {
  if (!request.has_host_program()) return PlatformFeed::requestSimulation(request);
  const robotlink::Errors errors = program_->hostProgram(request.robot(), request.host_program());
  if (!errors.empty()) return tl::unexpected(errors.front());
  rememberHosting(hosting_, adapter_, request.host_program(), program_->hosting());
  // describe() is not asked after this request.
  for (const std::string& lost : program_->lostChoices())
    gate_.publishText(program_->name(), "layout", program_->clock().now(), foxglove::Log::WARNING, lost);
  return {};
}

std::map<std::string, ProgramOverrides> RealTimeFeed::overrides() const {
  return {{program_->name(), program_->overrides()}};
}

LoadedPlatform RealTimeFeed::describe() const {
  LoadedPlatform loaded;
  loaded.adapter = adapter_;
  loaded.time = TimeKind::kReal;
  loaded.sources = {url_};
  loaded.title = url_;
  loaded.lostChoices = program_->lostChoices();
  loaded.robots[program_->name()] = program_->robot().description;
  loaded.areBodies = program_->isBody();
  if (!loaded.areBodies) loaded.layout = program_->layout();
  return loaded;
}

void RealTimeFeed::setDemand(const Demand& demand) {
  gate_.setRead(demand.anything);
  if (!std::exchange(isRead_, demand.anything) && demand.anything) publishStatus();
}

void RealTimeFeed::publishStatus() {
  lastStatus_ = Clock::now();
  const auto now = program_->clock().now();
  auto status = std::make_shared<robotcontrol::SimulationStatus>();
  status->set_time(robotlink::seconds(now));
  status->set_speed(1);
  status->set_requested_speed(1);
  status->set_running(true);
  status->set_is_real(true);
  status->set_scene(url_);
  status->add_robots(program_->name());
  if (program_->stopEngaged()) status->add_stopped_robots(program_->name());
  gate_.publish({robotlink::streams::kSimulation, now, std::move(status)});
  gate_.publish({robotlink::streams::kRecording, now,
                 std::make_shared<robotcontrol::RecordingStatus>(recorder_.status())});
}

}  // namespace app
