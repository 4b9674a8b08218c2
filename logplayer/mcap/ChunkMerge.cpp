// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/ChunkMerge.h"

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>

namespace logplayer::mcap {

ChunkMerge::ChunkMerge(const FileIndex& index, SectionCache& cache, std::vector<std::uint16_t> channels,
                       std::size_t maxBytes)
    : index_(index), cache_(cache), channels_(std::move(channels)), maxBytes_(maxBytes) {
  for (const std::uint16_t channel : channels_) wanted_.set(channel);
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

/// Whether at no time more than `maxBytes_` have begun and not ended; a single section always fits.
bool ChunkMerge::overlapsFit() const {
  using End = std::pair<Instant, std::uint64_t>;  // and the section's bytes
  std::priority_queue<End, std::vector<End>, std::greater<>> begun;
  std::uint64_t bytes = 0;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const Reader::ChunkInfo& info = section(i).info;
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
  runEnd_ = endOfRun();
  return {top.offset, std::span(top.messages).subspan(top.place, runEnd_ - top.place), &top.records,
          top.records ? nullptr : top.channels.data() + top.place};
}

void ChunkMerge::lookUp(const MessagePosition& behind) {
  open_.clear();
  runEnd_ = 0;
  standing_ = true;
  const auto firstLater = std::ranges::partition_point(
      order_, [&](std::uint32_t i) { return index_.sections[i].info.start <= behind.time; });
  due_ = static_cast<std::size_t>(firstLater - order_.begin());
  for (std::size_t i = due_; i > 0 && lastEnd_[i - 1] >= behind.time; --i) {
    if (section(i - 1).info.end >= behind.time) enter(order_[i - 1], behind);
  }
}

/// Sections that begin no later than the next message may hold one before it.
void ChunkMerge::enterDue(const MessagePosition& behind) {
  while (due_ < order_.size() && surprises_ == cache_.surprises() &&
         (open_.empty() || section(due_).info.start <= open_.front()->time())) {
    enter(order_[due_++], behind);
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
  open->messages.clear();
  open->channels.clear();
  if (auto records = cache_.records(section)) {
    open->records = std::move(*records);
    listReadable(*open);
  } else {
    listDamaged(*open);
  }
  const auto isBefore = [&](const MessageRecord& message) {
    return std::tuple(message.time, open->offset, std::uint64_t{message.offset}) <=
           std::tuple(behind.time, behind.chunkOffset, behind.offset);
  };
  const auto first = std::ranges::partition_point(open->messages, isBefore);
  open->place = static_cast<std::size_t>(first - open->messages.begin());
  if (open->place == open->messages.size()) return leave(std::move(open));
  open_.push_back(std::move(open));
  std::ranges::push_heap(open_, isLater);
}

void ChunkMerge::listReadable(Open& open) {
  Instant last = Instant::min();
  bool inOrder = true;
  auto& messages = open.messages;
  // Gathered in a few bytes of the stack first, where nothing else can point to.
  std::array<MessageRecord, 256> some;
  std::size_t count = 0;
  const auto gather = [&] {
    messages.insert(messages.end(), some.begin(), some.begin() + static_cast<std::ptrdiff_t>(count));
    count = 0;
  };
  visitMessages(*open.records, wanted_, [&](const MessageRecord& message) {
    inOrder = inOrder && last <= message.time;
    last = message.time;
    some[count++] = message;
    if (count == some.size()) gather();
    return true;
  });
  gather();
  if (!inOrder) std::ranges::stable_sort(messages, {}, &MessageRecord::time);
  if (!messages.empty()) cache_.correctTimes(open.section, messages.front().time, messages.back().time);
}

/// What its message indexes say, so that it is known what is missing.
void ChunkMerge::listDamaged(Open& open) {
  if (!index_.sections[open.section].indexed) return;
  const auto list = cache_.messages(open.section);
  std::vector<MessagePosition> lost;
  for (const std::uint16_t channel : channels_) {
    for (const auto& entry : list->of(channel))
      lost.push_back({entry.time, open.offset, entry.offset, channel});
  }
  std::ranges::sort(lost);
  for (const MessagePosition& message : lost) {
    open.messages.push_back({message.time, static_cast<std::uint32_t>(message.offset), 0});
    open.channels.push_back(message.channelId);
  }
}

/// Goes on behind the run that was handed out.
void ChunkMerge::finishRun() {
  if (open_.empty()) return;
  std::ranges::pop_heap(open_, isLater);
  open_.back()->place = runEnd_;
  if (runEnd_ == open_.back()->messages.size()) {
    leave(std::move(open_.back()));
    open_.pop_back();
  } else {
    std::ranges::push_heap(open_, isLater);
  }
}

/// Its memory is free for the next one.
void ChunkMerge::leave(std::unique_ptr<Open> open) {
  open->records.reset();
  cache_.leave(open->section);
  spare_.push_back(std::move(open));
}

/// Up to where the messages of the section on top come before those of all others.
std::size_t ChunkMerge::endOfRun() const {
  const Open& top = *open_.front();
  const Open* second = open_.size() > 1 ? open_[1].get() : nullptr;
  if (open_.size() > 2 && isLater(open_[1], open_[2])) second = open_[2].get();
  const bool anyDue = due_ < order_.size();
  const Instant due = anyDue ? section(due_).info.start : Instant::max();
  const auto comesFirst = [&](const MessageRecord& message) {
    if (anyDue && message.time >= due) return false;
    return second == nullptr || message.time < second->time() ||
           (message.time == second->time() && top.offset < second->offset);
  };
  if (comesFirst(top.messages.back())) return top.messages.size();
  // Ever farther, as runs of sections that overlap are short.
  std::size_t known = top.place, step = 1;
  while (known + step < top.messages.size() && comesFirst(top.messages[known + step])) {
    known += step;
    step *= 2;
  }
  const auto rest = std::span(top.messages).subspan(known, std::min(step, top.messages.size() - known));
  return known + static_cast<std::size_t>(std::ranges::partition_point(rest, comesFirst) - rest.begin());
}

}  // namespace logplayer::mcap
