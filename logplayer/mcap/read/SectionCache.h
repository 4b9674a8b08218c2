// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "logplayer/mcap/MessageRecords.h"
#include "logplayer/mcap/read/ChunkLoader.h"
#include "logplayer/mcap/read/MessageList.h"
#include "logplayer/mcap/read/ReadAhead.h"
#include "logplayer/mcap/read/RecentlyUsed.h"

namespace logplayer::mcap {

/// Loads the sections of a file on demand, their records as well as their message lists, and caches some of
/// them. What cannot be read is added once to the index's damage. The functions are for one thread.
class SectionCache {
 public:
  using Records = std::shared_ptr<const Buffer>;

  /// Source and index must outlive this object; after sections were added to the index, reset() must be
  /// called.
  SectionCache(const Source& source, FileIndex& index, const ReadOptions& options);

  /// Call this when an iteration has left a section. Its buffer is reused for the next section: it is
  /// still in the processor's caches, which makes reading twice as fast.
  void leave(std::size_t section);
  /// Begins to load a section in another thread, because it is the one that will be requested next, and to
  /// list its messages of some channels, if these are not null. Ignored if there is no such section.
  void expect(std::size_t section, std::shared_ptr<const ChannelSet> listed = nullptr);
  /// Loads the records of a section; the error is a sentence for the user. If they were expected with the
  /// channels of `listing`, that is complete, too.
  tl::expected<Records, std::string> records(std::size_t section, Listing* listing = nullptr);
  /// Loads the records into `buffer`, bypassing the cache.
  tl::expected<void, std::string> readInto(std::size_t section, Buffer& buffer, Listing* listing = nullptr);
  /// The messages of a section, from its message indexes if they are valid, otherwise from its records. Empty
  /// if the section is damaged; never null.
  std::shared_ptr<const MessageList> messages(std::size_t section);
  /// The messages of a section according to its message indexes; empty if they cannot be read or are
  /// inconsistent.
  std::optional<MessageList> listByIndexes(const Section& section) const;
  /// The messages of a section whose records break off before its end, in the order of the file: those of its
  /// message indexes, if all are there, otherwise those before that place. Reports the damage.
  std::vector<MessageRecord> messagesOfBroken(std::size_t section, Bytes records);
  /// Distrusts the message indexes of a section, if they do not list what is in its whole records.
  void compareIndexes(std::size_t section, const MessageList& found);
  /// Reports the message indexes of a section as wrong and ignores them from now on.
  void distrustIndexes(std::size_t section);
  /// Clears the cache; call this when the index was replaced.
  void reset();
  /// Notes the times of a section's first and last message, should its head lie about them.
  void correctTimes(std::size_t section, Instant first, Instant last);
  /// Looks whether all sections are where the file's summary says.
  void doubtAll();
  /// Whether a section was not where the summary says.
  bool misfit() const { return misfit_; }
  /// Increases whenever a section turns out to contain something else than the index says. Users that cache
  /// what they derived from the index compare this number.
  std::uint64_t surprises() const { return surprises_; }

 private:
  void noteDamage(std::size_t section, const Damage& damage);
  /// The messages that the message indexes of a section list; empty if one of them is not there.
  std::optional<std::vector<MessageRecord>> indexedMessages(const Section& section, Bytes records) const;
  /// Verifies that a section is where the summary says, and sets misfit_ otherwise.
  void doubt(const Section& section);

  const Source& source_;
  FileIndex& index_;
  std::size_t maxRecordBytes_;
  ChunkLoader loader_;
  ReadAhead ahead_;
  RecentlyUsed<std::shared_ptr<Buffer>> records_;
  RecentlyUsed<std::shared_ptr<const MessageList>> lists_;
  /// For each section whether it is in the index's damage.
  std::vector<bool> noted_;
  std::uint64_t surprises_ = 0;
  bool misfit_ = false;
  /// The last sections that were left.
  std::array<std::size_t, 8> left_;
  std::size_t nextLeft_ = 0;
  /// Number of calls of leave() to ignore, since a section was requested again after it had been left.
  int keep_ = 0;
};

}  // namespace logplayer::mcap
