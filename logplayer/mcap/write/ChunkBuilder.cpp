// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/write/ChunkBuilder.h"

#include <algorithm>

#include "logplayer/mcap/Crc.h"

namespace logplayer::mcap {
namespace {

// The CRC is computed while the records are still in the processor's cache, in pieces that are large enough
// to make the start-up cost negligible.
constexpr std::size_t kCrcPiece = 32U << 10U;

}  // namespace

void ChunkBuilder::add(const Message& message) {
  start_ = messages_ == 0 ? message.logTime : std::min(start_, message.logTime);
  end_ = messages_ == 0 ? message.logTime : std::max(end_, message.logTime);
  indexOf(message.channelId).entries.push_back({nanosecondsOf(message.logTime), records_.size()});
  encode(records_, message);
  ++messages_;
  if (computesCrc_ && records_.size() - crcBytes_ >= kCrcPiece) updateCrc();
}

MessageIndex& ChunkBuilder::indexOf(std::uint16_t channelId) {
  if (slots_.size() <= channelId) slots_.resize(std::size_t{channelId} + 1);
  std::uint32_t& slot = slots_[channelId];
  if (slot == 0) {
    if (used_ == indexes_.size()) indexes_.emplace_back();
    indexes_[used_++].channelId = channelId;
    slot = static_cast<std::uint32_t>(used_);
  }
  return indexes_[slot - 1];
}

void ChunkBuilder::clear() {
  for (MessageIndex& index : std::span(indexes_).first(used_)) {
    slots_[index.channelId] = 0;
    index.entries.clear();
  }
  used_ = 0;
  records_.clear();
  crc_ = 0;
  crcBytes_ = 0;
  messages_ = 0;
  start_ = end_ = {};
}

void ChunkBuilder::updateCrc() {
  crc_ = crc32(Bytes(records_).subspan(crcBytes_), crc_);
  crcBytes_ = records_.size();
}

std::uint32_t ChunkBuilder::crc() {
  if (computesCrc_) updateCrc();
  return crc_;
}

}  // namespace logplayer::mcap
