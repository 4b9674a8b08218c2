// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/SectionCache.h"

namespace logplayer::mcap {

/// Merges the messages of a file's sections, which may overlap in time, in order of time. A section is read
/// when the first of its messages may be due; its messages are listed then, and sorted if they are not in
/// order. One thread at a time.
class ChunkMerge {
 public:
  /// Consecutive messages of one section.
  struct Run {
    /// Offset of the section in the file.
    std::uint64_t sectionOffset = 0;
    /// The records of the section. Null: there is no run. A pointer to null: the section is damaged.
    const SectionCache::Records* records = nullptr;
    /// In order of time; with their channels if the section is damaged.
    std::span<const MessageRecord> messages;
    const std::uint16_t* channels = nullptr;
  };

  /// `index` and `cache` must outlive this object. Sections that overlap may have up to `maxBytes` together.
  ChunkMerge(const FileIndex& index, SectionCache& cache, std::vector<std::uint16_t> channels,
             std::size_t maxBytes);

  /// The next call of next() searches again.
  void seek() { standing_ = false; }
  /// The next run of messages behind a position. Without a seek() before, `behind` must be the last message
  /// of the previous run. Empty at the end, or if the sections do not fit(). Valid until the next call.
  Run next(const MessagePosition& behind);
  /// Whether overlapping sections fit into `maxBytes`. Known after next().
  bool fits() const { return fits_; }

 private:
  /// A section that has messages still to come.
  struct Open {
    std::size_t section = 0;
    /// Offset of the section in the file.
    std::uint64_t offset = 0;
    SectionCache::Records records;
    /// The first `end` of its messages are in order of time; those beyond are spare memory.
    Listing listing;
    /// The channels of these messages, if the section is damaged.
    std::vector<std::uint16_t> channels;
    /// The next message and the end.
    std::size_t place = 0;
    std::size_t end = 0;
    /// The time of the next message.
    Instant time;
    /// The time of the last message.
    Instant last;

    /// Moves to the first message behind a position.
    void seekBehind(const MessagePosition& position);
    /// Moves to the first message not before a time, in ns.
    void seek(std::uint64_t until);
  };
  /// The order of the heap: by time, then by place in the file.
  static bool isLater(const std::unique_ptr<Open>& a, const std::unique_ptr<Open>& b) {
    return a->time != b->time ? a->time > b->time : a->offset > b->offset;
  }

  /// The section at an index of order_.
  const Section& section(std::size_t place) const { return index_.sections[order_[place]]; }
  /// Sorts the sections that may have messages of the channels.
  void sortSections();
  /// Whether at no time the overlapping sections exceed maxBytes_. A single section always fits.
  bool overlapsFit() const;
  /// Opens the sections that may have messages around a position.
  void lookUp(const MessagePosition& behind);
  /// Opens the sections that may have a message before the next one.
  void enterDue(const MessagePosition& behind);
  /// Reads a section and opens it, if it has messages behind the position.
  void enter(std::size_t section, const MessagePosition& behind);
  /// Lists the messages of a section in order of time.
  void lookOver(Open& open);
  /// Sorts those that can be found in a section whose records break off before its end.
  void sortBroken(Open& open);
  /// Lists the messages of a damaged section by its message indexes, so that users learn what is missing.
  void listDamaged(Open& open);
  /// Moves behind the run that next() has returned.
  void finishRun();
  /// Closes a section and keeps its memory for the next one.
  void leave(std::unique_ptr<Open> open);
  /// The time, in ns, before which the messages of the topmost section precede those of all others.
  std::uint64_t endOfRun() const;

  const FileIndex& index_;
  SectionCache& cache_;
  std::vector<std::uint16_t> channels_;
  /// The same channels as a set.
  std::shared_ptr<const ChannelSet> wanted_;
  std::size_t maxBytes_;

  /// SectionCache::surprises() when the sections were sorted.
  std::uint64_t surprises_ = 0;
  /// Whether the sections were ever sorted.
  bool sorted_ = false;
  /// The sections that may have messages of the channels, by their start.
  std::vector<std::uint32_t> order_;
  /// For each index of order_, the latest end up to there.
  std::vector<Instant> lastEnd_;
  bool fits_ = true;

  /// Whether open_ and due_ belong to the last run.
  bool standing_ = false;
  /// Whether a section was iterated to its end since the last search, so that the next ones are read ahead.
  bool walked_ = false;
  /// The first index of order_ that was not opened.
  std::size_t due_ = 0;
  /// A heap with the section of the next message on top.
  std::vector<std::unique_ptr<Open>> open_;
  /// Closed sections, whose memory is reused.
  std::vector<std::unique_ptr<Open>> spare_;
  /// The end of the last run, in ns.
  std::uint64_t until_ = 0;
};

}  // namespace logplayer::mcap
