// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Resync.h"

#include <algorithm>
#include <cstring>

#include "logplayer/mcap/RecordBytes.h"

namespace logplayer::mcap {
namespace {

constexpr std::size_t kSearchedHeadBytes = 128;
constexpr std::uint64_t kBlock = 256U << 10U;
constexpr int kMessagesInARow = 3;
constexpr std::uint64_t kPatience = 64U << 20U;

bool is(std::uint8_t byte, Opcode opcode) {
  return byte == static_cast<std::uint8_t>(opcode);
}

bool isZero(Bytes bytes) {
  return bytes[0] == 0 && std::memcmp(bytes.data(), bytes.data() + 1, bytes.size() - 1) == 0;
}

}  // namespace

std::optional<Section> chunkAt(SourceWindow& window, const Source& source, std::uint64_t offset) {
  const Bytes bytes = window.look(offset, kSearchedHeadBytes);
  if (bytes.size() < kRecordHeadBytes || !is(bytes[0], Opcode::kChunk)) return std::nullopt;
  const auto content = loadNumber<std::uint64_t>(bytes.data() + 1);
  if (content > source.bytes() - offset - kRecordHeadBytes) return std::nullopt;
  const auto head = decode<ChunkHead>(bytes.subspan(kRecordHeadBytes));
  if (!head || head->start > head->end) return std::nullopt;
  if (head->recordsBytes > content || content - head->recordsBytes < chunkHeadBytes(head->compression.size()))
    return std::nullopt;
  Section section;
  section.info.offset = offset;
  section.info.length = kRecordHeadBytes + content;
  section.info.start = head->start;
  section.info.end = head->end;
  section.info.compressedBytes = head->recordsBytes;
  section.info.uncompressedBytes = head->uncompressedBytes;
  if (!compressionOf(head->compression, section.info.compression))
    section.unknownCompression = head->compression;
  return section;
}

bool recordMayBeAt(SourceWindow& window, const Source& source, std::uint64_t offset) {
  if (offset == source.bytes()) return true;
  if (offset > source.bytes()) return false;
  const Bytes bytes = window.look(offset, kRecordHeadBytes);
  if (std::ranges::equal(bytes.first(std::min(bytes.size(), sizeof kMagic)), kMagic)) return true;
  if (bytes.size() < kRecordHeadBytes) return false;
  const bool known = bytes[0] >= static_cast<std::uint8_t>(Opcode::kHeader) &&
                     bytes[0] <= static_cast<std::uint8_t>(Opcode::kDataEnd);
  const auto content = loadNumber<std::uint64_t>(bytes.data() + 1);
  return (known || bytes[0] >= 0x80) && content <= source.bytes() - offset - kRecordHeadBytes;
}

Resync::Resync(const Source& source, std::size_t maxRecordBytes)
    : source_(source),
      loader_(source, maxRecordBytes),
      window_(source),
      patience_(kPatience + 4 * source.bytes()) {}

std::optional<std::uint64_t> Resync::find(std::uint64_t offset, bool loose,
                                          const std::map<std::uint16_t, Channel>& channels,
                                          const std::function<bool(std::uint64_t)>& proceed) {
  dataEnd_ = 0;
  for (; offset < source_.bytes(); offset += kBlock) {
    if (!proceed(offset)) return std::nullopt;
    const Buffer block = source_.read(offset, kBlock);
    if (block.empty()) return std::nullopt;
    if (isZero(block)) continue;
    const auto last =
        std::ranges::find_if(block.rbegin(), block.rend(), [](std::uint8_t byte) { return byte != 0; });
    dataEnd_ = offset + static_cast<std::uint64_t>(block.rend() - last);
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (is(block[i], Opcode::kChunk) && chunkBeginsAt(offset + i)) return offset + i;
      if (loose && is(block[i], Opcode::kMessage) && messagesBeginAt(offset + i, channels)) return offset + i;
    }
  }
  return std::nullopt;
}

bool Resync::chunkBeginsAt(std::uint64_t offset) {
  const std::optional<Section> section = chunkAt(window_, source_, offset);
  if (!section || !section->unknownCompression.empty()) return false;
  const std::uint64_t cost = section->info.compressedBytes + section->info.uncompressedBytes;
  if (section->info.uncompressedBytes > patience_ || cost > patience_) return false;
  const bool good =
      loader_.load(*section, records_) && visitRecords(records_, [](const RecordView&, std::size_t) {});
  if (!good) patience_ -= cost;
  return good;
}

bool Resync::messagesBeginAt(std::uint64_t offset, const std::map<std::uint16_t, Channel>& channels) {
  for (int i = 0; i < kMessagesInARow; ++i) {
    if (offset == source_.bytes()) return i > 0;
    if (!recordMayBeAt(window_, source_, offset)) return false;
    const Bytes bytes = window_.look(offset, kMessageHeadBytes);
    if (bytes.size() < kRecordHeadBytes) return false;
    if (is(bytes[0], Opcode::kMessage)) {
      if (bytes.size() < kMessageHeadBytes ||
          !channels.contains(loadNumber<std::uint16_t>(bytes.data() + 9))) {
        return false;
      }
    } else if (i == 0 || is(bytes[0], Opcode::kDataEnd)) {
      return i > 0;
    }
    offset += kRecordHeadBytes + loadNumber<std::uint64_t>(bytes.data() + 1);
  }
  return true;
}

}  // namespace logplayer::mcap
