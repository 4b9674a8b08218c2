// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/SectionCache.h"

namespace logplayer::mcap {

/// Puts the messages of a file's sections, which may overlap, in order of time. Each section is read when the
/// first of its messages may be due. If its messages lie in order, as they mostly do, whoever wants them goes
/// over its records; otherwise they are sorted once.
class ChunkMerge {
 public:
  /// Messages that follow one another in one section.
  struct Run {
    std::uint64_t sectionOffset = 0;                 ///< in the file
    const SectionCache::Records* records = nullptr;  ///< null: there is no run; at null: it is damaged
    /// The messages in these bytes of the records that come before `until`; the first is at `begin`.
    std::size_t begin = 0, end = 0;
    std::uint64_t until = 0;  ///< ns
    /// Instead of them, if they were sorted; with their channels if they are damaged.
    std::span<const MessageRecord> messages;
    const std::uint16_t* channels = nullptr;
  };

  /// `index` and `cache` must outlive this. Sections that overlap are held up to `maxBytes` together.
  ChunkMerge(const FileIndex& index, SectionCache& cache, std::vector<std::uint16_t> channels,
             std::size_t maxBytes);

  /// The first run behind `behind`, of which this must be called with each time, is looked for.
  void seek() { standing_ = false; }
  /// The next messages behind `behind`, which is that of the last message of the run before if there was no
  /// seek(). Empty at the end, or if the sections do not fit(). Valid until the next call.
  Run next(const MessagePosition& behind);
  /// The channels that were asked for.
  const ChannelSet& wanted() const { return wanted_; }
  /// Whether the sections that overlap can be held together. Known after next().
  bool fits() const { return fits_; }

 private:
  /// A section of which messages are still to come.
  struct Open {
    std::size_t section = 0;
    std::uint64_t offset = 0;  // of the section
    SectionCache::Records records;
    bool inOrder = false;                 // as they lie in the records; else `messages` has their order
    std::vector<MessageRecord> messages;  // in order of time
    std::vector<std::uint16_t> channels;  // theirs, if there are no records
    std::size_t place = 0;                // of the next message, in the records or in `messages`...
    std::size_t end = 0;                  // ...where these end
    Instant time;                         // of the next message
    Instant last;                         // of the last message

    void goOnBehind(const MessagePosition& position, const ChannelSet& wanted);
    void goOnFrom(std::uint64_t until, const ChannelSet& wanted);
  };
  static bool isLater(const std::unique_ptr<Open>& a, const std::unique_ptr<Open>& b) {
    return a->time != b->time ? a->time > b->time : a->offset > b->offset;
  }

  const Section& section(std::size_t place) const { return index_.sections[order_[place]]; }
  void sortSections();
  bool overlapsFit() const;
  void lookUp(const MessagePosition& behind);
  void enterDue(const MessagePosition& behind);
  void enter(std::size_t section, const MessagePosition& behind);
  void lookOver(Open& open);
  void sort(Open& open) const;
  void listDamaged(Open& open);
  void finishRun();
  void leave(std::unique_ptr<Open> open);
  std::uint64_t endOfRun() const;

  const FileIndex& index_;
  SectionCache& cache_;
  std::vector<std::uint16_t> channels_;
  ChannelSet wanted_;  // the same channels
  std::size_t maxBytes_;

  std::uint64_t surprises_ = 0;       // of the cache, when the sections were sorted
  bool sorted_ = false;               // they ever were
  std::vector<std::uint32_t> order_;  // those that may hold what is wanted, by their start
  std::vector<Instant> lastEnd_;      // the latest end among the first i + 1 of them
  bool fits_ = true;

  bool standing_ = false;
  std::size_t due_ = 0;                       // the first in order_ that was not entered
  std::vector<std::unique_ptr<Open>> open_;   // a heap, the one with the next message on top
  std::vector<std::unique_ptr<Open>> spare_;  // whose memory can be used again
  std::uint64_t until_ = 0;                   // ns; the run of the one on top ends before
};

}  // namespace logplayer::mcap
