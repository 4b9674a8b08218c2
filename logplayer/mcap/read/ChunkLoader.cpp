// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/ChunkLoader.h"

#include <algorithm>

#include "logplayer/mcap/Crc.h"

namespace logplayer::mcap {
namespace {

// More than a chunk's head takes with any compression known here.
constexpr std::size_t kChunkHeadBytes = 128;

tl::unexpected<std::string> problem(std::string text) {
  return tl::unexpected<std::string>(std::move(text));
}

/// An expected CRC of 0 says that there is none.
tl::expected<void, std::string> checked(Bytes records, std::uint32_t expected) {
  if (expected != 0 && crc32(records) != expected) return problem("the CRC of a chunk is wrong");
  return {};
}

}  // namespace

tl::expected<void, std::string> ChunkLoader::load(const Section& section, Buffer& records) {
  const ChunkInfo& info = section.info;
  if (info.length > source_.bytes() || info.offset > source_.bytes() - info.length) {
    return problem("the file ends within a chunk");
  }
  if (section.loose) {
    records.resize(static_cast<std::size_t>(info.length));
    if (!source_.read(info.offset, records)) return problem("the system cannot read it");
    return {};
  }
  if (!section.unknownCompression.empty()) {
    return problem("a chunk is compressed by " + section.unknownCompression +
                   ", which is not supported here");
  }
  std::uint8_t bytes[kChunkHeadBytes];
  const std::span<std::uint8_t> begin =
      std::span(bytes).first(std::min<std::size_t>(kChunkHeadBytes, info.length));
  if (!source_.read(info.offset, begin)) return problem("the system cannot read it");
  const bool isChunk =
      begin.size() > kRecordHeadBytes && begin[0] == static_cast<std::uint8_t>(Opcode::kChunk);
  const auto head = isChunk ? decode<ChunkHead>(begin.subspan(kRecordHeadBytes)) : std::nullopt;
  if (!head) return problem("there is no chunk where the file says so");
  return loadChunk(section, *head, kRecordHeadBytes + chunkHeadBytes(head->compression.size()), records);
}

tl::expected<void, std::string> ChunkLoader::loadChunk(const Section& section, const ChunkHead& head,
                                                       std::size_t headBytes, Buffer& records) {
  const ChunkInfo& info = section.info;
  Compression compression{};
  if (!compressionOf(head.compression, compression) || compression != info.compression ||
      head.uncompressedBytes != info.uncompressedBytes || head.recordsBytes != info.compressedBytes ||
      headBytes > info.length || head.recordsBytes > info.length - headBytes) {
    return problem("a chunk's head is damaged");
  }
  if (head.uncompressedBytes > maxRecordBytes_ || head.recordsBytes > maxRecordBytes_) {
    return problem("a chunk claims " + std::to_string(head.uncompressedBytes) +
                   " bytes, more than the limit of " + std::to_string(maxRecordBytes_));
  }
  const std::uint64_t at = info.offset + headBytes;
  if (compression == Compression::kNone) {
    if (head.recordsBytes != head.uncompressedBytes) return problem("a chunk's sizes contradict each other");
    records.resize(static_cast<std::size_t>(head.recordsBytes));
    if (!source_.read(at, records)) return problem("the system cannot read it");
    return checked(records, head.uncompressedCrc);
  }
  compressed_.resize(static_cast<std::size_t>(head.recordsBytes));
  if (!source_.read(at, compressed_)) return problem("the system cannot read it");
  if (!Decompressor::canYield(compression, compressed_, head.uncompressedBytes)) {
    return problem("a chunk claims " + std::to_string(head.uncompressedBytes) + " bytes of only " +
                   std::to_string(head.recordsBytes) + " compressed ones");
  }
  records.resize(static_cast<std::size_t>(head.uncompressedBytes));
  if (!decompressor_.decompress(compression, compressed_, records)) {
    return problem("a chunk cannot be decompressed");
  }
  return checked(records, head.uncompressedCrc);
}

}  // namespace logplayer::mcap
