// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "logplayer/mcap/Source.h"
#include "logplayer/mcap/Summary.h"
#include "logplayer/mcap/read/ReadTypes.h"

namespace logplayer::mcap {

/// A part of a file that contains messages: a chunk, or consecutive records outside of chunks.
struct Section {
  /// Position, size and times.
  ChunkInfo info;
  /// The compression's name, if it is not supported; the section cannot be read then. Otherwise empty.
  std::string unknownCompression;
  /// Whether the records lie outside of chunks; `info` then describes their range in the file.
  bool loose = false;
  /// Whether the section has message indexes that may be trusted.
  bool indexed = false;
  /// Position and total size of its message indexes, which are contiguous.
  std::uint64_t indexOffset = 0;
  std::uint64_t indexLength = 0;
  /// The channels with messages in this section, sorted; set only if it is indexed.
  std::vector<std::uint16_t> channels;

  /// Whether the section may contain messages of a channel; true if unknown.
  bool mayHold(std::uint16_t channelId) const;
};

/// Everything that is known about a file before its messages are read.
struct FileIndex {
  Header header;
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  /// The statistics from the summary, or counted by the scan.
  Statistics statistics;
  /// In the order of the file.
  std::vector<Section> sections;
  std::vector<AttachmentIndex> attachments;
  std::vector<MetadataIndex> metadata;
  /// Whether the index comes from the summary and not from a scan.
  bool bySummary = false;
  /// Whether DataEnd, footer and magic exist and the summary is consistent.
  bool complete = false;
  /// Offset of the DataEnd record; 0 if there is none.
  std::uint64_t dataEnd = 0;
  /// CRC of all bytes before DataEnd; 0 if unknown.
  std::uint32_t dataCrc = 0;
  /// The damage found so far.
  std::vector<Damage> damage;
  /// Whether the scan was canceled by ReadOptions::progress; the index is incomplete then.
  bool givenUp = false;
};

/// The reason why a file must be scanned.
struct NoSummary {
  /// The damage of the summary; empty if it is valid but does not cover all messages.
  std::string damage;
};

/// Builds the index from the summary, provided that it covers all messages and is consistent with the file.
tl::expected<FileIndex, NoSummary> indexBySummary(const Source& source, std::size_t maxRecordBytes);

/// How many of the chunks in the summary are verified against the file before it is trusted.
enum class SummaryCheck : std::uint8_t { kSome, kAll };

/// Builds the index from the summary if that passes the check, otherwise by a scan. Fails if nothing in the
/// file is MCAP, or with "log.given-up" if canceled.
robotlink::Result<FileIndex> readIndex(const Source& source, const ReadOptions& options,
                                       SummaryCheck check = SummaryCheck::kSome);

/// Whether a chunk with this position, size and these times exists in the file.
bool chunkIsThere(const Source& source, const Section& section, std::size_t maxRecordBytes);

/// Scans the file and returns the result if it contains more readable chunks than the summary's index; empty
/// otherwise. A canceled scan is returned, too, with `givenUp` set.
std::optional<FileIndex> betterByScan(const Source& source, const FileIndex& bySummary,
                                      const ReadOptions& options);

/// Reads the summary records, in order to append to a file; empty if that is impossible.
std::optional<Summary> readSummary(const Source& source, std::size_t maxRecordBytes);

}  // namespace logplayer::mcap
