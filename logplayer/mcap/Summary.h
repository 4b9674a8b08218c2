// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Codec.h"

namespace logplayer::mcap {

/// What the end of a file repeats and tells of all before it, so that one need not read that to open it.
struct Summary {
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  bool hasStatistics = false;
  std::vector<ChunkIndex> chunks;
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
};

/// The bytes of a file from the summary on, for a summary that starts at `start`: groups, their offsets, the
/// footer (with a CRC if `crc`) and the magic.
Buffer encodeEnd(const Summary& summary, std::uint64_t start, bool crc);

/// From the records between summary start and footer. Nothing: they are damaged. Unknown ones are skipped.
std::optional<Summary> decodeSummary(Bytes records);

}  // namespace logplayer::mcap
