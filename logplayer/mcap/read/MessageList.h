// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/read/FileIndex.h"

namespace logplayer::mcap {

/// Times and positions of the messages of a section, per channel, sorted by time; equal times in the order of
/// the file. Immutable once it is built.
class MessageList {
 public:
  /// The entry of a message.
  struct Entry {
    Instant time;
    /// Offset within the section's decompressed records.
    std::uint32_t offset = 0;
    bool operator==(const Entry&) const = default;
  };

  /// The messages of a channel; empty if there are none.
  std::span<const Entry> of(std::uint16_t channelId) const;
  /// Number of messages of all channels.
  std::size_t messages() const { return entries_.size(); }
  /// Approximate memory of this object.
  std::size_t bytes() const { return sizeof *this + entries_.size() * sizeof(Entry) + channels_.size() * 16; }
  /// The messages of all channels, channel by channel.
  const std::vector<Entry>& entries() const { return entries_; }

  /// The range of a channel's messages in entries().
  struct Channel {
    std::uint16_t id = 0;
    std::size_t first = 0, count = 0;
    bool operator==(const Channel&) const = default;
  };
  const std::vector<Channel>& channels() const { return channels_; }

  /// Decodes the message index records behind a chunk; empty if they contradict the section or themselves.
  static std::optional<MessageList> fromIndexes(Bytes indexes, const Section& section);
  /// Lists the messages in the records of a section.
  static MessageList fromRecords(Bytes records);

  /// Whether both list the same messages of the same channels.
  bool operator==(const MessageList& other) const;

 private:
  /// Sorts channels by id, and their messages by time.
  void sortChannels();
  /// Whether no channel and no message occurs twice.
  bool listsEachOnce() const;

  /// Channel by channel.
  std::vector<Entry> entries_;
  /// Sorted by id.
  std::vector<Channel> channels_;
};

}  // namespace logplayer::mcap
