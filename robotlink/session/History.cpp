// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/session/History.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "robotlink/debugging/Streams.h"
#include "robotlink/session/LatchedMessages.h"

namespace robotlink {
namespace {

/// The distance from the begin of the stored messages below which more is read.
constexpr Duration kMargin = std::chrono::seconds(2);
/// The number of messages that are looked at in one tick, which takes some milliseconds.
constexpr int kLookedAtOnce = 2000;

/// Returns the readable stretches of an archive, in order of time.
std::vector<Stretch> readable(const HistoryArchive& archive) {
  const auto all = archive.stretch();
  if (!all) return {};
  std::vector<Stretch> parts{*all};
  for (const Stretch& hole : archive.holes()) {
    parts.back().to = hole.from;
    parts.push_back({hole.to, all->to});
  }
  return parts;
}

/// The earliest message in memory; latched ones may be older than anything else.
Instant oldestIn(const StreamStore& store) {
  Instant oldest = store.newest();
  for (const auto* stream : store.streams()) {
    if (!stream->messages.empty() && !isLatched(stream->path, stream->type))
      oldest = std::min(oldest, stream->messages.front().time);
  }
  return oldest;
}

}  // namespace

void History::setArchive(std::unique_ptr<HistoryArchive> archive) {
  archive_ = std::move(archive);
  store_.setArchive(archive_.get());
  reading_.reset();
  requested_.reset();
  steps_ = {};
}

void History::pause() {
  if (timeline_.live()) timeline_.show(timeline_.newest());
  keepAround();
}

void History::goLive() {
  timeline_.goLive();
  store_.lookAway();
  reading_.reset();
  requested_.reset();
  steps_ = {};
}

void History::show(Instant time) {
  steps_ = {};
  const std::vector<Stretch> all = kept();
  time = std::clamp(time, all.front().from, all.back().to);
  for (auto at = all.begin(); at != all.end(); ++at) {
    if (time > at->to && time < std::next(at)->from) time = std::next(at)->from;
  }
  if (store_.has(time) || !archive_) {
    reading_.reset();
    timeline_.show(time);
    return keepAround();
  }
  timeline_.show(timeline_.shown());
  reading_ = time;
  requested_ = time;
  archive_->request(time);
}

Result<void> History::step(const std::string& stream, int count) {
  if (store_.find(stream) == nullptr) {
    return failure("history.stream", "nothing was received on " + stream + "; switch its debug key on", {},
                   {stream});
  }
  if (!reading_) show(timeline_.shown());
  steps_ = {{stream}, count, timeline_.shown()};
  doSteps();
  return {};
}

void History::stepUntil(std::vector<std::string> streams, bool forward,
                        std::function<bool(Instant)> isThere) {
  if (!reading_) show(timeline_.shown());
  isMissed_ = false;
  steps_ = {std::move(streams), forward ? 1 : -1, timeline_.shown(), std::move(isThere), timeline_.shown()};
  doSteps();
}

Result<void> History::stepFrames(const std::string& robot, int count) {
  const StreamStore::Stream* slowest = nullptr;
  const auto rate = [this](const StreamStore::Stream& stream) {
    return static_cast<double>(stream.count) / seconds(store_.newest() - stream.since + Duration(1));
  };
  for (const auto* stream : store_.streams(robot + "/" + streams::kFrames)) {
    if (slowest == nullptr || rate(*stream) < rate(*slowest)) slowest = stream;
  }
  if (slowest != nullptr) return step(slowest->path, count);
  return failure("history.frames",
                 robot.empty()
                     ? "there is no robot whose frames could be stepped through; connect one or open a scene"
                     : "the program of " + robot + " has not executed a frame yet",
                 {}, {robot});
}

std::optional<History::Step> History::stepped(const std::string& stream, Instant from, bool forward) const {
  const auto& messages = store_.find(stream)->messages;
  const auto& looked = store_.lookedAt();
  // The message that held at the end of a hole may be within it, where nothing can be shown.
  const auto isShowable = [this](Instant time) { return store_.has(time) || lastKept(time) == time; };
  if (!forward) {
    const auto at = std::ranges::lower_bound(messages, from, {}, &StreamMessage::time);
    if (at != messages.begin() && isShowable(std::prev(at)->time)) return Step{std::prev(at)->time};
    const Instant begin = looked ? std::min(looked->from, store_.horizon()) : store_.horizon();
    if (begin <= kept().front().from) return std::nullopt;
    return Step{lastKept(begin - Duration(1)), true};
  }
  const auto at = std::ranges::upper_bound(messages, from, {}, &StreamMessage::time);
  // There may be more messages between the stretch that is looked at and the horizon.
  const bool isGap = looked && looked->to < store_.horizon() && from < store_.horizon();
  if (isGap && at - messages.begin() >= static_cast<std::ptrdiff_t>(store_.find(stream)->lookedAt))
    return Step{looked->to + Duration(1), true};
  if (at == messages.end()) return std::nullopt;
  // The message that was valid at the end of a hole is shown from there on.
  const bool isInHole = looked && at->time < looked->from && !isShowable(at->time);
  return Step{isInHole ? looked->from : at->time};
}

std::optional<History::Step> History::stepped(const std::vector<std::string>& streams, Instant from,
                                              bool forward) const {
  std::optional<Step> nearest;
  for (const std::string& stream : streams) {
    if (store_.find(stream) == nullptr) continue;
    const auto step = stepped(stream, from, forward);
    if (step && (!nearest || (forward ? step->at < nearest->at : step->at > nearest->at))) nearest = step;
  }
  return nearest;
}

void History::doSteps() {
  if (reading_ || steps_.count == 0) return;
  Steps rest = std::exchange(steps_, {});
  Instant at = rest.read.value_or(rest.from);
  int looked = 0;
  while (rest.count != 0 && store_.has(at)) {
    const bool forward = rest.count > 0;
    const auto next = stepped(rest.streams, rest.from, forward);
    if (!next && rest.isThere) {
      isMissed_ = true;
      return show(rest.begin);
    }
    if (!next) break;
    at = next->at;
    if (next->isUnknown) break;
    rest.from = at;
    rest.read.reset();
    const bool counts = !rest.isThere || rest.isThere(at);
    if (counts) rest.count += forward ? -1 : 1;
    if (counts || ++looked < kLookedAtOnce) continue;
    // The others are looked at in the next tick.
    steps_ = std::move(rest);
    return;
  }
  show(at);
  if (!reading_) return;
  rest.read = reading_;
  steps_ = std::move(rest);
}

Duration History::behind() const {
  return timeline_.live() ? Duration(0) : std::max(Duration(0), timeline_.newest() - chosen());
}

std::vector<Stretch> History::kept() const {
  const Instant newest = store_.newest();
  const Instant from = store_.horizon() == Instant::min() ? oldestIn(store_) : store_.horizon();
  const Stretch inMemory{std::min(from, newest), newest};
  std::vector<Stretch> all = archive_ ? readable(*archive_) : std::vector<Stretch>();
  if (all.empty() || all.back().to < from) {
    all.push_back(inMemory);
  } else {
    all.back() = {std::min(from, all.back().from), newest};
  }
  return all;
}

Instant History::lastKept(Instant time) const {
  Instant last = time;
  for (const Stretch& stretch : kept()) {
    if (stretch.from <= time) last = std::min(time, stretch.to);
  }
  return last;
}

std::optional<Stretch> History::archivedAt(Instant time) const {
  if (!archive_) return std::nullopt;
  for (const Stretch& part : readable(*archive_)) {
    if (part.from <= time && time <= part.to) return part;
  }
  return std::nullopt;
}

void History::take() {
  auto part = archive_ ? archive_->take() : std::nullopt;
  if (!part || !requested_ || part->at != *requested_) return;
  requested_.reset();
  // The history has dropped this piece meanwhile.
  if (part->messages.empty()) return goLive();
  store_.lookAt(part->stretch, std::move(part->messages));
  if (!reading_) return;
  timeline_.show(*std::exchange(reading_, std::nullopt));
  doSteps();
}

void History::keepAround() {
  const Instant shown = timeline_.shown();
  const auto& looked = store_.lookedAt();
  if (!looked || shown < looked->from || shown > looked->to) {
    // The shown instant must be there, unless another object has set the time of the timeline.
    if (!store_.has(shown)) return;
    store_.lookAt({shown - kBefore, shown + kBehind});
  }
  if (!archive_ || requested_) return;
  const auto archived = archivedAt(shown);
  if (!archived || looked->from <= archived->from || shown - looked->from >= kMargin) return;
  requested_ = shown;
  archive_->request(shown);
}

void History::tick() {
  store_.lowerBound();
  // The platform was reset, and the shown instant is in the future.
  const bool wasReset = store_.newest() < std::exchange(newest_, store_.newest());
  if (timeline_.live()) {
    if (store_.lookedAt() || reading_) goLive();
    return;
  }
  if (wasReset && chosen() > store_.newest()) return goLive();
  take();
  if (!reading_) doSteps();
  if (!reading_) keepAround();
}

}  // namespace robotlink
