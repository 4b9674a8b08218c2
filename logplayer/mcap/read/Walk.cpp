// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/read/Walk.h"

#include <algorithm>
#include <numeric>

namespace logplayer::mcap {

Walk::Walk(Direction direction, const FileIndex& index, SectionCache& cache)
    : direction_(direction), index_(index), cache_(cache) {
  sortSections();
}

void Walk::sortSections() {
  surprises_ = cache_.surprises();
  standing_ = false;
  order_.resize(index_.sections.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::ranges::stable_sort(order_, [&](std::uint32_t a, std::uint32_t b) {
    return earlier(opening(index_.sections[a]), opening(index_.sections[b]));
  });
  lastClosing_.clear();
  lastClosing_.reserve(order_.size());
  for (const std::uint32_t section : order_) {
    Instant closes = closing(index_.sections[section]);
    if (!lastClosing_.empty() && earlier(closes, lastClosing_.back())) closes = lastClosing_.back();
    lastClosing_.push_back(closes);
  }
}

std::optional<MessagePosition> Walk::step(const MessagePosition& than,
                                          const std::vector<std::uint16_t>& channels) {
  if (surprises_ != cache_.surprises()) sortSections();
  if (!standing_ || than != at_ || channels != channels_) seek(than, channels);
  enterDue(than);
  if (next_.empty()) {
    standing_ = false;
    return std::nullopt;
  }
  at_ = next_.front().position;
  advanceTop();
  return at_;
}

void Walk::seek(const MessagePosition& than, const std::vector<std::uint16_t>& channels) {
  runs_.clear();
  over_.clear();
  next_.clear();
  channels_ = channels;
  standing_ = true;
  const auto firstLater = std::ranges::partition_point(
      order_, [&](std::uint32_t section) { return !earlier(than.time, opening(index_.sections[section])); });
  due_ = static_cast<std::size_t>(firstLater - order_.begin());
  for (std::size_t i = due_; i > 0 && !earlier(lastClosing_[i - 1], than.time); --i) {
    if (!earlier(closing(index_.sections[order_[i - 1]]), than.time)) enter(order_[i - 1], than);
  }
}

/// Sections that open no later than the next message may contain an earlier one.
void Walk::enterDue(const MessagePosition& than) {
  while (due_ < order_.size() &&
         (next_.empty() || !earlier(next_.front().position.time, opening(index_.sections[order_[due_]])))) {
    enter(order_[due_++], than);
  }
}

void Walk::enter(std::size_t section, const MessagePosition& than) {
  const Section& entered = index_.sections[section];
  const bool wanted = std::ranges::any_of(channels_, [&](std::uint16_t id) { return entered.mayHold(id); });
  if (!wanted) return;
  const std::shared_ptr<const MessageList> list = cache_.messages(section);
  for (const std::uint16_t channel : channels_) {
    const auto entries = list->of(channel);
    const auto isBefore = [&](const MessageList::Entry& entry) {
      const MessagePosition position{entry.time, entered.info.offset, entry.offset, channel};
      return direction_ == Direction::kForward ? position <= than : position < than;
    };
    const auto split = std::ranges::partition_point(entries, isBefore) - entries.begin();
    const auto place = static_cast<std::size_t>(split);
    const auto left = direction_ == Direction::kForward ? entries.subspan(place) : entries.first(place);
    if (!left.empty()) add({section, list, left}, {{}, entered.info.offset, 0, channel});
  }
}

void Walk::add(Run run, MessagePosition position) {
  std::size_t number = runs_.size();
  if (over_.empty()) {
    runs_.push_back(std::move(run));
  } else {
    number = over_.back();
    over_.pop_back();
    runs_[number] = std::move(run);
  }
  Next next{position, number};
  look(next);
  next_.push_back(next);
  std::ranges::push_heap(next_, [&](const Next& a, const Next& b) { return before(b.position, a.position); });
}

void Walk::look(Next& next) const {
  const auto& entries = runs_[next.run].entries;
  const MessageList::Entry& entry = direction_ == Direction::kForward ? entries.front() : entries.back();
  next.position.time = entry.time;
  next.position.offset = entry.offset;
}

/// Only when no run of the section is left, and only forwards: a backwards walk often turns around.
void Walk::leave(std::size_t section) {
  const bool more =
      std::ranges::any_of(next_, [&](const Next& next) { return runs_[next.run].section == section; });
  if (!more && direction_ == Direction::kForward) cache_.leave(section);
}

/// Advances the run on top by one message and restores the heap.
void Walk::advanceTop() {
  Next top = next_.front();
  Run& run = runs_[top.run];
  run.entries =
      direction_ == Direction::kForward ? run.entries.subspan(1) : run.entries.first(run.entries.size() - 1);
  if (!run.entries.empty()) {
    look(top);
    return sink(top);
  }
  run.list.reset();
  over_.push_back(top.run);
  const Next last = next_.back();
  next_.pop_back();
  if (!next_.empty()) sink(last);
  leave(run.section);
}

/// Moves `next` down from the top, which is free, to its place in the heap.
void Walk::sink(Next next) {
  std::size_t hole = 0;
  for (std::size_t child = 1; child < next_.size(); child = 2 * hole + 1) {
    if (child + 1 < next_.size() && before(next_[child + 1].position, next_[child].position)) ++child;
    if (!before(next_[child].position, next.position)) break;
    next_[hole] = next_[child];
    hole = child;
  }
  next_[hole] = next;
}

}  // namespace logplayer::mcap
