// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <vector>

#include "logplayer/record/RecordedFrame.h"
#include "robotlink/session/LatchedMessages.h"

namespace logplayer {

/// The last seconds of a recording in memory, measured in log time, together with the latched messages from
/// before. Bounded in time and bytes; the oldest frames are removed first. Not synchronized: one thread at a
/// time.
class FrameRing {
 public:
  /// A snapshot of the ring: the contents of a log file.
  struct Contents {
    /// The latched messages at the time of the first frame.
    std::vector<robotlink::StreamMessage> held;
    std::vector<RecordedFramePtr> frames;
  };

  /// `maxBytes`: the maximum of the sum of RecordedFrame::bytes.
  explicit FrameRing(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// Sets how many seconds are kept and removes older frames. Zero keeps nothing.
  void keep(robotlink::Duration duration);
  robotlink::Duration duration() const { return duration_; }
  /// Appends a frame and removes frames that are too old. Ignored if nothing is kept.
  void add(RecordedFramePtr frame);
  /// Removes all frames, for example because time was reset; `held` are the latched messages now.
  void restart(robotlink::LatchedMessages held);

  Contents contents() const;
  bool empty() const { return frames_.empty(); }
  std::size_t bytes() const { return bytes_; }
  /// Time from the first frame to the last.
  robotlink::Duration span() const;

 private:
  /// Removes frames that are too old or too many; their latched messages go to before_.
  void trim();

  std::size_t maxBytes_;
  robotlink::Duration duration_{0};
  std::deque<RecordedFramePtr> frames_;
  /// The latched messages before the first frame.
  robotlink::LatchedMessages before_;
  /// The latest time of a frame in the ring.
  robotlink::Instant newest_;
  std::size_t bytes_ = 0;
};

}  // namespace logplayer
