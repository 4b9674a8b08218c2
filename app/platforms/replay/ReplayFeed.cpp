// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayFeed.h"

#include <algorithm>

#include "app/core/platform/HostingMemory.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Hosting.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/process/Process.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

using robotlink::Errors;
using robotlink::Instant;
using robotlink::Result;

constexpr std::chrono::milliseconds kReplayStatusEvery{100};

/// The stream of images of the robot by which the logs are stepped.
std::string imagesOf(const ReplayRun& run) {
  const std::string& process = run.stepProcess();
  return process.substr(0, process.find('/')) + "/" + robotlink::kCameraImage.name;
}

}  // namespace

PlatformOpening ReplayFeed::opening(ReplayOptions options) {
  std::vector<std::string> sources;
  for (const ReplayLog& log : options.logs) sources.push_back(log.file.string());
  const auto make = [options](const PlatformContext& context) -> PlatformOpening::Made {
    ReplayOptions opened = options;
    opened.progress = context.progress;
    opened.hosting = hostingAtOpening(opened.hosting, context.hosting, kAdapter);
    auto feed = create(std::move(opened), context.session, context.recorder);
    if (feed) (*feed)->hosting_ = context.hosting;
    return feed;
  };
  return {kAdapter, std::move(sources), make,
          options.logs.empty() ? std::filesystem::path() : options.logs.front().file};
}

PlatformOpening::Made ReplayFeed::withLog(const std::filesystem::path& file, robotlink::Duration offset,
                                          const logplayer::LogFile::Progress& progress) const {
  ReplayOptions more = options();
  more.logs.push_back({file, offset});
  more.progress = progress;
  auto feed = create(std::move(more), session_, recorder_, now());
  if (!feed) return tl::unexpected(feed.error());
  (*feed)->playLike(*this);
  return feed;
}

tl::expected<std::unique_ptr<ReplayFeed>, Errors> ReplayFeed::create(ReplayOptions options,
                                                                     robotlink::Session& session,
                                                                     logplayer::Recorder& recorder,
                                                                     std::optional<Instant> time) {
  auto feed = std::unique_ptr<ReplayFeed>(new ReplayFeed(session, recorder));
  if (options.patience.count() == 0) options.patience = kModulePatience;
  auto run = ReplayRun::create(std::move(options), feed->listeners());
  if (!run) return tl::unexpected(std::move(run.error()));
  feed->run_ = std::move(*run);
  const Instant aim = std::clamp(time.value_or(feed->firstImage()), feed->run_->begin(), feed->run_->end());
  if (Errors errors = feed->run_->jump(aim); !errors.empty()) return tl::unexpected(std::move(errors));
  return feed;
}

Instant ReplayFeed::firstImage() const {
  if (const auto image = run_->firstTime(imagesOf(*run_))) return *image;
  return run_->firstTime(ReplayLogs::framesOf(run_->stepProcess())).value_or(run_->begin());
}

ReplayRun::Listeners ReplayFeed::listeners() {
  return {[this](std::vector<robotlink::StreamMessage> frame) { gate_.publishFrame(std::move(frame)); },
          [this](const std::string& robot, auto queue) { gate_.publishQueue(robot, std::move(queue)); },
          [this](const std::string& robot, const robotlink::Process& process, const std::string& text) {
            gate_.publishError(robot, process.name(), run_ ? run_->now() : process.clock().now(), text);
          },
          [this](const std::string& robot, Instant time, const robotcontrol::HostingStatus& status) {
            gate_.publishHosting(robot, time, status);
          }};
}

Playback::Place ReplayFeed::place() const {
  return {run_->now(), run_->begin(), run_->end(), run_->nextTime()};
}

void ReplayFeed::playLike(const ReplayFeed& before) {
  hosting_ = before.hosting_;
  playback_ = before.playback_;
  playback_.jumped(Clock::now(), place());
  run_->setStepProcess(before.run_->stepProcess());
}

ReplayOptions ReplayFeed::options() const {
  ReplayOptions options = run_->options();
  robotcontrol::ReplayStatus status;
  run_->describe(status);
  for (const auto& package : status.packages()) {
    if (package.chosen()) options.packages[package.package()] = package.source();
  }
  options.overrides = run_->overrides();
  return options;
}

std::vector<std::string> ReplayFeed::end() {
  run_->stop();
  if (run_->hasEnded()) run_.reset();
  return {};
}

void ReplayFeed::begin() {
  gate_.open();
  publishStatus();
}

Errors ReplayFeed::republish(const Change& change) {
  gate_.close();
  Errors errors = change();
  if (!errors.empty()) {
    gate_.discard();
    gate_.open();
    return errors;
  }
  stale_ = false;
  playback_.jumped(Clock::now(), place());
  session_.restart([this] {
    gate_.open();
    publishStatus();
  });
  return {};
}

Result<void> ReplayFeed::changed(const Change& change) {
  const Errors errors = republish(change);
  if (errors.empty()) return {};
  return tl::unexpected(errors.front());
}

Result<void> ReplayFeed::jump(Instant time) {
  const Instant aim = std::clamp(time, run_->begin(), run_->end());
  return changed([&] { return run_->jump(aim); });
}

// If `time` is no farther than a jump's preroll, stepping there costs no more than a jump, and the session
// keeps its history.
Result<void> ReplayFeed::goTo(Instant time) {
  if (time < run_->now() || time - run_->now() > run_->options().preroll) return jump(time);
  while (run_->nextTime() && *run_->nextTime() <= time) {
    run_->step();
    stale_ = false;
  }
  playback_.jumped(Clock::now(), place());
  return {};
}

std::optional<robotlink::PacedThread::Clock::time_point> ReplayFeed::due() {
  if (stale_ && !playback_.playing()) return Clock::now();
  const auto next = playback_.next(place());
  if (!next) return std::nullopt;
  return isRead_ ? std::min(next->due, lastStatus_ + kReplayStatusEvery) : next->due;
}

void ReplayFeed::step() {
  const auto real = Clock::now();
  if (stale_ && !playback_.playing()) {
    publishFailure(jump(run_->now()));
    return;
  }
  const auto next = playback_.next(place());
  if (next && next->due <= real) {
    switch (next->what) {
      case Playback::Next::What::kStep:
        playback_.stepping(real, place());
        run_->step();
        stale_ = false;
        break;
      case Playback::Next::What::kJump:
        publishFailure(jump(next->to));
        break;
      case Playback::Next::What::kPause:
        playback_.pause();
        publishStatus();
        break;
    }
  }
  if (isRead_ && real - lastStatus_ >= kReplayStatusEvery) publishStatus();
}

void ReplayFeed::publishFailure(const Result<void>& done) {
  if (done) return;
  playback_.pause();
  stale_ = false;
  const std::string& process = run_->stepProcess();
  const auto slash = std::min(process.find('/'), process.size());
  gate_.publishError(process.substr(0, slash), process.substr(std::min(slash + 1, process.size())),
                     run_->now(), "The log is paused: " + done.error().describe());
  publishStatus();
}

Errors ReplayFeed::setLayout(const std::filesystem::path& file) {
  return republish([&] { return run_->setLayout(file); });
}

LoadedPlatform ReplayFeed::describe() const {
  LoadedPlatform loaded;
  for (const std::string& robot : run_->robots()) loaded.robots[robot] = run_->description(robot);
  loaded.adapter = kAdapter;
  loaded.time = TimeKind::kLogged;
  for (const ReplayLog& log : run_->options().logs) {
    loaded.sources.push_back(log.file.string());
    loaded.title += (loaded.title.empty() ? "" : " + ") + log.file.filename().string();
  }
  if (const auto field = run_->field(); field && !field->name.empty()) loaded.field = field;
  loaded.layout = run_->options().layout;
  loaded.lostChoices = run_->lostChoices();
  return loaded;
}

void ReplayFeed::setDemand(const Demand& demand) {
  gate_.setRead(demand.anything);
  if (!std::exchange(isRead_, demand.anything) && demand.anything) publishStatus();
}

void ReplayFeed::publishStatus() {
  const auto real = Clock::now();
  lastStatus_ = real;
  auto status = std::make_shared<robotcontrol::ReplayStatus>();
  run_->describe(*status);
  status->set_playing(playback_.playing());
  status->set_speed(playback_.speed());
  status->set_loop(playback_.loop());
  status->set_skip_gaps(playback_.skipsGaps());
  status->set_step_process(run_->stepProcess());
  status->set_start(firstImage().time_since_epoch().count());
  status->set_time(playback_.reached(real, place()).time_since_epoch().count());
  if (const auto& range = playback_.range()) {
    status->mutable_range()->set_from(range->from.time_since_epoch().count());
    status->mutable_range()->set_to(range->to.time_since_epoch().count());
  }
  gate_.publish({robotlink::streams::kReplay, run_->now(), std::move(status)});
  gate_.publish({robotlink::streams::kRecording, run_->now(),
                 std::make_shared<robotcontrol::RecordingStatus>(recorder_.status())});
}

}  // namespace app
