// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Records.h"

namespace logplayer::mcap {

// The records that hold a file together, as opposed to those of Records.h that carry what was recorded.

inline constexpr std::uint8_t kMagic[] = {0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
/// Opcode and length of the content, before every record.
inline constexpr std::size_t kRecordHeadBytes = 9;
/// A message's record without its data.
inline constexpr std::size_t kMessageHeadBytes = kRecordHeadBytes + 22;
inline constexpr std::size_t kFooterBytes = kRecordHeadBytes + 20;
inline constexpr std::size_t kDataEndBytes = kRecordHeadBytes + 4;

/// Offsets within a chunk are kept in 32 bits.
inline constexpr std::size_t kLargestRecord = 1U << 31U;

/// 0 is invalid, those from 0x80 on are private: readers skip them.
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

struct Footer {
  std::uint64_t summaryStart = 0;        ///< in the file; 0: no summary
  std::uint64_t summaryOffsetStart = 0;  ///< 0: no summary offsets
  std::uint32_t summaryCrc = 0;          ///< 0: not known
  bool operator==(const Footer&) const = default;
};

/// All of a chunk but its records, which follow.
struct ChunkHead {
  Instant start, end;  ///< 0 without messages
  std::uint64_t uncompressedBytes = 0;
  std::uint32_t uncompressedCrc = 0;  ///< 0: not known
  std::string compression;            ///< "", "lz4", "zstd"
  std::uint64_t recordsBytes = 0;     ///< compressed
  bool operator==(const ChunkHead&) const = default;
};

struct MessageIndexEntry {
  std::uint64_t time = 0;    ///< ns, as in the file
  std::uint64_t offset = 0;  ///< of the message's record in the uncompressed records
  bool operator==(const MessageIndexEntry&) const = default;
};
/// Where the messages of one channel are in the chunk before it.
struct MessageIndex {
  std::uint16_t channelId = 0;
  std::vector<MessageIndexEntry> entries;
  bool operator==(const MessageIndex&) const = default;
};

struct ChunkIndex {
  Instant start, end;
  std::uint64_t chunkOffset = 0;  ///< of the chunk's record in the file
  std::uint64_t chunkLength = 0;  ///< of the record with its head
  /// Channel and offset in the file of its message index, in the order of the file.
  std::vector<std::pair<std::uint16_t, std::uint64_t>> messageIndexOffsets;
  std::uint64_t messageIndexLength = 0;  ///< of all of them, which follow the chunk
  std::string compression;
  std::uint64_t compressedBytes = 0;
  std::uint64_t uncompressedBytes = 0;
  bool operator==(const ChunkIndex&) const = default;
};

struct AttachmentIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  Instant logTime;
  Instant createTime;
  std::uint64_t dataBytes = 0;
  std::string name;
  std::string mediaType;
  bool operator==(const AttachmentIndex&) const = default;
};

struct MetadataIndex {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::string name;
  bool operator==(const MetadataIndex&) const = default;
};

struct SummaryOffset {
  Opcode group = Opcode::kSchema;
  std::uint64_t start = 0;
  std::uint64_t length = 0;
  bool operator==(const SummaryOffset&) const = default;
};

struct DataEnd {
  std::uint32_t dataCrc = 0;  ///< of the file up to this record; 0: not known
  bool operator==(const DataEnd&) const = default;
};

/// The name of a compression as a file spells it, and back; nothing for one that is not known here.
std::string_view compressionName(Compression compression);
bool compressionOf(std::string_view name, Compression& compression);

}  // namespace logplayer::mcap
