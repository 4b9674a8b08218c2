// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/MessageQueueReader.h"

#include <algorithm>

#include "logplayer/bhuman/MessageKinds.h"
#include "robotlink/base/bytes/ByteReader.h"

namespace logplayer::bhuman {
namespace {

using robotlink::ByteReader;

constexpr std::uint64_t kFileHeader = 8;
constexpr std::uint64_t kMessageHeader = 4;
constexpr std::size_t kKeptDamage = 20;
/// Number of messages that must follow one that nothing else confirms.
constexpr int kDepth = 3;

bool isProcess(std::uint8_t name) {
  return name == 'c' || name == 'm' || name == 'd';
}

std::uint32_t sizeIn(const std::array<std::uint8_t, kMessageHeader>& header) {
  return robotlink::loadNumber<std::uint32_t>(header.data()) >> 8U;  // the first byte is the id
}

}  // namespace

MessageQueueReader::MessageQueueReader(ByteSource& bytes) : bytes_(bytes) {
  std::array<std::uint8_t, kFileHeader> header{};
  const std::size_t count = bytes_.read(0, header);
  ByteReader reader{std::span<const std::uint8_t>(header).first(count)};
  statedBytes_ = reader.take<std::int32_t>();
  statedMessages_ = reader.take<std::int32_t>();
  // Files of other years have the same structure but other payloads; the first message of a kind with a known
  // size decides.
  std::uint64_t offset = kFileHeader;
  for (int i = 0; i < 64; ++i) {
    const auto message = headerAt(offset);
    if (!message) break;
    if (const auto size = fixedSize(message->id); size && size != 1) {
      otherSizes_ = *size != message->size && followedByMessages(*message, kDepth);
      break;
    }
    offset = message->end();
  }
}

bool MessageQueueReader::recognizes(ByteSource& bytes) {
  if (bytes.size() < kFileHeader + kMessageHeader) return false;
  MessageQueueReader reader(bytes);
  const bool appendable = reader.statedBytes_ == -1 && reader.statedMessages_ == -1;
  const bool exact = reader.statedBytes_ == static_cast<std::int64_t>(bytes.size() - kFileHeader);
  // If the header fits the file, the first messages may be damaged, and vice versa.
  if (appendable || exact) return reader.search(kFileHeader) < bytes.size();
  const auto first = reader.headerAt(kFileHeader);
  return first && reader.certain(*first) && reader.followedByMessages(*first, kDepth);
}

std::optional<MessageQueueReader::Header> MessageQueueReader::headerAt(std::uint64_t offset) {
  std::array<std::uint8_t, kMessageHeader> bytes{};
  if (bytes_.read(offset, bytes) < bytes.size()) return std::nullopt;
  const Header header{bytes[0], sizeIn(bytes), offset + kMessageHeader};
  if (header.id == 0 || header.end() > bytes_.size()) return std::nullopt;
  return header;
}

bool MessageQueueReader::certain(const Header& header) {
  std::array<std::uint8_t, 16> begin{};
  const std::size_t count =
      bytes_.read(header.payload, std::span(begin).first(std::min<std::size_t>(16, header.size)));
  switch (static_cast<Kind>(header.id)) {
    case Kind::kProcessBegin:
    case Kind::kProcessFinished:
      return header.size == 1 && isProcess(begin[0]);
    case Kind::kImage: {
      ByteReader reader(std::span<const std::uint8_t>(begin).first(count));
      const std::int64_t width = reader.take<std::int32_t>(), height = reader.take<std::int32_t>();
      constexpr std::int64_t kMaxSide = 1 << 14;
      const bool possible = width > 0 && height > 0 && width <= kMaxSide && height <= kMaxSide;
      return possible && width * height * 4 + 12 == header.size;
    }
    case Kind::kJpegImage: {
      ByteReader reader(std::span<const std::uint8_t>(begin).first(count));
      reader.take(12);
      return count == begin.size() && std::int64_t{reader.take<std::int32_t>()} + 16 == header.size;
    }
    default:
      return !otherSizes_ && fixedSize(header.id) == header.size;
  }
}

bool MessageQueueReader::plausible(const Header& header, int depth) {
  if (certain(header)) return true;
  const bool impossible = (fixedSize(header.id) && !otherSizes_) || fixedSize(header.id) == 1U ||
                          header.id == idOf(Kind::kImage) || header.id == idOf(Kind::kJpegImage);
  return !impossible && followedByMessages(header, depth);
}

bool MessageQueueReader::followedByMessages(const Header& header, int depth) {
  if (header.end() == bytes_.size() || depth == 0) return true;
  const auto follower = headerAt(header.end());
  return follower && hasName(follower->id) && plausible(*follower, depth - 1);
}

std::optional<QueueMessage> MessageQueueReader::next() {
  while (position_ + kMessageHeader <= bytes_.size()) {
    const auto header = headerAt(position_);
    if (header && plausible(*header, kDepth)) {
      payload_.resize(header->size);
      if (bytes_.read(header->payload, payload_) < payload_.size()) break;
      const QueueMessage message{header->id, position_, payload_};
      position_ = header->end();
      ++messages_;
      return message;
    }
    const std::uint64_t found = endOfDamage();
    const std::string bytes = std::to_string(found - position_) + " bytes";
    addDamage(position_, found == bytes_.size()
                             ? "the last " + bytes + " are not a whole message and were left out"
                             : bytes + " that are not messages were left out");
    position_ = found;
  }
  finish();
  return std::nullopt;
}

std::uint64_t MessageQueueReader::endOfDamage() {
  // Often only the size, or only the kind, is wrong.
  std::array<std::uint8_t, kMessageHeader> bytes{};
  bytes_.read(position_, bytes);
  const auto usual = otherSizes_ ? std::nullopt : fixedSize(bytes[0]);
  for (const std::uint32_t size : {usual.value_or(sizeIn(bytes)), sizeIn(bytes)}) {
    const std::uint64_t end = position_ + kMessageHeader + size;
    const auto follower = headerAt(end);
    if (follower && hasName(follower->id) && plausible(*follower, kDepth)) return end;
  }
  return search(position_ + 1);
}

std::uint64_t MessageQueueReader::search(std::uint64_t offset) {
  constexpr std::size_t kBlock = 64U << 10U, kSignature = kMessageHeader + 1;
  std::vector<std::uint8_t> block(kBlock);
  while (offset + kSignature <= bytes_.size()) {
    const std::size_t count = bytes_.read(offset, block);
    if (count < kSignature) break;
    if (const auto found = searchBlock(offset, std::span(block).first(count))) return *found;
    offset += count - (kSignature - 1);
  }
  return bytes_.size();
}

std::optional<std::uint64_t> MessageQueueReader::searchBlock(std::uint64_t offset,
                                                             std::span<const std::uint8_t> block) {
  for (std::size_t i = 0; i + kMessageHeader < block.size(); ++i) {
    const auto size = fixedSize(block[i]);
    if (!size || block[i + 1] != *size || block[i + 2] != 0 || block[i + 3] != 0) continue;
    const auto header = headerAt(offset + i);
    if (header && certain(*header) && followedByMessages(*header, 1)) return offset + i;
  }
  return std::nullopt;
}

void MessageQueueReader::addDamage(std::uint64_t offset, std::string text) {
  ++damageCount_;
  if (damage_.size() < kKeptDamage) damage_.push_back({offset, std::move(text)});
}

void MessageQueueReader::finish() {
  if (finished_) return;
  finished_ = true;
  if (position_ < bytes_.size())
    addDamage(position_, "the last " + std::to_string(bytes_.size() - position_) +
                             " bytes are not a whole message and were left out");
  position_ = bytes_.size();
  if (statedBytes_ == -1 && statedMessages_ == -1) return;  // the log was written directly to the disk
  if (bytes_.size() >= kFileHeader && statedBytes_ != static_cast<std::int64_t>(bytes_.size() - kFileHeader))
    addDamage(0, "the header states " + std::to_string(statedBytes_) + " bytes of messages, the file has " +
                     std::to_string(bytes_.size() - kFileHeader));
  if (statedMessages_ != static_cast<std::int64_t>(messages_))
    addDamage(4, "the header states " + std::to_string(statedMessages_) + " messages, " +
                     std::to_string(messages_) + " were read");
}

}  // namespace logplayer::bhuman
