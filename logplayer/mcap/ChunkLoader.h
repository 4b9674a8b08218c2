// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/FileIndex.h"

namespace logplayer::mcap {

/// Reads the records of chunks: decompressed, and checked against what the chunk says of itself.
class ChunkLoader {
 public:
  ChunkLoader(const Source& source, std::size_t maxRecordBytes)
      : source_(source), maxRecordBytes_(maxRecordBytes) {}

  /// Into `records`, whose memory is reused. Fails with a sentence that says what is wrong; what `records`
  /// then holds means nothing.
  tl::expected<void, std::string> load(const Section& section, Buffer& records);

 private:
  tl::expected<void, std::string> loadChunk(const Section& section, const ChunkHead& head,
                                            std::size_t headBytes, Buffer& records);
  tl::expected<void, std::string> readPlain(std::uint64_t at, std::uint32_t expected,
                                            std::span<std::uint8_t> to);

  const Source& source_;
  std::size_t maxRecordBytes_;
  Decompressor decompressor_;
  Buffer compressed_;
};

/// Calls `visit` with each record and its offset. False: the bytes are not whole records to their end.
template <typename Visit>
bool visitRecords(Bytes records, Visit visit) {
  std::size_t offset = 0;
  while (offset < records.size()) {
    const std::optional<RecordView> record = firstRecord(records.subspan(offset));
    if (!record) return false;
    visit(*record, offset);
    offset += record->bytes();
  }
  return true;
}

}  // namespace logplayer::mcap
