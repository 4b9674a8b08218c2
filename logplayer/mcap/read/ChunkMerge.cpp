// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/ChunkMerge.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace logplayer::mcap {
namespace {

/// Returns the first message for which `is` is false, where it is true for all before. Searches in growing
/// steps, since runs of overlapping sections are short.
template <typename Is>
std::span<const MessageRecord>::iterator firstNot(std::span<const MessageRecord> messages, Is is) {
  std::size_t known = 0, step = 1;
  while (known + step <= messages.size() && is(messages[known + step - 1])) {
    known += step;
    step *= 2;
  }
  const auto rest = messages.subspan(known, std::min(step, messages.size() - known));
  return messages.begin() + static_cast<std::ptrdiff_t>(known) +
         (std::ranges::partition_point(rest, is) - rest.begin());
}

}  // namespace

ChunkMerge::ChunkMerge(const FileIndex& index, SectionCache& cache, std::vector<std::uint16_t> channels,
                       std::size_t maxBytes)
    : index_(index), cache_(cache), channels_(std::move(channels)), maxBytes_(maxBytes) {
  const auto wanted = std::make_shared<ChannelSet>();
  for (const std::uint16_t channel : channels_) wanted->set(channel);
  wanted_ = wanted;
}

void ChunkMerge::sortSections() {
  surprises_ = cache_.surprises();
  sorted_ = true;
  standing_ = false;
  order_.clear();
  for (std::uint32_t i = 0; i < index_.sections.size(); ++i) {
    const auto mayHold = [&](std::uint16_t channel) { return index_.sections[i].mayHold(channel); };
    if (std::ranges::any_of(channels_, mayHold)) order_.push_back(i);
  }
  std::ranges::stable_sort(order_, {}, [&](std::uint32_t i) { return index_.sections[i].info.start; });
  lastEnd_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    lastEnd_.push_back(i == 0 ? section(i).info.end : std::max(lastEnd_.back(), section(i).info.end));
  }
  fits_ = overlapsFit();
}

bool ChunkMerge::overlapsFit() const {
  // With the size of the section.
  using End = std::pair<Instant, std::uint64_t>;
  std::priority_queue<End, std::vector<End>, std::greater<>> begun;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const ChunkInfo& info = section(i).info;
    for (; !begun.empty() && begun.top().first < info.start; begun.pop()) bytes -= begun.top().second;
    begun.emplace(info.end, info.uncompressedBytes);
    bytes += info.uncompressedBytes;
    if (begun.size() > 1 && bytes > maxBytes_) return false;
  }
  return true;
}

ChunkMerge::Run ChunkMerge::next(const MessagePosition& behind) {
  if (standing_) finishRun();
  do {
    if (!sorted_ || surprises_ != cache_.surprises()) sortSections();
    if (!fits_) return {};
    if (!standing_) lookUp(behind);
    enterDue(behind);
  } while (surprises_ != cache_.surprises());
  if (open_.empty()) return {};
  const Open& top = *open_.front();
  until_ = endOfRun();
  const std::span<const MessageRecord> rest =
      std::span(top.listing.messages).first(top.end).subspan(top.place);
  const auto isBefore = [&](const MessageRecord& message) { return nanosecondsOf(message.time) < until_; };
  // Usually all.
  const auto count = nanosecondsOf(top.last) < until_
                         ? rest.size()
                         : static_cast<std::size_t>(firstNot(rest, isBefore) - rest.begin());
  return {top.offset, &top.records, rest.first(count),
          top.records ? nullptr : top.channels.data() + top.place};
}

void ChunkMerge::lookUp(const MessagePosition& behind) {
  open_.clear();
  standing_ = true;
  walked_ = false;
  const auto firstLater = std::ranges::partition_point(
      order_, [&](std::uint32_t i) { return index_.sections[i].info.start <= behind.time; });
  due_ = static_cast<std::size_t>(firstLater - order_.begin());
  for (std::size_t i = due_; i > 0 && lastEnd_[i - 1] >= behind.time; --i) {
    if (section(i - 1).info.end >= behind.time) enter(order_[i - 1], behind);
  }
}

void ChunkMerge::enterDue(const MessagePosition& behind) {
  while (due_ < order_.size() && surprises_ == cache_.surprises() &&
         (open_.empty() || section(due_).info.start <= open_.front()->time)) {
    enter(order_[due_++], behind);
    const std::size_t ahead = walked_ ? std::min(due_ + ReadAhead::kSections, order_.size()) : due_;
    for (std::size_t next = due_; next < ahead; ++next) cache_.expect(order_[next], wanted_);
  }
}

void ChunkMerge::enter(std::size_t section, const MessagePosition& behind) {
  std::unique_ptr<Open> open;
  if (spare_.empty()) {
    open = std::make_unique<Open>();
  } else {
    open = std::move(spare_.back());
    spare_.pop_back();
  }
  open->section = section;
  open->offset = index_.sections[section].info.offset;
  open->channels.clear();
  open->listing.channels = wanted_;
  open->listing.overview.reset();
  if (auto records = cache_.records(section, &open->listing)) {
    open->records = std::move(*records);
    lookOver(*open);
  } else {
    listDamaged(*open);
  }
  open->seekBehind(behind);
  if (open->place == open->end) return leave(std::move(open));
  open_.push_back(std::move(open));
  std::ranges::push_heap(open_, isLater);
}

void ChunkMerge::lookOver(Open& open) {
  if (!open.listing.overview) open.listing.list(*open.records);
  const RecordsOverview& overview = *open.listing.overview;
  open.place = 0;
  if (!overview.whole) return sortBroken(open);
  const Section& section = index_.sections[open.section];
  if (section.indexed && section.info.messages != overview.messages)
    cache_.compareIndexes(open.section, MessageList::fromRecords(*open.records));
  open.end = overview.listed;
  if (overview.messages == 0) return;
  if (!overview.inOrder)
    std::ranges::stable_sort(std::span(open.listing.messages).first(open.end), {}, &MessageRecord::time);
  if (open.end != 0) open.last = open.listing.messages[open.end - 1].time;
  cache_.correctTimes(open.section, overview.first, overview.last);
}

/// Finds the same as Reader::next() and read(), which look at the records where the message indexes say.
void ChunkMerge::sortBroken(Open& open) {
  open.listing.messages = cache_.messagesOfBroken(open.section, *open.records);
  std::ranges::stable_sort(open.listing.messages, {}, &MessageRecord::time);
  if (!open.listing.messages.empty())
    cache_.correctTimes(open.section, open.listing.messages.front().time, open.listing.messages.back().time);
  const std::uint8_t* data = open.records->data();
  std::erase_if(open.listing.messages,
                [&](const MessageRecord& message) { return !(*wanted_)[channelOf(data, message)]; });
  open.end = open.listing.messages.size();
  if (open.end != 0) open.last = open.listing.messages.back().time;
}

void ChunkMerge::listDamaged(Open& open) {
  open.listing.messages.clear();
  open.place = open.end = 0;
  if (!index_.sections[open.section].indexed) return;
  const auto list = cache_.messages(open.section);
  std::vector<MessagePosition> lost;
  for (const std::uint16_t channel : channels_) {
    for (const auto& entry : list->of(channel))
      lost.push_back({entry.time, open.offset, entry.offset, channel});
  }
  std::ranges::sort(lost);
  for (const MessagePosition& message : lost) {
    open.listing.messages.push_back({message.time, static_cast<std::uint32_t>(message.offset), 0});
    open.channels.push_back(message.channelId);
  }
  open.end = lost.size();
  if (!lost.empty()) open.last = lost.back().time;
}

void ChunkMerge::finishRun() {
  if (open_.empty()) return;
  std::ranges::pop_heap(open_, isLater);
  open_.back()->seek(until_);
  if (open_.back()->place == open_.back()->end) {
    walked_ = true;
    leave(std::move(open_.back()));
    open_.pop_back();
  } else {
    std::ranges::push_heap(open_, isLater);
  }
}

void ChunkMerge::Open::seek(std::uint64_t until) {
  if (nanosecondsOf(last) < until) {
    place = end;
    return;
  }
  const std::span<const MessageRecord> rest = std::span(listing.messages).first(end).subspan(place);
  const auto isBefore = [&](const MessageRecord& message) { return nanosecondsOf(message.time) < until; };
  place += static_cast<std::size_t>(firstNot(rest, isBefore) - rest.begin());
  if (place < end) time = listing.messages[place].time;
}

void ChunkMerge::Open::seekBehind(const MessagePosition& position) {
  if (place == end) return;
  seek(nanosecondsOf(position.time));
  while (place < end && std::tuple(time, offset, std::uint64_t{listing.messages[place].offset}) <=
                            std::tuple(position.time, position.chunkOffset, position.offset)) {
    if (++place < end) time = listing.messages[place].time;
  }
}

void ChunkMerge::leave(std::unique_ptr<Open> open) {
  open->records.reset();
  cache_.leave(open->section);
  spare_.push_back(std::move(open));
}

std::uint64_t ChunkMerge::endOfRun() const {
  const Open* second = open_.size() > 1 ? open_[1].get() : nullptr;
  if (open_.size() > 2 && isLater(open_[1], open_[2])) second = open_[2].get();
  std::uint64_t until = UINT64_MAX;
  // At equal times, the messages of the earlier section come first.
  if (second != nullptr)
    until = nanosecondsOf(second->time) + (open_.front()->offset < second->offset ? 1 : 0);
  if (due_ < order_.size()) until = std::min(until, nanosecondsOf(section(due_).info.start));
  return until;
}

}  // namespace logplayer::mcap
