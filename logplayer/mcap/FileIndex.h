// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Reader.h"
#include "logplayer/mcap/Source.h"
#include "logplayer/mcap/Summary.h"

namespace logplayer::mcap {

/// A part of a file that holds messages: a chunk, or records that lie outside of chunks one after the other.
struct Section {
  Reader::ChunkInfo info;
  /// As the chunk spells it, where that is none of ours; then it cannot be read.
  std::string unknownCompression;
  bool loose = false;  ///< outside of chunks; `info` describes the stretch
  bool indexed = false;
  std::uint64_t indexOffset = 0;  ///< of its message indexes, which follow one another
  std::uint64_t indexLength = 0;
  /// Sorted; of its messages, if it is indexed.
  std::vector<std::uint16_t> channels;

  bool mayHold(std::uint16_t channelId) const;
};

/// What one knows of a file before its messages are read.
struct FileIndex {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  Statistics statistics;
  std::vector<Section> sections;  ///< in the order of the file
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  bool bySummary = false;     ///< it was believed, not found out by a scan
  bool complete = false;      ///< DataEnd, footer and magic are there, and nothing is wrong with the summary
  std::uint64_t dataEnd = 0;  ///< offset of the DataEnd record; 0: there is none
  std::uint32_t dataCrc = 0;  ///< of all before it; 0: not known
  std::vector<Damage> damage;
  bool givenUp = false;  ///< by Reader::Options::progress; there is more in the file than is told here
};

/// Why a file must be scanned.
struct NoSummary {
  std::string damage;  ///< what is wrong; empty: nothing is, it just does not tell of all messages
};

/// From a file's summary, if it tells of all messages and fits the file.
tl::expected<FileIndex, NoSummary> indexBySummary(const Source& source, std::size_t maxRecordBytes);

/// How many of the chunks that a summary lists are looked for before it is believed.
enum class SummaryCheck : std::uint8_t { kSome, kAll };

/// By the summary if chunks are where it says, or else by a scan. Fails if nothing in the file is MCAP, or it
/// is given up.
robotlink::Result<FileIndex> readIndex(const Source& source, const Reader::Options& options,
                                       SummaryCheck check = SummaryCheck::kSome);

/// Whether there is such a chunk at its place, with messages of such times.
bool chunkIsThere(const Source& source, const Section& section, std::size_t maxRecordBytes);

/// What a scan finds, if it finds more chunks than are where an index by the summary says. Also returned if
/// it is given up, which `givenUp` tells.
std::optional<FileIndex> betterByScan(const Source& source, const FileIndex& bySummary,
                                      const Reader::Options& options);

/// The summary as it stands in a file; for going on with it.
std::optional<Summary> readSummary(const Source& source, std::size_t maxRecordBytes);

}  // namespace logplayer::mcap
