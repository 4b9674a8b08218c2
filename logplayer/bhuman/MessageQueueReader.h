// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "logplayer/bhuman/ByteSource.h"

namespace logplayer::bhuman {

/// A message of a queue; its payload is valid until the next call of next().
struct QueueMessage {
  /// See Kind; may be unknown.
  std::uint8_t id = 0;
  /// Offset of the id in the file.
  std::uint64_t offset = 0;
  std::span<const std::uint8_t> payload;
};

/// A problem of a file and its offset.
struct QueueDamage {
  std::uint64_t offset = 0;
  std::string text;
};

/// Reads a message queue of the GermanTeam's family from a log file, message by message (MESSAGE_QUEUES.md).
///
/// No length is trusted: a message is accepted if its size is exactly that of its kind, or if it is followed
/// by other messages. Otherwise the reader searches for the next place with messages and reports what it
/// skipped, so that damage affects only the messages it hit. The numbers in the header of the file are
/// compared with what was read; differences are reported. Holds one message, at most 16 MiB. One thread;
/// `bytes` must outlive this object.
class MessageQueueReader {
 public:
  explicit MessageQueueReader(ByteSource& bytes);

  /// Whether the bytes begin as such a log does.
  static bool recognizes(ByteSource& bytes);

  /// Returns the next message; empty at the end.
  std::optional<QueueMessage> next();
  /// Offset of the next message.
  std::uint64_t position() const { return position_; }

  /// The damage found so far; only the first places are stored.
  const std::vector<QueueDamage>& damage() const { return damage_; }
  /// Number of all damaged places.
  std::uint64_t damageCount() const { return damageCount_; }
  /// Adds damage that the user of the messages found.
  void addDamage(std::uint64_t offset, std::string text);

 private:
  /// A possible message at some place.
  struct Header {
    std::uint8_t id = 0;
    std::uint32_t size = 0;
    /// Offset of the payload.
    std::uint64_t payload = 0;
    /// Offset of the following message.
    std::uint64_t end() const { return payload + size; }
  };
  /// The header at an offset; empty if the message would not fit into the file.
  std::optional<Header> headerAt(std::uint64_t offset);
  /// Whether the payload alone proves that this is a message.
  bool certain(const Header& header);
  /// Whether this is probably a message; `depth`: how many messages must follow it.
  bool plausible(const Header& header, int depth);
  /// Whether `depth` messages, or the end of the file, follow.
  bool followedByMessages(const Header& header, int depth);
  /// End of the bytes at the current position that are no message.
  std::uint64_t endOfDamage();
  /// The next offset, beginning with `offset`, at which messages are.
  std::uint64_t search(std::uint64_t offset);
  std::optional<std::uint64_t> searchBlock(std::uint64_t offset, std::span<const std::uint8_t> block);
  /// Compares the numbers in the header with what was read.
  void finish();

  ByteSource& bytes_;
  /// Behind the header of 8 bytes at first.
  std::uint64_t position_ = 8;
  /// Size and number of messages according to the header of the file.
  std::int64_t statedBytes_ = 0;
  std::int64_t statedMessages_ = 0;
  std::uint64_t messages_ = 0;
  /// Whether the log comes from other code, in which kinds have other sizes.
  bool otherSizes_ = false;
  bool finished_ = false;
  std::vector<std::uint8_t> payload_;
  std::vector<QueueDamage> damage_;
  std::uint64_t damageCount_ = 0;
};

}  // namespace logplayer::bhuman
