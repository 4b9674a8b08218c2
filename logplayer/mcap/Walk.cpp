// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/mcap/Walk.h"

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
  if (runs_.empty()) {
    standing_ = false;
    return std::nullopt;
  }
  at_ = runs_.front().position;
  advanceTop();
  return at_;
}

void Walk::seek(const MessagePosition& than, const std::vector<std::uint16_t>& channels) {
  runs_.clear();
  channels_ = channels;
  standing_ = true;
  const auto firstLater = std::ranges::partition_point(
      order_, [&](std::uint32_t section) { return !earlier(than.time, opening(index_.sections[section])); });
  due_ = static_cast<std::size_t>(firstLater - order_.begin());
  for (std::size_t i = due_; i > 0 && !earlier(lastClosing_[i - 1], than.time); --i) {
    if (!earlier(closing(index_.sections[order_[i - 1]]), than.time)) enter(order_[i - 1], than);
  }
}

/// Sections that open no later than the next message may hold one before it.
void Walk::enterDue(const MessagePosition& than) {
  while (due_ < order_.size() &&
         (runs_.empty() || !earlier(runs_.front().position.time, opening(index_.sections[order_[due_]])))) {
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
    Run run{{{}, entered.info.offset, 0, channel},
            list,
            direction_ == Direction::kForward ? entries.subspan(place) : entries.first(place)};
    if (run.entries.empty()) continue;
    look(run, direction_);
    runs_.push_back(std::move(run));
    std::ranges::push_heap(runs_, [&](const Run& a, const Run& b) { return comesLater(a, b); });
  }
}

void Walk::look(Run& run, Direction direction) {
  const MessageList::Entry& entry =
      direction == Direction::kForward ? run.entries.front() : run.entries.back();
  run.position.time = entry.time;
  run.position.offset = entry.offset;
}

/// Moves the run on top on by a message and to its new place in the heap.
void Walk::advanceTop() {
  Run& top = runs_.front();
  top.entries =
      direction_ == Direction::kForward ? top.entries.subspan(1) : top.entries.first(top.entries.size() - 1);
  if (top.entries.empty()) {
    std::swap(runs_.front(), runs_.back());
    runs_.pop_back();
    if (runs_.empty()) return;
  } else {
    look(top, direction_);
  }
  for (std::size_t i = 0;;) {
    std::size_t child = 2 * i + 1;
    if (child >= runs_.size()) return;
    if (child + 1 < runs_.size() && before(runs_[child + 1].position, runs_[child].position)) ++child;
    if (!before(runs_[child].position, runs_[i].position)) return;
    std::swap(runs_[i], runs_[child]);
    i = child;
  }
}

}  // namespace logplayer::mcap
