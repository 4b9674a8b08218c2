// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ExportClock.h"

#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/log/ReplayControl.h"

namespace widgets {

using robotlink::Instant;

struct ExportClock::Reply {
  bool hasCome = false;
  std::string refusal;
};

ExportClock::ExportClock(robotlink::Session& session, ReplayControl& replay)
    : session_(session), replay_(replay), isLog_(replay.open()), generation_(session.store().generation()) {
  if (isLog_) {
    before_ = replay.shown();
  } else if (!session.timeline().live()) {
    before_ = session.history().chosen();
  }
}

ExportClock::~ExportClock() {
  if (isLog_) {
    if (replay_.open()) replay_.jumpTo(*before_);
  } else if (before_) {
    session_.history().show(*before_);
  } else {
    session_.history().goLive();
  }
}

void ExportClock::show(Instant time) {
  isLog_ ? request(time) : session_.history().show(time);
}

void ExportClock::request(Instant time) {
  reply_ = std::make_shared<Reply>();
  robotcontrol::Request request;
  request.mutable_control_replay()->set_action(robotcontrol::ControlReplay::ADVANCE_TO_TIME);
  request.mutable_control_replay()->set_time(time.time_since_epoch().count());
  session_.request(std::move(request), [reply = reply_](const robotcontrol::RequestResult& result) {
    reply->hasCome = true;
    if (!result.accepted()) reply->refusal = result.reason();
  });
}

bool ExportClock::hasArrived() const {
  return isLog_ ? reply_ && reply_->hasCome && reply_->refusal.empty() : !session_.history().isReading();
}

std::string ExportClock::problem() const {
  if (isLog_ && !replay_.open()) return "the log was closed";
  // A log is replaced by itself with each jump.
  if (!isLog_ && (replay_.open() || session_.store().generation() != generation_))
    return "something else was opened";
  return reply_ ? reply_->refusal : std::string();
}

}  // namespace widgets
