// SPDX-License-Identifier: GPL-3.0-or-later
// readIndex() of Resync.h: the index of a file, from its summary or by a scan.
#include <algorithm>
#include <set>

#include "logplayer/mcap/read/Resync.h"
#include "logplayer/mcap/read/Scan.h"

namespace logplayer::mcap {
namespace {

constexpr std::size_t kHeadBytes = 128;  // upper bound of the size of a chunk's head
constexpr std::size_t kSomeChunks = 32;
constexpr char kMisfit[] = "the summary does not fit the file; the file was scanned instead";

/// Whether the times of all messages of a chunk are within those of its section. A chunk that cannot be read
/// does not contradict them.
bool timesFit(const Source& source, const Section& section, std::size_t maxRecordBytes) {
  Buffer records;
  if (!ChunkLoader(source, maxRecordBytes).load(section, records)) return true;
  bool fit = true;
  visitRecords(records, [&](const RecordView& record, std::size_t) {
    if (!record.is(Opcode::kMessage)) return;
    const auto message = decodeMessage(record.content);
    fit =
        fit && (!message || (section.info.start <= message->logTime && message->logTime <= section.info.end));
  });
  return fit;
}

/// Verifies some of the chunks, including the last one.
bool chunksAreThere(const Source& source, const FileIndex& index, SummaryCheck check,
                    std::size_t maxRecordBytes) {
  const std::size_t count = index.sections.size();
  const std::size_t step = check == SummaryCheck::kAll ? 1 : std::max<std::size_t>(1, count / kSomeChunks);
  for (std::size_t i = 0; i < count; i += step) {
    if (!chunkIsThere(source, index.sections[count - 1 - i], maxRecordBytes)) return false;
  }
  return true;
}

/// Whether a scan finds more chunks than the summary does; a chunk with a damaged head does not count.
bool findsMore(const Source& source, const FileIndex& scanned, const FileIndex& bySummary,
               std::size_t maxRecordBytes) {
  std::set<std::uint64_t> there;
  for (const Section& section : bySummary.sections) {
    if (chunkIsThere(source, section, maxRecordBytes)) there.insert(section.info.offset);
  }
  ChunkLoader loader(source, maxRecordBytes);
  Buffer records;
  const auto found = std::ranges::count_if(scanned.sections, [&](const Section& section) {
    return !section.loose && (there.contains(section.info.offset) || loader.load(section, records));
  });
  return static_cast<std::size_t>(found) > there.size();
}

robotlink::Error givenUp(const Source& source) {
  return {"log.given-up", "canceled while it was scanned", {}, {source.file().string(), 0, 0}};
}

}  // namespace

bool chunkIsThere(const Source& source, const Section& section, std::size_t maxRecordBytes) {
  SourceWindow window(source, kHeadBytes);
  const std::optional<Section> found = chunkAt(window, source, section.info.offset);
  const ChunkInfo& stated = section.info;
  if (!found || found->info.length != stated.length ||
      found->info.compressedBytes != stated.compressedBytes ||
      found->info.uncompressedBytes != stated.uncompressedBytes ||
      found->info.compression != stated.compression) {
    return false;
  }
  const bool same = found->info.start == stated.start && found->info.end == stated.end;
  return same || timesFit(source, section, maxRecordBytes);
}

std::optional<FileIndex> betterByScan(const Source& source, const FileIndex& bySummary,
                                      const ReadOptions& options) {
  FileIndex scanned = indexByScan(source, options);
  if (scanned.givenUp) return scanned;
  if (!findsMore(source, scanned, bySummary, options.maxRecordBytes)) return std::nullopt;
  scanned.complete = false;
  scanned.damage.insert(scanned.damage.begin(), {0, 0, kMisfit});
  return scanned;
}

robotlink::Result<FileIndex> readIndex(const Source& source, const ReadOptions& options, SummaryCheck check) {
  auto index = indexBySummary(source, options.maxRecordBytes);
  if (index) {
    if (chunksAreThere(source, *index, check, options.maxRecordBytes)) return std::move(*index);
    std::optional<FileIndex> better = betterByScan(source, *index, options);
    if (better && better->givenUp) return tl::unexpected(givenUp(source));
    return better ? std::move(*better) : std::move(*index);
  }

  FileIndex scanned = indexByScan(source, options);
  if (scanned.givenUp) return tl::unexpected(givenUp(source));
  if (const std::string& damage = index.error().damage; !damage.empty()) {
    scanned.complete = false;
    scanned.damage.insert(scanned.damage.begin(), {0, 0, damage});
  }
  const bool nothing = scanned.sections.empty() && scanned.channels.empty() && scanned.attachments.empty();
  if (nothing && !std::ranges::equal(source.read(0, sizeof kMagic), kMagic)) {
    return robotlink::failure("mcap.none", "this is not an MCAP file, or nothing in it can be read",
                              {source.file().string(), 0, 0});
  }
  return scanned;
}

}  // namespace logplayer::mcap
