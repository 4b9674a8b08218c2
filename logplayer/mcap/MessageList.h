// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/FileIndex.h"

namespace logplayer::mcap {

/// Where the messages of a section are: for each channel sorted by time, equal times in the order of the
/// file.
class MessageList {
 public:
  struct Entry {
    Instant time;
    std::uint32_t offset = 0;  ///< in the section's records
    bool operator==(const Entry&) const = default;
  };

  std::span<const Entry> of(std::uint16_t channelId) const;
  std::size_t messages() const { return entries_.size(); }
  std::size_t bytes() const { return sizeof *this + entries_.size() * sizeof(Entry) + channels_.size() * 16; }
  const std::vector<Entry>& entries() const { return entries_; }

  struct Channel {
    std::uint16_t id = 0;
    std::size_t first = 0, count = 0;
    bool operator==(const Channel&) const = default;
  };
  const std::vector<Channel>& channels() const { return channels_; }

  /// From the message index records behind a chunk. Nothing: they contradict the section, or themselves.
  static std::optional<MessageList> fromIndexes(Bytes indexes, const Section& section);
  /// From the records of a section.
  static MessageList fromRecords(Bytes records);

  /// The same messages of the same channels.
  bool operator==(const MessageList& other) const;

 private:
  void sortChannels();
  bool listsEachOnce() const;

  std::vector<Entry> entries_;     // channel by channel
  std::vector<Channel> channels_;  // by id
};

}  // namespace logplayer::mcap
