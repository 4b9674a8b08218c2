// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "logplayer/mcap/ChunkLoader.h"
#include "logplayer/mcap/MessageList.h"
#include "logplayer/mcap/RecentlyUsed.h"

namespace logplayer::mcap {

/// The sections of a file, read when they are asked for: their records, and where their messages are. Some of
/// them are kept. What cannot be read goes to the index's damage, once.
class SectionCache {
 public:
  using Records = std::shared_ptr<const Buffer>;

  /// Both must outlive this; no section may be added to `index` without a reset().
  SectionCache(const Source& source, FileIndex& index, const Reader::Options& options);

  /// Says that somebody who goes over the file has left a section behind. The memory of its records is used
  /// for the next one: that is still in the processor's caches, which makes reading twice as fast.
  void leave(std::size_t section);
  /// Fails with a sentence.
  tl::expected<Records, std::string> records(std::size_t section);
  /// Without keeping them: into `buffer`.
  tl::expected<void, std::string> readInto(std::size_t section, Buffer& buffer);
  /// Empty if the section is damaged. By its indexes where they are right, or else by its records.
  std::shared_ptr<const MessageList> messages(std::size_t section);
  /// Nothing: its indexes cannot be read, or contradict it.
  std::optional<MessageList> listByIndexes(const Section& section) const;
  /// Notes that the message indexes of a section are wrong, and no longer goes by them.
  void distrustIndexes(std::size_t section);
  /// Forgets everything: the index has other sections now.
  void reset();
  /// Notes the times of a section's first and last message, should its head lie about them.
  void correctTimes(std::size_t section, Instant first, Instant last);
  /// Looks whether all sections are where the file's summary says.
  void doubtAll();
  /// It turned out that a section is not where the file's summary says.
  bool misfit() const { return misfit_; }
  /// How often it turned out that a section holds something else than the file's index says. Whoever keeps
  /// something by that has to look again.
  std::uint64_t surprises() const { return surprises_; }

 private:
  void noteDamage(std::size_t section, const std::string& what);
  void doubt(const Section& section);

  const Source& source_;
  FileIndex& index_;
  std::size_t maxRecordBytes_;
  ChunkLoader loader_;
  RecentlyUsed<std::shared_ptr<Buffer>> records_;
  RecentlyUsed<std::shared_ptr<const MessageList>> lists_;
  std::vector<bool> noted_;
  std::uint64_t surprises_ = 0;
  bool misfit_ = false;
  std::array<std::size_t, 8> left_;  // the last sections that were left behind
  std::size_t nextLeft_ = 0;
  int keep_ = 0;  // so many sections are not given up when they are left: they were asked for again
};

}  // namespace logplayer::mcap
