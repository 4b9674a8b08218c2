// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/read/SectionCache.h"

namespace logplayer::mcap {

/// Iterates over the messages of a file in order of time, forwards or backwards; the time ranges of sections
/// may overlap. A step from the current position is cheap; a step from anywhere else first searches that
/// position. A k-way merge: a heap holds the next message of each open section and channel. One thread.
class Walk {
 public:
  enum class Direction : std::uint8_t { kForward, kBackward };

  /// `index` and `cache` must outlive this object.
  Walk(Direction direction, const FileIndex& index, SectionCache& cache);

  /// The first position beyond `than` in this direction; `than` need not be that of a message. Empty at the
  /// end.
  std::optional<MessagePosition> step(const MessagePosition& than,
                                      const std::vector<std::uint16_t>& channels);

 private:
  /// The remaining messages of one channel in one section.
  struct Run {
    std::size_t section = 0;
    /// Keeps the entries alive; null: the run is finished.
    std::shared_ptr<const MessageList> list;
    /// The next message is the first one, or backwards the last one.
    std::span<const MessageList::Entry> entries;
  };
  /// The next message of a run, an element of the heap.
  struct Next {
    MessagePosition position;
    std::size_t run = 0;
  };

  /// Whether `a` comes before `b` in the direction of the walk.
  bool before(const MessagePosition& a, const MessagePosition& b) const {
    if (a.time != b.time) return earlier(a.time, b.time);
    return direction_ == Direction::kForward ? a < b : b < a;
  }
  /// The earliest, in this direction, of the times of a section.
  Instant opening(const Section& section) const {
    return direction_ == Direction::kForward ? section.info.start : section.info.end;
  }
  /// The latest, in this direction, of the times of a section.
  Instant closing(const Section& section) const {
    return direction_ == Direction::kForward ? section.info.end : section.info.start;
  }
  bool earlier(Instant a, Instant b) const { return direction_ == Direction::kForward ? a < b : b < a; }

  /// Sorts the sections by opening time; needed again after their times were corrected.
  void sortSections();
  /// Restarts behind `than`.
  void seek(const MessagePosition& than, const std::vector<std::uint16_t>& channels);
  /// Adds the runs of a section that have messages beyond `than`.
  void enter(std::size_t section, const MessagePosition& than);
  /// Enters the sections that may contain the next message.
  void enterDue(const MessagePosition& than);
  /// Sets a heap element to the next message of its run.
  void look(Next& next) const;
  /// Adds a run and pushes its next message onto the heap.
  void add(Run run, MessagePosition position);
  /// Advances the run on top of the heap by one message.
  void advanceTop();
  /// Restores the heap by moving an element down from the top.
  void sink(Next next);
  /// Informs the cache that a section is finished.
  void leave(std::size_t section);

  Direction direction_;
  const FileIndex& index_;
  SectionCache& cache_;
  /// Sections sorted by opening time.
  std::vector<std::uint32_t> order_;
  /// Element i: the latest closing time among the first i + 1 sections of order_.
  std::vector<Instant> lastClosing_;

  /// SectionCache::surprises() when the sections were sorted.
  std::uint64_t surprises_ = 0;

  /// Whether the state below is valid for continuing from at_.
  bool standing_ = false;
  /// The last result.
  MessagePosition at_;
  std::vector<std::uint16_t> channels_;
  /// Index in order_ of the first section that was not entered.
  std::size_t due_ = 0;
  std::vector<Run> runs_;
  /// Indices of finished elements of runs_ that can be reused.
  std::vector<std::size_t> over_;
  /// A heap with one element per unfinished run; the next message is on top.
  std::vector<Next> next_;
};

}  // namespace logplayer::mcap
