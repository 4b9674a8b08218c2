// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/PacketParser.h"

#include <algorithm>

namespace robotlink::arcos {
namespace {

constexpr std::size_t kMaxDamage = 256;

}  // namespace

const char* describe(DamagedBytes::Kind kind) {
  switch (kind) {
    case DamagedBytes::Kind::kCount:
      return "impossible length";
    case DamagedBytes::Kind::kChecksum:
      return "wrong checksum";
    case DamagedBytes::Kind::kPartial:
      return "end of packet missing";
    case DamagedBytes::Kind::kGarbage:
      break;
  }
  return "no packet";
}

void PacketParser::push(std::span<const std::uint8_t> bytes) {
  buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(begin_));
  giveUpBefore_ -= std::min(giveUpBefore_, begin_);
  begin_ = frameSize_ = 0;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  if (buffer_.size() > kMaxBuffered) {
    begin_ = buffer_.size() - kMaxBuffered;
    counters_.skippedBytes += begin_;
  }
}

void PacketParser::clear() {
  buffer_.clear();
  begin_ = giveUpBefore_ = frameSize_ = 0;
}

/// The position of the next header, perhaps without its second byte at the end of the range; `end` if there
/// is none.
std::size_t PacketParser::nextHeader(std::size_t from, std::size_t end) const {
  for (std::size_t i = from; i < end; ++i) {
    if (buffer_[i] == kHeader1 && (i + 1 == buffer_.size() || buffer_[i + 1] == kHeader2)) return i;
  }
  return end;
}

DamagedBytes PacketParser::takeDamage(DamagedBytes::Kind kind, std::size_t end) {
  end = std::min(end, begin_ + kMaxDamage);
  DamagedBytes damage{kind, Bytes(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
                                  buffer_.begin() + static_cast<std::ptrdiff_t>(end))};
  counters_.skippedBytes += damage.bytes.size();
  if (kind == DamagedBytes::Kind::kChecksum) ++counters_.checksumErrors;
  begin_ = end;
  return damage;
}

std::optional<PacketParser::Found> PacketParser::needMore() {
  if (begin_ >= giveUpBefore_) return std::nullopt;
  return takeDamage(DamagedBytes::Kind::kPartial, nextHeader(begin_ + 1, buffer_.size()));
}

std::optional<PacketParser::Found> PacketParser::next() {
  frameSize_ = 0;
  if (begin_ == buffer_.size()) return std::nullopt;
  const std::size_t header = nextHeader(begin_, buffer_.size());
  if (header != begin_) return takeDamage(DamagedBytes::Kind::kGarbage, header);

  const std::size_t available = buffer_.size() - begin_;
  if (available < 3) return needMore();
  const std::size_t count = buffer_[begin_ + 2];
  if (count < kMinCount || count > kMaxCount) {
    return takeDamage(DamagedBytes::Kind::kCount, nextHeader(begin_ + 2, begin_ + 3));
  }
  if (available < count + 3) return needMore();

  const std::span idAndData = std::span(buffer_).subspan(begin_ + 3, count - 2);
  const std::size_t end = begin_ + 3 + count;
  if (checksum(idAndData) != ((buffer_[end - 2] << 8U) | buffer_[end - 1])) {
    return takeDamage(DamagedBytes::Kind::kChecksum, nextHeader(begin_ + 2, end));
  }
  begin_ = end;
  frameSize_ = count + 3;
  ++counters_.packets;
  return Packet{idAndData[0], Bytes(idAndData.begin() + 1, idAndData.end())};
}

}  // namespace robotlink::arcos
