// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "logplayer/mcap/FileRecords.h"

namespace logplayer::mcap {

// Records from and to bytes: pure functions that know no files.
//
// encode() appends a record with its head. `padding` goes behind the content: readers ignore what they do not
// know there, except behind a Footer, a Message and a DataEnd, which cannot be extended.
//
// decode() takes the content of a record without its head. Nothing: it is too short, or its lengths lie. What
// follows the known fields is ignored.

using Buffer = std::vector<std::uint8_t>;

void encode(Buffer& out, const Header& header, Bytes padding = {});
void encode(Buffer& out, const Footer& footer);
void encode(Buffer& out, const Schema& schema, Bytes padding = {});
void encode(Buffer& out, const Channel& channel, Bytes padding = {});
void encode(Buffer& out, const Message& message);
/// The record up to its records, `head.recordsBytes` of which must follow.
void encode(Buffer& out, const ChunkHead& head);
void encode(Buffer& out, const MessageIndex& index, Bytes padding = {});
void encode(Buffer& out, const ChunkIndex& index, Bytes padding = {});
/// Its CRC is computed if `crc`, else 0.
void encode(Buffer& out, const Attachment& attachment, bool crc = true, Bytes padding = {});
void encode(Buffer& out, const AttachmentIndex& index, Bytes padding = {});
void encode(Buffer& out, const Statistics& statistics, Bytes padding = {});
void encode(Buffer& out, const Metadata& metadata, Bytes padding = {});
void encode(Buffer& out, const MetadataIndex& index, Bytes padding = {});
void encode(Buffer& out, const SummaryOffset& offset, Bytes padding = {});
void encode(Buffer& out, const DataEnd& end);

/// A decoded attachment; its data's CRC is wrong if `crcFits` is false.
struct CheckedAttachment {
  Attachment attachment;
  bool crcFits = true;
};

std::optional<Header> decodeHeader(Bytes content);
std::optional<Footer> decodeFooter(Bytes content);
std::optional<Schema> decodeSchema(Bytes content);
std::optional<Channel> decodeChannel(Bytes content);
/// Its data lies in `content`.
std::optional<Message> decodeMessage(Bytes content);
/// `content` may end behind the head's fields.
std::optional<ChunkHead> decodeChunkHead(Bytes content);
std::optional<MessageIndex> decodeMessageIndex(Bytes content);
std::optional<ChunkIndex> decodeChunkIndex(Bytes content);
std::optional<CheckedAttachment> decodeAttachment(Bytes content);
std::optional<AttachmentIndex> decodeAttachmentIndex(Bytes content);
std::optional<Statistics> decodeStatistics(Bytes content);
std::optional<Metadata> decodeMetadata(Bytes content);
std::optional<MetadataIndex> decodeMetadataIndex(Bytes content);
std::optional<SummaryOffset> decodeSummaryOffset(Bytes content);
std::optional<DataEnd> decodeDataEnd(Bytes content);

/// The bytes of a chunk's content before its records.
constexpr std::size_t chunkHeadBytes(std::size_t compressionNameBytes) {
  return 8 + 8 + 8 + 4 + 4 + compressionNameBytes + 8;
}

/// A record in bytes.
struct RecordView {
  std::uint8_t opcode = 0;
  Bytes content;
  std::size_t bytes() const { return kRecordHeadBytes + content.size(); }
  bool is(Opcode other) const { return opcode == static_cast<std::uint8_t>(other); }
};
/// The record at the beginning of `bytes`; nothing if it does not fit in or its opcode is 0.
std::optional<RecordView> firstRecord(Bytes bytes);

/// A time of a file as an instant, and back; what does not fit becomes the nearest that does.
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
