// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "logplayer/mcap/FileRecords.h"

namespace logplayer::mcap {

// Encoding and decoding of records: pure functions that do not access files. Any thread.
//
// encode() appends a record, including its head (opcode and length). `padding` is appended to the content:
// readers ignore unknown bytes there. Footer, Message and DataEnd cannot be extended.
//
// The decode functions take the content of a record without its head. They return an empty value if it is too
// short or contains inconsistent lengths. Bytes behind the known fields are ignored.

/// A growing output of encoded records.
using Buffer = std::vector<std::uint8_t>;

void encode(Buffer& out, const Header& header, Bytes padding = {});
void encode(Buffer& out, const Footer& footer);
void encode(Buffer& out, const Schema& schema, Bytes padding = {});
void encode(Buffer& out, const Channel& channel, Bytes padding = {});
void encode(Buffer& out, const Message& message);
/// Encodes a chunk up to its records; `head.recordsBytes` bytes of records must follow.
void encode(Buffer& out, const ChunkHead& head);
void encode(Buffer& out, const MessageIndex& index, Bytes padding = {});
void encode(Buffer& out, const ChunkIndex& index, Bytes padding = {});
/// Computes the CRC if `crc` is set, otherwise writes 0.
void encode(Buffer& out, const Attachment& attachment, bool crc = true, Bytes padding = {});
void encode(Buffer& out, const AttachmentIndex& index, Bytes padding = {});
void encode(Buffer& out, const Statistics& statistics, Bytes padding = {});
void encode(Buffer& out, const Metadata& metadata, Bytes padding = {});
void encode(Buffer& out, const MetadataIndex& index, Bytes padding = {});
void encode(Buffer& out, const SummaryOffset& offset, Bytes padding = {});
void encode(Buffer& out, const DataEnd& end);

/// A decoded attachment; `crcFits` is false if the CRC of its data is wrong.
struct CheckedAttachment {
  Attachment attachment;
  bool crcFits = true;
};

/// Any record that has no function of its own here. The content of a chunk may be truncated behind its head.
template <typename Record>
std::optional<Record> decode(Bytes content);
/// The message's data is a view into `content`.
std::optional<Message> decodeMessage(Bytes content);
std::optional<MessageIndex> decodeMessageIndex(Bytes content);
std::optional<CheckedAttachment> decodeAttachment(Bytes content);

/// Size of a chunk's content before its records.
constexpr std::size_t chunkHeadBytes(std::size_t compressionNameBytes) {
  return 8 + 8 + 8 + 4 + 4 + compressionNameBytes + 8;
}

/// A record within a buffer; the content is a view.
struct RecordView {
  /// May be unknown, see Opcode.
  std::uint8_t opcode = 0;
  Bytes content;
  /// Size of the whole record.
  std::size_t bytes() const { return kRecordHeadBytes + content.size(); }
  bool is(Opcode other) const { return opcode == static_cast<std::uint8_t>(other); }
};
/// The record at the beginning of `bytes`; empty if it is incomplete or its opcode is 0.
std::optional<RecordView> firstRecord(Bytes bytes);

/// Converts times of the file, in ns, to instants and back. Values out of range become the nearest
/// representable one.
inline Instant instantOf(std::uint64_t nanoseconds) {
  constexpr auto kLargest = static_cast<std::uint64_t>(INT64_MAX);
  return Instant(
      robotlink::Duration(static_cast<std::int64_t>(nanoseconds < kLargest ? nanoseconds : kLargest)));
}
inline std::uint64_t nanosecondsOf(Instant instant) {
  const auto count = instant.time_since_epoch().count();
  return count < 0 ? 0 : static_cast<std::uint64_t>(count);
}

}  // namespace logplayer::mcap
