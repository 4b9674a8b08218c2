// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Compression.h"
#include "logplayer/mcap/read/FileIndex.h"

namespace logplayer::mcap {

/// Reads chunks: decompresses their records and checks lengths and CRC. One thread; `source` must outlive
/// this object.
class ChunkLoader {
 public:
  /// Chunks of more than `maxRecordBytes` uncompressed are refused.
  ChunkLoader(const Source& source, std::size_t maxRecordBytes)
      : source_(source), maxRecordBytes_(maxRecordBytes) {}

  /// Loads the records of a section into `records`, whose memory is reused. The error is a sentence for the
  /// user; the contents of `records` are then undefined.
  tl::expected<void, std::string> load(const Section& section, Buffer& records);

 private:
  /// Loads a chunk whose head has been read.
  tl::expected<void, std::string> loadChunk(const Section& section, const ChunkHead& head,
                                            std::size_t headBytes, Buffer& records);

  const Source& source_;
  std::size_t maxRecordBytes_;
  Decompressor decompressor_;
  /// The compressed bytes of the current chunk, kept for its memory.
  Buffer compressed_;
};

/// Calls `visit(record, offset)` for each record. Returns false if the bytes do not end with a complete
/// record.
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
