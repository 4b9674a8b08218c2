// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bitset>
#include <optional>

#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {

/// A set of channel ids.
using ChannelSet = std::bitset<1U << 16U>;

/// The place of a message's record in the records of a section, where it is known to lie as a whole.
struct MessageRecord {
  Instant time;
  /// Offset in the section's records.
  std::uint32_t offset = 0;
  /// Size of the record's content.
  std::uint32_t bytes = 0;
};

/// The time of a message; `content` is the beginning of its record's content.
inline Instant messageTime(const std::uint8_t* content) {
  return instantOf(loadNumber<std::uint64_t>(content + 6));
}

/// Decodes the message of a record in `records`. Its data refer to these.
inline Message messageIn(const std::uint8_t* records, const MessageRecord& record) {
  constexpr std::size_t kHead = kMessageHeadBytes - kRecordHeadBytes;
  const std::uint8_t* content = records + record.offset + kRecordHeadBytes;
  return {loadNumber<std::uint16_t>(content), loadNumber<std::uint32_t>(content + 2), record.time,
          instantOf(loadNumber<std::uint64_t>(content + 14)), Bytes(content + kHead, record.bytes - kHead)};
}

/// The message at an offset of a section's records; empty if there is none of this channel and time.
inline std::optional<MessageRecord> messageAt(Bytes records, std::uint64_t offset, std::uint16_t channelId,
                                              Instant time) {
  if (offset >= records.size()) return std::nullopt;
  const std::optional<RecordView> record = firstRecord(records.subspan(static_cast<std::size_t>(offset)));
  if (!record || !record->is(Opcode::kMessage)) return std::nullopt;
  const std::optional<Message> message = decodeMessage(record->content);
  if (!message || message->channelId != channelId || message->logTime != time) return std::nullopt;
  return MessageRecord{time, static_cast<std::uint32_t>(offset),
                       static_cast<std::uint32_t>(record->content.size())};
}

/// The channel of a message.
inline std::uint16_t channelOf(const std::uint8_t* records, const MessageRecord& record) {
  return loadNumber<std::uint16_t>(records + record.offset + kRecordHeadBytes);
}

/// Calls `visit` with the record of each message of some channels, until `visit` returns false or the bytes
/// are no whole records any more. Returns the offset of the first record that was not visited. For small
/// messages, these loops take most of the time of reading.
template <typename Visit>
std::size_t visitMessages(Bytes records, const ChannelSet& channels, Visit visit) {
  const std::uint8_t* const data = records.data();
  const std::size_t size = records.size();
  std::size_t offset = 0;
  while (size - offset >= kRecordHeadBytes) {
    const std::uint8_t* record = data + offset;
    const auto length = loadNumber<std::uint64_t>(record + 1);
    if (record[0] == 0 || length > size - offset - kRecordHeadBytes) break;
    const std::uint8_t* content = record + kRecordHeadBytes;
    __builtin_prefetch(record + 8 * (kRecordHeadBytes + length));
    if (record[0] == static_cast<std::uint8_t>(Opcode::kMessage) &&
        length >= kMessageHeadBytes - kRecordHeadBytes && channels[loadNumber<std::uint16_t>(content)]) {
      if (!visit(MessageRecord{messageTime(content), static_cast<std::uint32_t>(offset),
                               static_cast<std::uint32_t>(length)})) {
        return offset;
      }
    }
    offset += kRecordHeadBytes + static_cast<std::size_t>(length);
  }
  return offset;
}

/// A summary of all messages in a section's records.
struct RecordsOverview {
  /// Whether the records fill the section; otherwise what follows is only about those before the place where
  /// they break off.
  bool whole = true;
  /// Whether their times never decrease.
  bool inOrder = true;
  /// The earliest and the latest time.
  Instant first, last;
  /// The end of the last message's record; 0 if there is none.
  std::size_t end = 0;
  std::uint64_t messages = 0;
};

/// Summarizes the messages of all channels. The loop is kept short, since chunks whose messages are in order
/// need no other pass over them before they are read.
inline RecordsOverview overviewOf(Bytes records) {
  // Later times are treated as this one.
  constexpr std::uint64_t kLatest = INT64_MAX;
  const std::uint8_t* const data = records.data();
  const std::size_t size = records.size();
  std::uint64_t first = UINT64_MAX, last = 0, previous = 0;
  bool inOrder = true;
  std::size_t end = 0, offset = 0;
  std::uint64_t messages = 0;
  while (size - offset >= kRecordHeadBytes) {
    const std::uint8_t* record = data + offset;
    const auto length = loadNumber<std::uint64_t>(record + 1);
    if (record[0] == 0 || length > size - offset - kRecordHeadBytes) break;
    __builtin_prefetch(record + 8 * (kRecordHeadBytes + length));
    offset += kRecordHeadBytes + static_cast<std::size_t>(length);
    if (record[0] != static_cast<std::uint8_t>(Opcode::kMessage)) continue;
    if (length < kMessageHeadBytes - kRecordHeadBytes) continue;
    const std::uint64_t time = std::min(loadNumber<std::uint64_t>(record + kRecordHeadBytes + 6), kLatest);
    inOrder = inOrder && previous <= time;
    previous = time;
    first = std::min(first, time);
    last = std::max(last, time);
    end = offset;
    ++messages;
  }
  return {offset == size, inOrder, instantOf(first), instantOf(last), end, messages};
}

/// Returns the offset of the next message of some channels at or after `offset`; `end` if there is none.
/// overviewOf() must have found the records whole up to `end`.
inline std::size_t nextMessage(const std::uint8_t* data, std::size_t offset, std::size_t end,
                               const ChannelSet& channels) {
  while (offset < end) {
    const std::uint8_t* record = data + offset;
    const auto length = static_cast<std::size_t>(loadNumber<std::uint64_t>(record + 1));
    if (record[0] == static_cast<std::uint8_t>(Opcode::kMessage) &&
        length >= kMessageHeadBytes - kRecordHeadBytes &&
        channels[loadNumber<std::uint16_t>(record + kRecordHeadBytes)]) {
      return offset;
    }
    offset += kRecordHeadBytes + length;
  }
  return end;
}

}  // namespace logplayer::mcap
