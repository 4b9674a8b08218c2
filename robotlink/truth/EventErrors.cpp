// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/EventErrors.h"

#include "robotlink/truth/ErrorQuantity.h"

namespace robotlink {

void EventErrors::follow(Instant time, bool happens, ErrorQuantity& errors) {
  if (happens && !event_) event_ = Episode{time, time};
  if (!event_) return;
  if (happens) event_->last = time;
  const bool isOver = time - event_->last > kPause;
  const bool counts = event_->last - event_->begin >= (isOver ? kShortest : kLongest);
  if (counts && !event_->isDecided) {
    ++errors.own.there;
    ++errors.own.missed;
    event_->isDecided = true;
  }
  if (isOver) event_.reset();
}

std::optional<Duration> EventErrors::add(Instant time, bool happens, bool isReported, ErrorQuantity& errors) {
  if (newest_ && (time < *newest_ || time - *newest_ > kPause)) *this = {};
  newest_ = time;
  errors.amounts.add(happens == isReported ? 0 : 1);
  follow(time, happens, errors);
  std::optional<Duration> delay;
  if (event_ && isReported && !event_->isDecided) {
    ++errors.own.there;
    event_->isDecided = true;
    delay = time - event_->begin;
  }
  if (isReported && !alarm_) alarm_ = Episode{time, time};
  if (!alarm_) return delay;
  if (isReported) alarm_->last = time;
  if (!alarm_->isDecided && (event_ || time - alarm_->begin > kPause)) {
    ++errors.own.reported;
    errors.own.invented += event_ ? 0 : 1;
    alarm_->isDecided = true;
  }
  if (time - alarm_->last > kPause) alarm_.reset();
  return delay;
}

}  // namespace robotlink
