// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PioneerFeed.h"

#include "app/core/SceneMessages.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/Streams.h"

namespace app {
namespace {

constexpr std::chrono::milliseconds kStep{10};
constexpr std::chrono::milliseconds kPioneerStatusEvery{100};

}  // namespace

tl::expected<std::unique_ptr<PioneerFeed>, robotlink::Errors> PioneerFeed::create(
    PioneerOptions options, robotlink::Session& session, logplayer::Recorder& recorder) {
  auto feed = std::unique_ptr<PioneerFeed>(new PioneerFeed(session, recorder));
  auto run = PioneerRun::create(std::move(options), feed->listeners(), &recorder);
  if (!run) return tl::unexpected(std::move(run.error()));
  feed->run_ = std::move(*run);
  return feed;
}

PioneerRun::Listeners PioneerFeed::listeners() {
  return {[this](const std::string& robot, auto queue) { outlet_.tellQueue(robot, std::move(queue)); },
          [this](const std::string& robot, const robotlink::Process& process, const std::string& text) {
            outlet_.tellTrouble(robot, process, text);
          }};
}

void PioneerFeed::begin() {
  outlet_.open();
  due_ = Clock::now();
  if (const auto map = run_->map()) {
    const auto now = run_->clock().now();
    outlet_.tell({robotlink::streams::kMap, now, mapMessage(*map, now)});
    outlet_.tellMapNotes(run_->options().robot, now, *map);
  }
  publishStatus();
}

void PioneerFeed::step() {
  run_->step();
  const auto real = Clock::now();
  due_ = std::max(due_ + kStep, real);  // What was missed is not made up for.
  if (real - lastStatus_ >= kPioneerStatusEvery) publishStatus();
}

robotlink::Result<PlatformFeed::Answer> PioneerFeed::fulfil(const robotcontrol::Request& request) {
  if (request.robot().empty()) {
    return robotlink::failure("platform.real", "a real robot is connected, which cannot be asked for this");
  }
  if (auto done = run_->request(request); !done) return tl::unexpected(done.error());
  return PioneerRun::isOfPlatform(request) ? Answer::kHere : Answer::kByProgram;
}

robotlink::Errors PioneerFeed::setLayout(const std::filesystem::path& file) {
  robotlink::Errors errors = run_->setLayout(file);
  if (!errors.empty()) return errors;
  for (const std::string& lost : run_->lostChoices()) {
    outlet_.tellText(run_->options().robot, "layout", run_->clock().now(), foxglove::Log::WARNING, lost);
  }
  return {};
}

LoadedPlatform PioneerFeed::describe() const {
  LoadedPlatform loaded;
  loaded.lostChoices = run_->lostChoices();
  loaded.robots[run_->options().robot] = run_->description();
  loaded.field = run_->field();
  loaded.layout = run_->layout();
  loaded.pioneer = run_->options();
  return loaded;
}

void PioneerFeed::publishStatus() {
  lastStatus_ = Clock::now();
  const auto now = run_->clock().now();
  auto status = std::make_shared<robotcontrol::SimulationStatus>();
  status->set_time(robotlink::seconds(now));
  status->set_speed(1);
  status->set_requested_speed(1);
  status->set_running(true);
  status->set_scene(run_->options().url);
  status->add_robots(run_->options().robot);
  if (run_->platform().stopEngaged()) status->add_stopped_robots(run_->options().robot);
  outlet_.tell({robotlink::streams::kSimulation, now, std::move(status)});
  outlet_.tell({robotlink::streams::kRecording, now,
                std::make_shared<robotcontrol::RecordingStatus>(recorder_.status())});
}

}  // namespace app
