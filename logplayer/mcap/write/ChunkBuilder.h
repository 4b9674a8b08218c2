// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Codec.h"

namespace logplayer::mcap {

/// Collects the records of a chunk together with their message indexes and CRC. Reuses its memory from chunk
/// to chunk.
class ChunkBuilder {
 public:
  /// `crc`: whether the CRC is computed.
  explicit ChunkBuilder(bool crc) : computesCrc_(crc) {}

  void add(const Schema& schema) { encode(records_, schema); }
  void add(const Channel& channel) { encode(records_, channel); }
  /// Appends a message and adds it to the index of its channel.
  void add(const Message& message);
  /// Starts a new chunk.
  void clear();

  bool empty() const { return records_.empty(); }
  /// Number of messages in the chunk.
  std::uint64_t messages() const { return messages_; }
  /// Times of the earliest and the latest message; 0 without messages.
  Instant start() const { return start_; }
  Instant end() const { return end_; }
  /// The encoded, uncompressed records. Valid until the next change.
  Bytes records() const { return records_; }
  /// The CRC of the records; 0 if none is to be computed.
  std::uint32_t crc();
  /// Returns the indexes of channels with messages in the order of their first messages. Valid until the next
  /// change.
  std::span<const MessageIndex> indexes() const { return std::span(indexes_).first(used_); }

 private:
  /// The index of a channel, which is added at its first message.
  MessageIndex& indexOf(std::uint16_t channelId);
  /// Extends crc_ by the records that were added since the last call.
  void updateCrc();

  bool computesCrc_;
  Buffer records_;
  std::uint32_t crc_ = 0;
  /// Number of bytes of records_ that crc_ covers.
  std::size_t crcBytes_ = 0;
  std::uint64_t messages_ = 0;
  Instant start_, end_;
  /// Only the first used_ are valid; the others keep their memory for later.
  std::vector<MessageIndex> indexes_;
  std::size_t used_ = 0;
  /// For each channel id 1 + its position in indexes_, or 0.
  std::vector<std::uint32_t> slots_;
};

}  // namespace logplayer::mcap
