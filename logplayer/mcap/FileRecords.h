// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

// The records that structure a file, in contrast to those in Records.h, which carry what was recorded. Names
// and fields follow the specification at https://mcap.dev/spec. Offsets count from the start of the file
// unless noted.

/// The first and the last bytes of every file.
inline constexpr std::uint8_t kMagic[] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
/// Size of opcode and content length, which precede the content of every record.
inline constexpr std::size_t kRecordHeadBytes = 9;
/// Size of a message record without its data.
inline constexpr std::size_t kMessageHeadBytes = kRecordHeadBytes + 22;
/// Sizes of the whole records.
inline constexpr std::size_t kFooterBytes = kRecordHeadBytes + 20;
inline constexpr std::size_t kDataEndBytes = kRecordHeadBytes + 4;

/// Maximum size of a record: offsets within a chunk are kept in 32 bits.
inline constexpr std::size_t kMaxReadableRecordBytes = 1U << 31U;

/// The type of a record. 0 is invalid; values from 0x80 on are private, readers skip them.
enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kAttachment = 0x09,
  kAttachmentIndex = 0x0A,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

/// The last record of a file; it locates the summary.
struct Footer {
  /// Offset of the summary; 0: there is none.
  std::uint64_t summaryStart = 0;
  /// Offset of the summary offsets; 0: there are none.
  std::uint64_t summaryOffsetStart = 0;
  /// CRC from the summary to this field; 0: unknown.
  std::uint32_t summaryCrc = 0;
  bool operator==(const Footer&) const = default;
};

/// All fields of a chunk except its records, which follow.
struct ChunkHead {
  /// Times of the earliest and the latest message; 0 without messages.
  Instant start, end;
  /// Size of the decompressed records.
  std::uint64_t uncompressedBytes = 0;
  /// Their CRC; 0: unknown.
  std::uint32_t uncompressedCrc = 0;
  /// "", "lz4", "zstd".
  std::string compression;
  /// Size of the records in the file.
  std::uint64_t recordsBytes = 0;
  bool operator==(const ChunkHead&) const = default;
};

/// Time and place of a message.
struct MessageIndexEntry {
  /// In ns, as in the file.
  std::uint64_t time = 0;
  /// Offset of the message's record within the decompressed records of the chunk.
  std::uint64_t offset = 0;
  bool operator==(const MessageIndexEntry&) const = default;
};
/// The messages of one channel in the preceding chunk.
struct MessageIndex {
  std::uint16_t channelId = 0;
  std::vector<MessageIndexEntry> entries;
  bool operator==(const MessageIndex&) const = default;
};

/// A summary record that locates a chunk and its message indexes.
struct ChunkIndex {
  Instant start, end;
  /// Offset of the chunk's record.
  std::uint64_t chunkOffset = 0;
  /// Size of the record including its head.
  std::uint64_t chunkLength = 0;
  /// Channel and offset of each message index, in the order of the file.
  std::vector<std::pair<std::uint16_t, std::uint64_t>> messageIndexOffsets;
  /// Total size of the message indexes, which follow the chunk.
  std::uint64_t messageIndexLength = 0;
  std::string compression;
  std::uint64_t compressedBytes = 0;
  std::uint64_t uncompressedBytes = 0;
  bool operator==(const ChunkIndex&) const = default;
};

/// A summary record that locates an attachment.
struct AttachmentIndex {
  /// Offset and size of the attachment's record.
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  Instant logTime;
  Instant createTime;
  std::uint64_t dataBytes = 0;
  std::string name;
  std::string mediaType;
  bool operator==(const AttachmentIndex&) const = default;
};

/// A summary record that locates a metadata record.
struct MetadataIndex {
  /// Offset and size of the metadata record.
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
  bool operator==(const MetadataIndex&) const = default;
};

/// Locates all summary records of one type.
struct SummaryOffset {
  /// The type of these records.
  Opcode group = Opcode::kSchema;
  std::uint64_t start = 0;
  std::uint64_t length = 0;
  bool operator==(const SummaryOffset&) const = default;
};

/// Ends the data section of a file.
struct DataEnd {
  /// CRC of the file up to this record; 0: unknown.
  std::uint32_t dataCrc = 0;
  bool operator==(const DataEnd&) const = default;
};

/// The name of a compression in files, and the inverse, which returns false for an unsupported one.
std::string_view compressionName(Compression compression);
bool compressionOf(std::string_view name, Compression& compression);

}  // namespace logplayer::mcap
