// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PlatformThread.h"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "app/core/SimulationFeed.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace app {
namespace {

using robotcontrol::ControlReplay;

/// What a request does besides its action; where that is nothing, it may join another one.
bool onlyMoves(const robotcontrol::Request& request) {
  if (!request.has_control_replay()) return false;
  ControlReplay rest = request.control_replay();
  rest.clear_action();
  rest.clear_count();
  rest.clear_time();
  rest.clear_frame();
  rest.clear_process();
  rest.clear_stream();
  return rest.ByteSizeLong() == 0 && request.control_replay().action() >= ControlReplay::STEP_FRAME;
}

bool isJump(const ControlReplay& move) {
  return move.action() == ControlReplay::JUMP_TO_TIME || move.action() == ControlReplay::JUMP_TO_FRAME;
}

/// Makes the first do what both would do one after the other. Both only move; false if that is not one movement.
bool join(ControlReplay& first, const ControlReplay& second) {
  if (isJump(second)) {
    first = second;
    return true;
  }
  if (first.action() != second.action() || first.process() != second.process() || first.stream() != second.stream()) {
    return false;
  }
  // A step there and one back need not lead to where one was: that is only so for steps in the same direction.
  if ((first.count() < 0) != (second.count() < 0)) return false;
  constexpr std::int64_t kMostFrames = std::numeric_limits<std::int32_t>::max();
  const std::int64_t sum = std::int64_t{first.count()} + second.count();
  first.set_count(static_cast<std::int32_t>(std::clamp(sum, -kMostFrames, kMostFrames)));
  return true;
}

}  // namespace

/// A request that waits, with those that joined it.
struct PlatformThread::Asked {
  robotcontrol::Request request;
  std::vector<std::uint64_t> ids;
};

PlatformThread::PlatformThread(robotlink::Session& session, logplayer::Recorder& recorder)
    : session_(session),
      recorder_(recorder),
      thread_({[this] { return feed_ ? feed_->due() : std::nullopt; }, [this] { feed_->step(); }, [this] { feed_.reset(); }}) {}

void PlatformThread::postOther(PacedThread::Job job) {
  {
    const std::lock_guard lock(mutex_);
    newest_.reset();  // What is asked for later is done after this.
  }
  thread_.post(std::move(job));
}

LoadedPlatform PlatformThread::describe() const { return feed_ ? feed_->describe() : LoadedPlatform{}; }

void PlatformThread::start(std::unique_ptr<PlatformFeed> feed) {
  feed_.reset();  // What it still tells must not get into the next one's history.
  feed_ = std::move(feed);
  session_.restart([this] {
    if (feed_) feed_->begin();
  });
}

void PlatformThread::load(RunOptions options, LoadHandler handler) {
  postOther([this, options = std::move(options), handler = std::move(handler)] {
    auto feed = SimulationFeed::create(options, session_, recorder_);
    if (!feed) {
      handler(tl::unexpected(feed.error()));
      return;
    }
    if (const auto* before = dynamic_cast<const SimulationFeed*>(feed_.get())) (*feed)->goOnLike(*before);
    start(std::move(*feed));
    handler(describe());
  });
}

void PlatformThread::open(ReplayOptions options, LoadHandler handler) {
  postOther([options = std::move(options), handler = std::move(handler)] {
    handler(tl::unexpected(robotlink::Errors{{"log.open", options.logs.front().file.string() + ": logs cannot be replayed yet", {}, {}}}));
  });
}

void PlatformThread::addLog(ReplayLog log, LoadHandler handler) {
  ReplayOptions options;
  options.logs.push_back(std::move(log));
  open(std::move(options), std::move(handler));
}

void PlatformThread::setLayout(std::filesystem::path file, LoadHandler handler) {
  postOther([this, file = std::move(file), handler = std::move(handler)] {
    robotlink::Errors errors{{"platform.none", "nothing runs that could use a layout; open a scene or a log first", {}, {}}};
    if (feed_) errors = feed_->setLayout(file);
    if (errors.empty()) {
      handler(describe());
    } else {
      handler(tl::unexpected(std::move(errors)));
    }
  });
}

void PlatformThread::close(LoadHandler handler) {
  postOther([this, handler = std::move(handler)] {
    start(nullptr);
    handler(describe());
  });
}

void PlatformThread::request(const robotcontrol::Request& request) {
  const bool moves = onlyMoves(request);
  std::shared_ptr<Asked> asked;
  {
    const std::lock_guard lock(mutex_);
    if (moves && newest_ && join(*newest_->request.mutable_control_replay(), request.control_replay())) {
      newest_->ids.push_back(request.id());
      return;
    }
    asked = std::make_shared<Asked>(Asked{request, {request.id()}});
    newest_ = moves ? asked : nullptr;
  }
  thread_.post([this, asked] {
    {
      const std::lock_guard lock(mutex_);
      if (newest_ == asked) newest_.reset();  // Nothing joins it any more.
    }
    fulfil(asked->request, asked->ids);
  });
}

void PlatformThread::fulfil(const robotcontrol::Request& request, const std::vector<std::uint64_t>& ids) {
  robotlink::Result<PlatformFeed::Answer> done =
      robotlink::failure("platform.none", "nothing runs that could do this; open a scene or a log first");
  if (feed_) done = feed_->fulfil(request);
  if (done && *done == PlatformFeed::Answer::kByProgram) return;
  for (const std::uint64_t id : ids) {
    robotcontrol::RequestResult result;
    result.set_id(id);
    result.set_accepted(done.has_value());
    if (!done) result.set_reason(done.error().text);
    session_.pushResult(result);
  }
  if (feed_) feed_->publishStatus();
}

}  // namespace app
