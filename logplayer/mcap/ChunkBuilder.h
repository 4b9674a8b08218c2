// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Codec.h"

namespace logplayer::mcap {

/// Gathers the records of a chunk, with their index and their CRC. Keeps its memory between chunks.
class ChunkBuilder {
 public:
  explicit ChunkBuilder(bool crc) : computesCrc_(crc) {}

  void add(const Schema& schema) { encode(records_, schema); }
  void add(const Channel& channel) { encode(records_, channel); }
  void add(const Message& message);
  void clear();

  bool empty() const { return records_.empty(); }
  std::uint64_t messages() const { return messages_; }
  Instant start() const { return start_; }
  Instant end() const { return end_; }
  Bytes records() const { return records_; }
  /// The CRC of the records; 0 if none is to be computed.
  std::uint32_t crc();
  /// One for each channel that has messages, in the order of their first ones.
  std::span<const MessageIndex> indexes() const { return std::span(indexes_).first(used_); }

 private:
  MessageIndex& indexOf(std::uint16_t channelId);
  void updateCrc();

  bool computesCrc_;
  Buffer records_;
  std::uint32_t crc_ = 0;
  std::size_t crcBytes_ = 0;  // of the records that are in crc_
  std::uint64_t messages_ = 0;
  Instant start_, end_;
  std::vector<MessageIndex> indexes_;  // the first used_ of them; the others keep their memory
  std::size_t used_ = 0;
  std::vector<std::uint32_t> slots_;  // by channel: 1 + its place in indexes_, 0 for none
};

}  // namespace logplayer::mcap
