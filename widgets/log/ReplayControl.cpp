// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ReplayControl.h"

#include <QPointer>
#include <algorithm>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/log/TimeScale.h"

namespace widgets {

using robotcontrol::ControlReplay;
using robotlink::Duration;
using robotlink::Instant;

namespace {

constexpr char kStream[] = "replay";
constexpr int kMaxTicksToWait = 90;  // three seconds; then the reply counts as lost

ControlReplay action(ControlReplay::Action what) {
  ControlReplay control;
  control.set_action(what);
  return control;
}

Instant instant(std::int64_t ns) {
  return Instant(Duration(ns));
}

}  // namespace

ReplayControl::ReplayControl(robotlink::Session& session, QObject* parent)
    : QObject(parent), session_(session) {}

ReplayControl::~ReplayControl() = default;

void ReplayControl::refresh() {
  // The message published last, whatever its time: a jump back must be shown at once.
  const auto* stream = session_.store().find(kStream);
  const auto* message = stream != nullptr && !stream->messages.empty() ? &stream->messages.back() : nullptr;
  auto status = message != nullptr
                    ? std::dynamic_pointer_cast<const robotcontrol::ReplayStatus>(message->value)
                    : nullptr;
  status_ = status != nullptr && status->logs_size() > 0 ? std::move(status) : nullptr;
  setOrigin();
  const std::uint64_t generation = session_.store().generation();
  if (generation != generation_ || open()) liveRange_.reset();
  generation_ = generation;
  if (status_ == nullptr) {
    aim_.reset();
    jumping_ = false;
    return;
  }
  if (jumping_ && ++ticksWaited_ > kMaxTicksToWait) jumping_ = false;
  if (!jumping_ && newerAim_) sendJump();
  if (!jumping_ && aim_) aim_.reset();
}

void ReplayControl::setShowsTimeStamps(bool on) {
  showsTimeStamps_ = on;
  setOrigin();
}

void ReplayControl::setOrigin() {
  session_.timeline().setOrigin(open() && !showsTimeStamps_ ? begin() : Instant());
}

Instant ReplayControl::origin() const {
  return session_.timeline().origin();
}

QString ReplayControl::shownText(Instant time) const {
  return timeText(time - origin());
}

const robotcontrol::ReplayStatus& ReplayControl::status() const {
  return status_ != nullptr ? *status_ : robotcontrol::ReplayStatus::default_instance();
}

Instant ReplayControl::shown() const {
  return aim_.value_or(instant(status().time()));
}
Instant ReplayControl::begin() const {
  return instant(status().begin());
}
Instant ReplayControl::start() const {
  return instant(std::max(status().start(), status().begin()));
}
Instant ReplayControl::end() const {
  return instant(status().end());
}

std::optional<std::pair<Instant, Instant>> ReplayControl::range() const {
  if (!open()) return liveRange_;
  const auto& range = status().range();
  if (range.from() == range.to()) return std::nullopt;
  return std::pair(instant(range.from()), instant(range.to()));
}

void ReplayControl::send(ControlReplay control) {
  robotcontrol::Request request;
  *request.mutable_control_replay() = std::move(control);
  session_.request(std::move(request),
                   [guard = QPointer<ReplayControl>(this)](const robotcontrol::RequestResult& result) {
                     if (guard && !result.accepted())
                       Q_EMIT guard->refused(QString::fromStdString(result.reason()));
                   });
}

void ReplayControl::play() {
  send(action(ControlReplay::PLAY));
}
void ReplayControl::pause() {
  send(action(ControlReplay::PAUSE));
}
void ReplayControl::playOrPause() {
  status().playing() ? pause() : play();
}
void ReplayControl::stop() {
  send(action(ControlReplay::STOP));
}

void ReplayControl::stepFrames(int count) {
  ControlReplay control = action(ControlReplay::STEP_FRAME);
  control.set_count(count);
  send(std::move(control));
}

void ReplayControl::stepMessages(int count, const std::string& stream) {
  ControlReplay control = action(ControlReplay::STEP_MESSAGE);
  control.set_count(count);
  control.set_stream(stream.empty() ? steppedStream_ : stream);
  send(std::move(control));
}

void ReplayControl::jumpTo(Instant time) {
  aim_ = begin() <= end() ? std::clamp(time, begin(), end()) : time;
  newerAim_ = true;
  if (!jumping_) sendJump();
}

void ReplayControl::sendJump() {
  robotcontrol::Request request;
  *request.mutable_control_replay() = action(ControlReplay::JUMP_TO_TIME);
  request.mutable_control_replay()->set_time(aim_->time_since_epoch().count());
  newerAim_ = false;
  jumping_ = true;
  ticksWaited_ = 0;
  session_.request(std::move(request),
                   [guard = QPointer<ReplayControl>(this)](const robotcontrol::RequestResult& result) {
                     if (!guard) return;
                     guard->jumping_ = false;
                     if (!result.accepted()) Q_EMIT guard->refused(QString::fromStdString(result.reason()));
                   });
}

void ReplayControl::setLoop(bool on) {
  ControlReplay control;
  control.set_loop(on);
  send(std::move(control));
}

void ReplayControl::setRange(Instant from, Instant to) {
  const auto [first, last] = std::minmax(from, to);
  if (!open()) {
    liveRange_ = std::pair(first, last);
    return;
  }
  ControlReplay control;
  control.mutable_range()->set_from(std::clamp(first, begin(), end()).time_since_epoch().count());
  control.mutable_range()->set_to(std::clamp(last, begin(), end()).time_since_epoch().count());
  send(std::move(control));
}

void ReplayControl::clearRange() {
  liveRange_.reset();
  if (!open()) return;
  ControlReplay control;
  control.mutable_range();
  send(std::move(control));
}

void ReplayControl::beginRangeHere() {
  const auto old = range();
  const Instant here = open() ? shown() : session_.history().chosen();
  setRange(here, old && old->second > here ? old->second : open() ? end() : session_.timeline().newest());
}

void ReplayControl::endRangeHere() {
  const auto old = range();
  const Instant here = open() ? shown() : session_.history().chosen();
  setRange(old && old->first < here ? old->first
           : open()                 ? begin()
                                    : session_.history().kept().front().from,
           here);
}

void ReplayControl::choosePackage(const std::string& package, ControlReplay::PackageSource source) {
  ControlReplay control;
  auto& choice = *control.add_packages();
  choice.set_package(package);
  choice.set_source(source);
  send(std::move(control));
}

void ReplayControl::setOffset(const std::string& log, Duration offset) {
  ControlReplay control;
  auto& entry = *control.add_offsets();
  entry.set_log(log);
  entry.set_offset(offset.count());
  send(std::move(control));
}

void ReplayControl::setSteppedStream(const std::string& stream) {
  if (stream == steppedStream_) return;
  steppedStream_ = stream;
  Q_EMIT steppedStreamChanged();
}

}  // namespace widgets
