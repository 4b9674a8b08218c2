// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/SectionCache.h"

namespace logplayer::mcap {

/// Goes from message to message in order of time over the sections of a file, which may overlap, forwards or
/// backwards. A step from where it stands costs little; a step from anywhere else looks that place up first.
class Walk {
 public:
  enum class Direction : std::uint8_t { kForward, kBackward };

  /// `index` and `cache` must outlive this.
  Walk(Direction direction, const FileIndex& index, SectionCache& cache);

  /// The next position in this direction behind `than`, which need not be that of a message.
  std::optional<MessagePosition> step(const MessagePosition& than,
                                      const std::vector<std::uint16_t>& channels);

 private:
  /// The messages of a channel in one section that are still to come.
  struct Run {
    std::size_t section = 0;
    std::shared_ptr<const MessageList> list;      ///< null: it is over
    std::span<const MessageList::Entry> entries;  ///< the next one is the first, or backwards the last
  };
  /// The next message of a run.
  struct Next {
    MessagePosition position;
    std::size_t run = 0;
  };

  bool before(const MessagePosition& a, const MessagePosition& b) const {
    if (a.time != b.time) return earlier(a.time, b.time);
    return direction_ == Direction::kForward ? a < b : b < a;
  }
  /// When a section can first yield something, in this direction.
  Instant opening(const Section& section) const {
    return direction_ == Direction::kForward ? section.info.start : section.info.end;
  }
  Instant closing(const Section& section) const {
    return direction_ == Direction::kForward ? section.info.end : section.info.start;
  }
  bool earlier(Instant a, Instant b) const { return direction_ == Direction::kForward ? a < b : b < a; }

  void sortSections();
  void seek(const MessagePosition& than, const std::vector<std::uint16_t>& channels);
  void enter(std::size_t section, const MessagePosition& than);
  void enterDue(const MessagePosition& than);
  void look(Next& next) const;
  void add(Run run, MessagePosition position);
  void advanceTop();
  void sink(Next next);
  void leave(std::size_t section);

  Direction direction_;
  const FileIndex& index_;
  SectionCache& cache_;
  std::vector<std::uint32_t> order_;  // sections by their opening
  std::vector<Instant> lastClosing_;  // the furthest closing among the first i + 1 of them

  std::uint64_t surprises_ = 0;  // of the cache, when the sections were sorted

  bool standing_ = false;
  MessagePosition at_;
  std::vector<std::uint16_t> channels_;
  std::size_t due_ = 0;  // the first in order_ that was not entered
  std::vector<Run> runs_;
  std::vector<std::size_t> over_;  // those of them that can be used again
  std::vector<Next> next_;         // of the others; a heap, the next one on top
};

}  // namespace logplayer::mcap
