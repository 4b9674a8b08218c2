// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bitset>
#include <memory>
#include <optional>
#include <vector>

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

/// Returns the message at an offset of a section's records; empty if there is none of this channel and time.
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
/// are no longer whole records. Returns the offset of the first record that was not visited. For small
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
    __builtin_prefetch(record + 24 * (kRecordHeadBytes + length));
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
  /// How many messages were listed, and how many there are of all channels.
  std::size_t listed = 0;
  std::uint64_t messages = 0;
};

/// Summarizes the messages of all channels, and lists those of some in the order of the records. They are the
/// first ones in `messages`, which grows but does not shrink, since memory that is not initialized again is
/// faster. The loop is kept short: it takes most of the time of reading small messages in order of time.
inline RecordsOverview overviewOf(Bytes records, const ChannelSet& channels,
                                  std::vector<MessageRecord>& messages) {
  // Later times are treated as this one.
  constexpr std::uint64_t kLatest = INT64_MAX;
  const std::uint8_t* const data = records.data();
  const std::size_t size = records.size();
  std::uint64_t first = UINT64_MAX, last = 0, previous = 0, count = 0;
  bool inOrder = true;
  std::size_t offset = 0, listed = 0;
  if (messages.empty()) messages.resize(64);
  while (size - offset >= kRecordHeadBytes) {
    const std::uint8_t* record = data + offset;
    const auto length = loadNumber<std::uint64_t>(record + 1);
    if (record[0] == 0 || length > size - offset - kRecordHeadBytes) break;
    __builtin_prefetch(record + 24 * (kRecordHeadBytes + length));
    const auto at = static_cast<std::uint32_t>(offset);
    offset += kRecordHeadBytes + static_cast<std::size_t>(length);
    if (record[0] != static_cast<std::uint8_t>(Opcode::kMessage)) continue;
    if (length < kMessageHeadBytes - kRecordHeadBytes) continue;
    const std::uint64_t time = std::min(loadNumber<std::uint64_t>(record + kRecordHeadBytes + 6), kLatest);
    inOrder = inOrder && previous <= time;
    previous = time;
    first = std::min(first, time);
    last = std::max(last, time);
    ++count;
    if (listed == messages.size()) messages.resize(2 * listed);
    messages[listed] = {instantOf(time), at, static_cast<std::uint32_t>(length)};
    listed += channels[loadNumber<std::uint16_t>(record + kRecordHeadBytes)] ? 1 : 0;
  }
  return {offset == size, inOrder, instantOf(first), instantOf(last), listed, count};
}

/// The messages of some channels in the records of one section. Its memory is meant to be reused.
struct Listing {
  /// The channels that are wanted.
  std::shared_ptr<const ChannelSet> channels;
  /// Empty: not listed yet.
  std::optional<RecordsOverview> overview;
  /// The first ones, as many as `overview` says, are those listed; what follows is spare memory.
  std::vector<MessageRecord> messages;

  /// Lists the messages of `channels`.
  void list(Bytes records) { overview = overviewOf(records, *channels, messages); }
};

}  // namespace logplayer::mcap
