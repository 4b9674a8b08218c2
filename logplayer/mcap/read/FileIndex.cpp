// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/FileIndex.h"

#include <algorithm>

#include "logplayer/mcap/Crc.h"
#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {
namespace {

std::optional<Footer> readFooter(const Source& source) {
  const std::size_t bytes = kFooterBytes + sizeof kMagic;
  if (source.bytes() < sizeof kMagic + bytes) return std::nullopt;
  const Buffer end = source.read(source.bytes() - bytes, bytes);
  if (end.size() != bytes || !std::ranges::equal(Bytes(end).last(sizeof kMagic), kMagic)) return std::nullopt;
  const std::optional<RecordView> record = firstRecord(end);
  if (!record || !record->is(Opcode::kFooter) || record->bytes() != kFooterBytes) return std::nullopt;
  return decode<Footer>(record->content);
}

/// The records between the start of the summary and the footer, with their CRC checked.
std::optional<Buffer> readSummaryRecords(const Source& source, const Footer& footer,
                                         std::size_t maxRecordBytes) {
  const std::uint64_t end = source.bytes() - kFooterBytes - sizeof kMagic;
  if (footer.summaryStart < sizeof kMagic || footer.summaryStart > end) return std::nullopt;
  if (end - footer.summaryStart > maxRecordBytes) return std::nullopt;
  // The CRC covers everything up to the footer's CRC field.
  Buffer records = source.read(footer.summaryStart, end - footer.summaryStart + kFooterBytes - 4);
  if (records.size() != end - footer.summaryStart + kFooterBytes - 4) return std::nullopt;
  if (footer.summaryCrc != 0 && crc32(records) != footer.summaryCrc) return std::nullopt;
  records.resize(static_cast<std::size_t>(end - footer.summaryStart));
  return records;
}

std::optional<Header> readHeader(const Source& source, std::size_t maxRecordBytes) {
  const Buffer begin = source.read(0, sizeof kMagic + kRecordHeadBytes);
  if (begin.size() < sizeof kMagic + kRecordHeadBytes ||
      !std::equal(std::begin(kMagic), std::end(kMagic), begin.begin())) {
    return std::nullopt;
  }
  ByteReader head(Bytes(begin).subspan(sizeof kMagic));
  if (head.take<std::uint8_t>() != static_cast<std::uint8_t>(Opcode::kHeader)) return std::nullopt;
  const auto length = head.take<std::uint64_t>();
  if (length > maxRecordBytes || length > source.bytes()) return std::nullopt;
  return decode<Header>(source.read(sizeof kMagic + kRecordHeadBytes, length));
}

/// The size of a message index with `entries` messages.
constexpr std::uint64_t kIndexHeadBytes = kRecordHeadBytes + 2 + 4;

Section sectionOf(const ChunkIndex& index) {
  Section section;
  section.info.offset = index.chunkOffset;
  section.info.length = index.chunkLength;
  section.info.start = index.start;
  section.info.end = index.end;
  section.info.compressedBytes = index.compressedBytes;
  section.info.uncompressedBytes = index.uncompressedBytes;
  if (!compressionOf(index.compression, section.info.compression))
    section.unknownCompression = index.compression;
  section.indexed = !index.messageIndexOffsets.empty();
  section.indexOffset = index.chunkOffset + index.chunkLength;
  section.indexLength = index.messageIndexLength;
  for (const auto& [channel, offset] : index.messageIndexOffsets) section.channels.push_back(channel);
  std::ranges::sort(section.channels);
  const std::uint64_t heads = section.channels.size() * kIndexHeadBytes;
  if (section.indexLength >= heads) section.info.messages = (section.indexLength - heads) / 16;
  return section;
}

/// Whether the chunks are contiguous in the data section, each followed by its message indexes.
bool chunksFit(const std::vector<ChunkIndex>& chunks, std::uint64_t dataEnd) {
  std::uint64_t end = sizeof kMagic;
  for (const ChunkIndex& chunk : chunks) {
    if (chunk.chunkOffset < end || chunk.chunkOffset > dataEnd || chunk.chunkLength < kRecordHeadBytes ||
        chunk.chunkLength > dataEnd - chunk.chunkOffset ||
        chunk.messageIndexLength > dataEnd - chunk.chunkOffset - chunk.chunkLength ||
        chunk.end < chunk.start) {
      return false;
    }
    const std::uint64_t indexes = chunk.chunkOffset + chunk.chunkLength;
    end = indexes + chunk.messageIndexLength;
    for (const auto& [channel, offset] : chunk.messageIndexOffsets) {
      if (offset < indexes || offset >= end) return false;
    }
  }
  return true;
}

/// Whether the summary covers all messages, so that nothing else needs to be read.
bool coversMessages(const Summary& summary) {
  if (!summary.hasStatistics) return false;
  const Statistics& statistics = summary.statistics;
  if (summary.chunks.size() != statistics.chunkCount) return false;
  if (summary.attachments.size() != statistics.attachmentCount) return false;
  if (summary.metadata.size() != statistics.metadataCount) return false;
  if (summary.channels.size() != statistics.channelCount ||
      summary.schemas.size() != statistics.schemaCount) {
    return false;
  }
  if (statistics.chunkCount == 0) return statistics.messageCount == 0;
  std::uint64_t indexed = 0;
  bool all = true;
  for (const ChunkIndex& chunk : summary.chunks) {
    // The messages of a chunk without message indexes are found by reading it; it may also have none.
    all = all && !chunk.messageIndexOffsets.empty();
    for (const auto& [channel, offset] : chunk.messageIndexOffsets) {
      if (!summary.channels.contains(channel)) return false;
    }
    const std::uint64_t heads = chunk.messageIndexOffsets.size() * kIndexHeadBytes;
    if (chunk.messageIndexLength < heads) return false;
    indexed += (chunk.messageIndexLength - heads) / 16;
  }
  return !all || indexed >= statistics.messageCount;
}

}  // namespace

bool Section::mayHold(std::uint16_t channelId) const {
  return !indexed || std::ranges::binary_search(channels, channelId);
}

std::optional<Summary> readSummary(const Source& source, std::size_t maxRecordBytes) {
  const std::optional<Footer> footer = readFooter(source);
  if (!footer) return std::nullopt;
  const std::optional<Buffer> records = readSummaryRecords(source, *footer, maxRecordBytes);
  return records ? decodeSummary(*records) : std::nullopt;
}

tl::expected<FileIndex, NoSummary> indexBySummary(const Source& source, std::size_t maxRecordBytes) {
  const auto without = [](std::string damage) { return tl::unexpected(NoSummary{std::move(damage)}); };
  const std::optional<Footer> footer = readFooter(source);
  if (!footer) return without("the file does not end properly: its writer was not closed");
  if (footer->summaryStart == 0) return without({});
  std::optional<Header> header = readHeader(source, maxRecordBytes);
  std::optional<Summary> summary = readSummary(source, maxRecordBytes);
  if (!header) return without("the beginning of the file is damaged");
  if (!summary || footer->summaryStart < kDataEndBytes) return without("the summary is damaged");
  const std::uint64_t dataEnd = footer->summaryStart - kDataEndBytes;
  const Buffer endRecord = source.read(dataEnd, kDataEndBytes);
  const std::optional<RecordView> record = firstRecord(endRecord);
  if (!record || !record->is(Opcode::kDataEnd) || record->bytes() != kDataEndBytes) {
    return without("the end of the data section is damaged");
  }
  if (!coversMessages(*summary)) return without({});
  std::ranges::sort(summary->chunks, {}, &ChunkIndex::chunkOffset);
  if (!chunksFit(summary->chunks, dataEnd)) return without("the summary does not fit the file");

  FileIndex index;
  index.header = std::move(*header);
  index.schemas = std::move(summary->schemas);
  index.channels = std::move(summary->channels);
  index.statistics = std::move(summary->statistics);
  index.attachments = std::move(summary->attachments);
  index.metadata = std::move(summary->metadata);
  index.complete = index.bySummary = true;
  index.dataEnd = dataEnd;
  index.dataCrc = decode<DataEnd>(record->content)->dataCrc;
  index.sections.reserve(summary->chunks.size());
  for (const ChunkIndex& chunk : summary->chunks) index.sections.push_back(sectionOf(chunk));
  return index;
}

}  // namespace logplayer::mcap
