// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Codec.h"

namespace logplayer::mcap {

/// The contents of the summary section, which repeats and indexes what the file contains, so that it can be
/// opened without reading it completely.
struct Summary {
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  /// Whether `statistics` was in the file.
  bool hasStatistics = false;
  std::vector<ChunkIndex> chunks;
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
};

/// Encodes the end of a file whose summary begins at `start`: groups of records, their offsets, the footer
/// (with a CRC if `crc`) and the magic.
Buffer encodeEnd(const Summary& summary, std::uint64_t start, bool crc);

/// Decodes the records between the start of the summary and the footer; empty if they are damaged. Unknown
/// records are skipped.
std::optional<Summary> decodeSummary(Bytes records);

}  // namespace logplayer::mcap
