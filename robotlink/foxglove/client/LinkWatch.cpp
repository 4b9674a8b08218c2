// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/LinkWatch.h"

#include <utility>

namespace robotlink::websocket {

void LinkWatch::enter(Phase phase, Instant since, std::string reason) {
  if (phase != phase_) since_ = since;
  phase_ = phase;
  reason_ = std::move(reason);
}

Duration LinkWatch::stepLimit() const {
  if (step_ == Step::kLookup) return times_.lookupTime;
  if (step_ == Step::kTcp) return times_.connectTime;
  return wasOpen_ ? times_.stepTime : times_.firstStepTime;
}

LinkWatch::Action LinkWatch::next(Instant now) {
  switch (step_) {
    case Step::kWaiting:
      if (now < nextTry_) return Action::kNone;
      step_ = Step::kLookup;
      stepAt_ = now;
      return Action::kConnect;
    case Step::kLookup:
    case Step::kTcp:
    case Step::kHandshake:
      return nextWhileConnecting(now);
    default:
      break;
  }
  const bool isSilent = now - heardAt_ >= times_.silentTime;
  if (isSilent)
    enter(Phase::kSilent, heardAt_, "nothing is heard of the robot");
  else if (phase_ == Phase::kSilent)
    enter(Phase::kConnected, now, "");
  if (now - heardAt_ >= times_.giveUpTime) {
    failed(Failure::kSilence, "nothing is heard of the robot; connecting again", now);
    return Action::kGiveUp;
  }
  if (now - pingedAt_ < times_.pingInterval) return Action::kNone;
  const bool asks = heardAt_ <= pingedAt_ || now - askedAt_ >= times_.roundTripInterval;
  pingedAt_ = now;
  if (asks) askedAt_ = now;
  return asks ? Action::kPing : Action::kPong;
}

LinkWatch::Action LinkWatch::nextWhileConnecting(Instant now) {
  if (now - stepAt_ >= stepLimit()) {
    failed(Failure::kSilence, whyNoStep(), now);
    return Action::kGiveUp;
  }
  if (step_ == Step::kLookup && now - stepAt_ >= times_.connectTime)
    enter(phase_, since_, "the name of the robot has not been resolved yet");
  return Action::kNone;
}

std::string LinkWatch::whyNoStep() const {
  if (step_ == Step::kLookup)
    return "the name of the robot cannot be resolved; check the name, or use the IP address";
  if (step_ == Step::kTcp) return "nothing answers there; is the robot switched on, and on this network?";
  return "the port is open, but there is no answer";
}

void LinkWatch::addressFound(Instant now) {
  if (step_ != Step::kLookup) return;
  step_ = Step::kTcp;
  stepAt_ = now;
}

void LinkWatch::stepDone(Instant now) {
  step_ = Step::kHandshake;
  stepAt_ = now;
}

void LinkWatch::greeted(Instant now) {
  step_ = Step::kOpen;
  heardAt_ = pingedAt_ = now;
  askedAt_ = now - times_.roundTripInterval;
  wasOpen_ = true;
  enter(Phase::kConnected, now, "");
}

void LinkWatch::failed(Failure failure, const std::string& reason, Instant now) {
  const bool wasOpen = step_ == Step::kOpen;
  step_ = Step::kWaiting;
  nextTry_ = now + (failure == Failure::kRefused ? times_.refusedTime : times_.retryTime);
  if (failure == Failure::kRefused) return enter(Phase::kRefused, now, reason);
  // A server that was silent and is not reached is still silent.
  const bool isSilent =
      failure == Failure::kSilence && (wasOpen || phase_ == Phase::kSilent || phase_ == Phase::kConnected);
  if (isSilent)
    enter(Phase::kSilent, wasOpen ? heardAt_ : now, reason);
  else
    enter(Phase::kConnecting, now, reason);
}

}  // namespace robotlink::websocket
