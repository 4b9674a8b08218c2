// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "logplayer/record/RecordedFrame.h"

namespace logplayer {

/// The queue between a recorder and the thread that writes its file: frames and, in between, jobs, which keep
/// their place and are never dropped. The total size of the frames is bounded: if it exceeds the limit, the
/// frame with the largest message is dropped first, of several the newest. Frames with latched messages are
/// dropped only if there are no others.
///
/// Each operation takes logarithmic time in the number of entries. Not synchronized: one thread at a time.
class FrameQueue {
 public:
  /// Work that must happen between frames, such as closing the file.
  using Job = std::function<void()>;
  /// A frame or a job.
  struct Entry {
    /// Null for a job.
    RecordedFramePtr frame;
    Job job;
  };

  /// `maxBytes`: the maximum of the sum of RecordedFrame::bytes.
  explicit FrameQueue(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// Enqueues a frame; this may drop frames, including this one.
  void push(RecordedFramePtr frame);
  void push(Job job);
  /// Removes and returns the oldest entry; empty if there is none.
  std::optional<Entry> pop();

  bool empty() const { return entries_.empty(); }
  /// The size of all frames in the queue.
  std::size_t bytes() const { return bytes_; }
  /// All messages dropped since the queue was created.
  const DroppedMessages& dropped() const { return dropped_; }

 private:
  /// Drop order: the frame with the greatest rank is dropped first. Not latched, size of the largest message,
  /// number.
  using Rank = std::tuple<bool, std::size_t, std::uint64_t>;
  static Rank rankOf(std::uint64_t number, const RecordedFrame& frame);
  /// Drops the frame with the greatest rank.
  void dropGreatest();

  std::size_t maxBytes_;
  /// Keyed by number, and thus in order.
  std::map<std::uint64_t, Entry> entries_;
  /// The ranks of the frames in the queue, one for each.
  std::set<Rank> ranks_;
  /// Number of the next entry.
  std::uint64_t next_ = 0;
  std::size_t bytes_ = 0;
  DroppedMessages dropped_;
};

}  // namespace logplayer
