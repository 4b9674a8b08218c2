// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/MessageList.h"

#include <algorithm>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/ChunkLoader.h"

namespace logplayer::mcap {
namespace {

auto inOrder(const MessageList::Entry& entry) {
  return std::pair(entry.time, entry.offset);
}

}  // namespace

std::span<const MessageList::Entry> MessageList::of(std::uint16_t channelId) const {
  const auto channel = std::ranges::lower_bound(channels_, channelId, {}, &Channel::id);
  if (channel == channels_.end() || channel->id != channelId) return {};
  return std::span(entries_).subspan(channel->first, channel->count);
}

bool MessageList::operator==(const MessageList& other) const {
  return std::ranges::equal(channels_, other.channels_, [&](const Channel& a, const Channel& b) {
    return a.id == b.id && std::ranges::equal(of(a.id), other.of(b.id));
  });
}

std::optional<MessageList> MessageList::fromIndexes(Bytes indexes, const Section& section) {
  MessageList list;
  list.entries_.reserve(indexes.size() / 16);
  bool good = true;
  const auto addIndex = [&](const RecordView& record, std::size_t) {
    if (!record.is(Opcode::kMessageIndex)) return;
    ByteReader fields(record.content);
    const auto channelId = fields.take<std::uint16_t>();
    const Bytes entries = fields.take(fields.take<std::uint32_t>());
    // If further entries would fit behind them, their length is wrong, and messages would be missing.
    good = good && fields.good() && entries.size() % 16 == 0 && fields.rest().size() < 16;
    if (!good) return;
    list.channels_.push_back({channelId, list.entries_.size(), entries.size() / 16});
    for (std::size_t i = 0; i < entries.size(); i += 16) {
      const Instant time = instantOf(loadNumber<std::uint64_t>(entries.data() + i));
      const auto offset = loadNumber<std::uint64_t>(entries.data() + i + 8);
      good = good && time >= section.info.start && time <= section.info.end &&
             offset < section.info.uncompressedBytes;
      list.entries_.push_back({time, static_cast<std::uint32_t>(offset)});
    }
  };
  if (!visitRecords(indexes, addIndex) || !good) return std::nullopt;
  list.sortChannels();
  if (!std::ranges::equal(list.channels_, section.channels, {}, &Channel::id)) return std::nullopt;
  return list.listsEachOnce() ? std::optional(std::move(list)) : std::nullopt;
}

MessageList MessageList::fromRecords(Bytes records) {
  struct Found {
    std::uint16_t channelId;
    Entry entry;
  };
  std::vector<Found> found;
  visitRecords(records, [&](const RecordView& record, std::size_t offset) {
    if (!record.is(Opcode::kMessage)) return;
    if (const auto message = decodeMessage(record.content)) {
      found.push_back({message->channelId, {message->logTime, static_cast<std::uint32_t>(offset)}});
    }
  });
  std::ranges::stable_sort(found, {}, &Found::channelId);
  MessageList list;
  list.entries_.reserve(found.size());
  for (const Found& message : found) {
    if (list.channels_.empty() || list.channels_.back().id != message.channelId) {
      list.channels_.push_back({message.channelId, list.entries_.size(), 0});
    }
    ++list.channels_.back().count;
    list.entries_.push_back(message.entry);
  }
  list.sortChannels();
  return list;
}

bool MessageList::listsEachOnce() const {
  const auto isTwice = [](const Channel& a, const Channel& b) { return a.id == b.id; };
  if (std::ranges::adjacent_find(channels_, isTwice) != channels_.end()) return false;
  return std::ranges::all_of(channels_, [&](const Channel& channel) {
    const auto entries = of(channel.id);
    return std::ranges::adjacent_find(entries) == entries.end();
  });
}

void MessageList::sortChannels() {
  std::ranges::sort(channels_, {}, &Channel::id);
  for (const Channel& channel : channels_) {
    const auto entries = std::span(entries_).subspan(channel.first, channel.count);
    if (!std::ranges::is_sorted(entries, {}, inOrder)) std::ranges::sort(entries, {}, inOrder);
  }
}

}  // namespace logplayer::mcap
