// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "logplayer/RecordedFrame.h"

namespace logplayer {

/// Frames on their way to a file, and between them jobs, which are done in their turn and never dropped.
/// Holds a bounded number of bytes: past that the frame with the largest message goes first, of equal ones
/// the newest. Frames in which something holds until it is told anew go only when there are no others.
///
/// Costs logarithmic time however many frames wait. One thread at a time.
class FrameQueue {
 public:
  using Job = std::function<void()>;
  struct Entry {
    RecordedFramePtr frame;  ///< null: it is a job
    Job job;
  };

  explicit FrameQueue(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  void push(RecordedFramePtr frame);
  void push(Job job);
  /// The oldest; nothing if there is none.
  std::optional<Entry> pop();

  bool empty() const { return entries_.empty(); }
  std::size_t bytes() const { return bytes_; }
  /// Ever.
  const DroppedMessages& dropped() const { return dropped_; }

 private:
  using Rank = std::tuple<bool, std::size_t, std::uint64_t>;  // what goes first is the greatest
  static Rank rankOf(std::uint64_t number, const RecordedFrame& frame);
  void dropGreatest();

  std::size_t maxBytes_;
  std::map<std::uint64_t, Entry> entries_;  // by number
  std::set<Rank> ranks_;                    // of the frames
  std::uint64_t next_ = 0;
  std::size_t bytes_ = 0;
  DroppedMessages dropped_;
};

}  // namespace logplayer
