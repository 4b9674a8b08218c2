// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "logplayer/RecordedFrame.h"
#include "robotlink/session/HeldMessages.h"

namespace logplayer {

/// The last seconds of a recording in memory, by the platform's clock, and what held before them. One thread
/// at a time.
class FrameRing {
 public:
  /// What is kept at a time: a log, when it is written.
  struct Contents {
    std::vector<robotlink::StreamMessage> held;  ///< before the first frame
    std::vector<RecordedFramePtr> frames;
  };

  explicit FrameRing(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// How long; zero keeps nothing. What is too old for it goes.
  void keep(robotlink::Duration duration);
  robotlink::Duration duration() const { return duration_; }
  void add(RecordedFramePtr frame);
  /// Forgets all frames: another time begins, with what holds now.
  void restart(robotlink::HeldMessages held);

  Contents contents() const;
  bool empty() const { return frames_.empty(); }
  std::size_t bytes() const { return bytes_; }
  /// From the first frame to the last.
  robotlink::Duration span() const;

 private:
  void trim();

  std::size_t maxBytes_;
  robotlink::Duration duration_{0};
  std::deque<RecordedFramePtr> frames_;
  robotlink::HeldMessages before_;
  robotlink::Instant newest_;
  std::size_t bytes_ = 0;
};

}  // namespace logplayer
