// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bitset>

#include "logplayer/mcap/Codec.h"
#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {

/// Some of all channels.
using ChannelSet = std::bitset<1U << 16U>;

/// The record of a message of which is known that it lies in a section's records.
struct MessageRecord {
  Instant time;
  std::uint32_t offset = 0;  ///< in the section's records
  std::uint32_t bytes = 0;   ///< of its content
};

/// The time of a message whose record's content begins at `content`.
inline Instant messageTime(const std::uint8_t* content) {
  return instantOf(loadNumber<std::uint64_t>(content + 6));
}

/// The message of a record that lies in `records`.
inline Message messageIn(const std::uint8_t* records, const MessageRecord& record) {
  constexpr std::size_t kHead = kMessageHeadBytes - kRecordHeadBytes;
  const std::uint8_t* content = records + record.offset + kRecordHeadBytes;
  return {loadNumber<std::uint16_t>(content), loadNumber<std::uint32_t>(content + 2), record.time,
          instantOf(loadNumber<std::uint64_t>(content + 14)), Bytes(content + kHead, record.bytes - kHead)};
}

/// Calls `visit` with the record of each message of some channels, up to where the bytes are no whole records
/// any more, or it returns false. Small messages make these loops the most expensive ones of all reading.
template <typename Visit>
void visitMessages(Bytes records, const ChannelSet& channels, Visit visit) {
  const std::uint8_t* const data = records.data();
  const std::size_t size = records.size();
  for (std::size_t offset = 0; size - offset >= kRecordHeadBytes;) {
    const std::uint8_t* record = data + offset;
    const auto length = loadNumber<std::uint64_t>(record + 1);
    if (record[0] == 0 || length > size - offset - kRecordHeadBytes) return;
    const std::uint8_t* content = record + kRecordHeadBytes;
    __builtin_prefetch(record + 8 * (kRecordHeadBytes + length));
    if (record[0] == static_cast<std::uint8_t>(Opcode::kMessage) &&
        length >= kMessageHeadBytes - kRecordHeadBytes && channels[loadNumber<std::uint16_t>(content)]) {
      if (!visit(MessageRecord{messageTime(content), static_cast<std::uint32_t>(offset),
                               static_cast<std::uint32_t>(length)})) {
        return;
      }
    }
    offset += kRecordHeadBytes + static_cast<std::size_t>(length);
  }
}

/// What the messages of all channels in a section's records have in common.
struct RecordsOverview {
  bool inOrder = true;  ///< of time
  Instant first, last;  ///< the earliest and the latest time
  std::size_t end = 0;  ///< behind the last message; 0: there is none
};

/// The loop is kept as short as it can be: chunks in order of time are otherwise only gone over once.
inline RecordsOverview overviewOf(Bytes records) {
  constexpr std::uint64_t kLatest = INT64_MAX;  // later ones are taken as this
  const std::uint8_t* const data = records.data();
  const std::size_t size = records.size();
  std::uint64_t first = UINT64_MAX, last = 0, previous = 0;
  bool inOrder = true;
  std::size_t end = 0;
  for (std::size_t offset = 0; size - offset >= kRecordHeadBytes;) {
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
  }
  return {inOrder, instantOf(first), instantOf(last), end};
}

/// Where a stretch of records that was gone over by visitMessages() has the next message of some channels,
/// from `offset` on; `end` if it has none.
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
