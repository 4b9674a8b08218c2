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

/// One message of a queue; its payload is valid until the next one is asked for.
struct QueueMessage {
  std::uint8_t id = 0;
  std::uint64_t offset = 0;  ///< in the file, of its id
  std::span<const std::uint8_t> payload;
};

/// Something that is wrong with a file, and where.
struct QueueDamage {
  std::uint64_t offset = 0;
  std::string text;
};

/// Reads a message queue of the GermanTeam's lineage from a log file, message by message (MESSAGE_QUEUES.md).
///
/// No length is trusted: a message is taken if its kind has just this size, or if what follows it is
/// messages again; else the reader looks for the next place where there are some, and tells what it left out.
/// So damage costs the message that it hit. What the header states is compared, and told where it lies. Holds
/// one message, at most 16 MiB. One thread; `bytes` must outlive it.
class MessageQueueReader {
 public:
  explicit MessageQueueReader(ByteSource& bytes);

  /// Whether the bytes begin as such a log does.
  static bool recognises(ByteSource& bytes);

  /// Nothing at the end.
  std::optional<QueueMessage> next();
  std::uint64_t position() const { return position_; }

  /// So far; complete after the last message. Only the first places are kept.
  const std::vector<QueueDamage>& damage() const { return damage_; }
  std::uint64_t damageCount() const { return damageCount_; }
  void addDamage(std::uint64_t offset, std::string text);

 private:
  struct Header {
    std::uint8_t id = 0;
    std::uint32_t size = 0;
    std::uint64_t payload = 0;  ///< offset
    std::uint64_t end() const { return payload + size; }
  };
  std::optional<Header> headerAt(std::uint64_t offset);
  /// The payload alone tells that there is a message.
  bool certain(const Header& header);
  /// `depth`: how many messages must follow.
  bool plausible(const Header& header, int depth);
  bool followedByMessages(const Header& header, int depth);
  /// Where what is no message at the position ends.
  std::uint64_t endOfDamage();
  /// The next place from `offset` on where messages are.
  std::uint64_t search(std::uint64_t offset);
  std::optional<std::uint64_t> searchBlock(std::uint64_t offset, std::span<const std::uint8_t> block);
  void finish();

  ByteSource& bytes_;
  std::uint64_t position_ = 8;
  std::int64_t statedBytes_ = 0;
  std::int64_t statedMessages_ = 0;
  std::uint64_t messages_ = 0;
  bool otherSizes_ = false;  ///< the log is of other code: kinds have other sizes than those known
  bool finished_ = false;
  std::vector<std::uint8_t> payload_;
  std::vector<QueueDamage> damage_;
  std::uint64_t damageCount_ = 0;
};

}  // namespace logplayer::bhuman
