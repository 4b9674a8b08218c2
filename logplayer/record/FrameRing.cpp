// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/record/FrameRing.h"

#include <algorithm>
#include <utility>

namespace logplayer {

void FrameRing::keep(robotlink::Duration duration) {
  duration_ = std::max(duration, robotlink::Duration::zero());
  trim();
}

void FrameRing::add(RecordedFramePtr frame) {
  if (duration_ == robotlink::Duration::zero() || frame->messages.empty()) return;
  const robotlink::Instant time = frame->messages.back().time;
  newest_ = frames_.empty() ? time : std::max(newest_, time);
  bytes_ += frame->bytes;
  frames_.push_back(std::move(frame));
  trim();
}

void FrameRing::trim() {
  while (!frames_.empty()) {
    const RecordedFrame& oldest = *frames_.front();
    if (duration_ > robotlink::Duration::zero() && oldest.messages.back().time >= newest_ - duration_ &&
        bytes_ <= maxBytes_)
      return;
    for (const robotlink::StreamMessage& message : oldest.messages) before_.take(message);
    bytes_ -= oldest.bytes;
    frames_.pop_front();
  }
}

void FrameRing::restart(robotlink::LatchedMessages held) {
  frames_.clear();
  bytes_ = 0;
  before_ = std::move(held);
}

FrameRing::Contents FrameRing::contents() const {
  return {before_.all(), {frames_.begin(), frames_.end()}};
}

robotlink::Duration FrameRing::span() const {
  if (frames_.empty()) return robotlink::Duration::zero();
  return newest_ - std::min(newest_, frames_.front()->messages.back().time);
}

}  // namespace logplayer
