// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PlatformThread.h"

#include "app/core/platform/ReplayMoves.h"
#include "app/core/program/Abandoned.h"
#include "logplayer/record/Recorder.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RequestKinds.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

/// The maximum number of open requests; a session does not wait for more.
constexpr std::size_t kMaxForwarded = 10'000;

}  // namespace

struct PlatformThread::Asked {
  robotcontrol::Request request;
  std::vector<std::uint64_t> ids;
};

PlatformThread::PlatformThread(robotlink::Session& session, logplayer::Recorder& recorder,
                               HostingMemory* hosting, const LinkLimitsMemory* limits)
    : session_(session),
      recorder_(recorder),
      hosting_(hosting),
      limits_(limits),
      thread_({[this] { return feed_ ? feed_->due() : std::nullopt; }, [this] { feed_->step(); },
               [this] { endFeed(); }}) {}

PlatformThread::~PlatformThread() {
  endWaits();
}

void PlatformThread::onRobotsChanged(LoadHandler handler) {
  // In the thread that calls it.
  thread_.post([this, handler = std::move(handler)]() mutable { robotsChanged_ = std::move(handler); });
}

void PlatformThread::endWaits() {
  std::shared_ptr<StopSwitch> stopSwitch;
  {
    const std::lock_guard lock(mutex_);
    stopSwitch = stopSwitch_;
  }
  if (stopSwitch) stopSwitch->endWaits();
}

void PlatformThread::endFeed() {
  reportedAtEnd_.clear();
  if (!feed_) return;
  reportedAtEnd_ = feed_->end();
  const std::shared_ptr<PlatformFeed> ended(std::move(feed_));
  // A module that never returns must not keep everything else.
  if (!ended->hasEnded()) abandon(ended, [feed = ended.get()] { return feed->hasEnded(); });
}

void PlatformThread::postOther(robotlink::PacedThread::Job job) {
  {
    const std::lock_guard lock(mutex_);
    // Later requests must be fulfilled after this job.
    newest_.reset();
  }
  thread_.post(std::move(job));
}

LoadedPlatform PlatformThread::describe() const {
  LoadedPlatform loaded = feed_ ? feed_->describe() : LoadedPlatform{};
  loaded.ended = reportedAtEnd_;
  return loaded;
}

void PlatformThread::start(std::unique_ptr<PlatformFeed> feed) {
  if (feed_ && !feed_->overrides().empty()) {
    const LoadedPlatform before = feed_->describe();
    ended_ = {before.adapter, before.sources, feed_->overrides()};
  }
  // First, so that its last messages do not get into the history of the next one.
  endFeed();
  refuseForwarded();
  recorder_.setLive(!feed || !feed->describe().isLogged());
  feed_ = std::move(feed);
  {
    const std::lock_guard lock(mutex_);
    stopSwitch_ = feed_ ? feed_->stopSwitch() : nullptr;
  }
  session_.restart([this] {
    if (feed_) feed_->begin();
  });
  if (feed_) feed_->setDemand(demand_);
}

std::map<std::string, ProgramOverrides> PlatformThread::overridesFor(const PlatformOpening& opening) const {
  if (feed_) {
    const LoadedPlatform now = feed_->describe();
    if (now.adapter == opening.adapter && now.sources == opening.sources && !feed_->overrides().empty())
      return feed_->overrides();
  }
  const bool known = ended_.adapter == opening.adapter && ended_.sources == opening.sources;
  return known ? ended_.overrides : std::map<std::string, ProgramOverrides>{};
}

void PlatformThread::open(PlatformOpening opening, logplayer::LogFile::Progress progress,
                          LoadHandler handler) {
  postOther(
      [this, opening = std::move(opening), progress = std::move(progress), handler = std::move(handler)] {
        const bool sameKind = feed_ && feed_->describe().adapter == opening.adapter;
        if (sameKind) feed_->makeWay();
        auto feed = opening.make({session_, recorder_, memories_[opening.adapter], overridesFor(opening),
                                  progress, hosting_, limits_});
        if (!feed) {
          robotlink::Errors errors = feed.error();
          if (sameKind) {
            for (robotlink::Error& error : feed_->restoreAfterMakeWay()) errors.push_back(std::move(error));
          }
          handler(tl::unexpected(std::move(errors)));
          return;
        }
        if (sameKind) (*feed)->inheritPlayback(feed_->going());
        start(std::move(*feed));
        handler(describe());
      });
}

void PlatformThread::connectNow() {
  postOther([this] {
    if (feed_) feed_->connectNow();
  });
}

void PlatformThread::addLog(std::filesystem::path file, robotlink::Duration offset,
                            logplayer::LogFile::Progress progress, LoadHandler handler) {
  postOther(
      [this, file = std::move(file), offset, progress = std::move(progress), handler = std::move(handler)] {
        PlatformOpening::Made feed =
            tl::unexpected(robotlink::Errors{{"replay.none", "no log is open to add this one to", {}, {}}});
        if (feed_) feed = feed_->withLog(file, offset, progress);
        if (!feed) {
          handler(tl::unexpected(feed.error()));
          return;
        }
        start(std::move(*feed));
        handler(describe());
      });
}

void PlatformThread::setLayout(std::filesystem::path file, LoadHandler handler, std::string name) {
  postOther([this, file = std::move(file), handler = std::move(handler), name = std::move(name)] {
    robotlink::Errors errors{
        {"platform.none",
         "nothing is running that uses a layout; open a scene or a log, or connect a robot first",
         {},
         {}}};
    if (feed_) errors = name.empty() ? feed_->setLayout(file) : feed_->setLayoutOf(name, file);
    reportedAtEnd_.clear();
    if (errors.empty()) {
      handler(describe());
    } else {
      handler(tl::unexpected(std::move(errors)));
    }
  });
}

void PlatformThread::reload(FileTexts texts, bool mustFit, LoadHandler inPlace, LoadHandler opened) {
  postOther(
      [this, texts = std::move(texts), mustFit, inPlace = std::move(inPlace), opened = std::move(opened)] {
        tl::expected<bool, robotlink::Errors> done = tl::unexpected(
            robotlink::Errors{{"simulation.none", "there is no simulation; open a scene first", {}, {}}});
        if (feed_) done = feed_->reload(texts, mustFit);
        reportedAtEnd_.clear();
        if (!done) return inPlace(tl::unexpected(std::move(done.error())));
        if (!*done) return open(feed_->reopening(texts), {}, opened);
        inPlace(describe());
      });
}

void PlatformThread::close(LoadHandler handler) {
  endWaits();
  postOther([this, handler = std::move(handler)] {
    start(nullptr);
    handler(describe());
  });
}

void PlatformThread::stop(const robotcontrol::Request& request) {
  std::shared_ptr<StopSwitch> stopSwitch;
  {
    const std::lock_guard lock(mutex_);
    stopSwitch = stopSwitch_;
  }
  // STOP does not wait in the queue, since a program that hangs may block the platform's thread.
  if (stopSwitch) stopSwitch->engage(request.robot(), robotlink::engagesStop(request));
  thread_.postUrgent([this, request] {
    // A scene with this robot may be about to be opened.
    if (feed_ && feed_->describe().robots.contains(request.robot())) return fulfill(request, {request.id()});
    postOther([this, request] { fulfill(request, {request.id()}); });
  });
}

void PlatformThread::request(const robotcontrol::Request& request) {
  if (request.has_stop()) return stop(request);
  const bool moves = request.has_control_replay() && onlyMoves(request.control_replay());
  std::shared_ptr<Asked> asked;
  {
    const std::lock_guard lock(mutex_);
    if (moves && newest_ && joinMoves(*newest_->request.mutable_control_replay(), request.control_replay())) {
      newest_->ids.push_back(request.id());
      return;
    }
    asked = std::make_shared<Asked>(Asked{request, {request.id()}});
    newest_ = moves ? asked : nullptr;
  }
  thread_.post([this, asked] {
    {
      const std::lock_guard lock(mutex_);
      // This request is about to be fulfilled, so no later one may be merged with it.
      if (newest_ == asked) newest_.reset();
    }
    fulfill(asked->request, asked->ids);
  });
}

void PlatformThread::fulfill(const robotcontrol::Request& request, const std::vector<std::uint64_t>& ids) {
  robotlink::Result<PlatformFeed::Answer> done = robotlink::failure(
      "platform.none",
      "nothing is running that can do this; open a scene or a log, or connect a robot first");
  if (feed_) done = feed_->fulfill(request);
  if (done && *done == PlatformFeed::Answer::kByProgram) {
    forwarded_.insert(forwarded_.end(), ids.begin(), ids.end());
    while (forwarded_.size() > kMaxForwarded) forwarded_.pop_front();
    return;
  }
  // This comes first, so that the receiver of the result sees the effect.
  if (feed_) feed_->publishStatus();
  if (feed_ && feed_->takeDescriptionChange() && robotsChanged_) {
    reportedAtEnd_.clear();
    robotsChanged_(describe());
  }
  for (const std::uint64_t id : ids) pushResult(id, done ? std::string() : done.error().describe());
}

void PlatformThread::setDemand(const PlatformFeed::Demand& demand) {
  thread_.post([this, demand] {
    demand_ = demand;
    if (feed_) feed_->setDemand(demand);
  });
}

void PlatformThread::refuseForwarded() {
  for (const std::uint64_t id : forwarded_)
    pushResult(id, "the robot's program ended before it answered; repeat the request");
  forwarded_.clear();
}

void PlatformThread::pushResult(std::uint64_t id, const std::string& refusal) {
  robotcontrol::RequestResult result;
  result.set_id(id);
  result.set_accepted(refusal.empty());
  result.set_reason(refusal);
  session_.pushResult(result);
}

}  // namespace app
