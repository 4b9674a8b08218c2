// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/series/Series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace robotlink {

static_assert(Series::kBlock % Series::kFan == 0);

void Series::addBlock() {
  blocks_.push_back(std::make_unique_for_overwrite<double[]>(2 * kBlock));
  tail_ = blocks_.back().get();
}

void Series::insert(Point point) {
  push(pointAt(end_ - 1));
  std::size_t place = end_ - 2;
  for (; place > begin_ && timeAt(place - 1) > point.time; --place) {
    timeAt(place) = timeAt(place - 1);
    valueAt(place) = valueAt(place - 1);
  }
  timeAt(place) = point.time;
  valueAt(place) = point.value;
  std::size_t span = 1;
  for (Level& level : levels_) {
    span *= kFan;
    const std::size_t valid = place / span - level.first;
    if (valid < level.entries.size()) level.entries.resize(valid);
  }
  summarize();
}

void Series::summarize() {
  std::size_t span = kFan;
  for (std::size_t i = 0; end_ / span > 0; ++i, span *= kFan) {
    if (i == levels_.size()) levels_.push_back({begin_ / span});
    Level& level = levels_[i];
    while (level.end() < end_ / span) {
      const std::size_t first = level.end() * kFan, end = first + kFan;
      // Dropped points do not count; entries above them are never requested.
      level.entries.push_back(
          i == 0 ? extentOfPoints(first, end)
                 : extentOfEntries(levels_[i - 1], std::max(first, levels_[i - 1].first), end));
    }
  }
}

Series::Extent Series::extentOfPoints(std::size_t begin, std::size_t end) const {
  Extent extent;
  const double* values = block(begin) + kBlock;
  for (std::size_t i = begin % kBlock; i < begin % kBlock + (end - begin); ++i)
    extent.add({values[i], values[i]});
  return extent;
}

Series::Extent Series::extentOfEntries(const Level& level, std::size_t begin, std::size_t end) const {
  Extent extent;
  if (begin >= end) return extent;
  auto entry = level.entries.begin() + static_cast<std::ptrdiff_t>(begin - level.first);
  for (std::size_t i = begin; i < end; ++i) extent.add(*entry++);
  return extent;
}

Series::Extent Series::extent(std::size_t begin, std::size_t end) const {
  Extent extent;
  std::size_t from = begin_ + begin, to = begin_ + end;
  // The ragged ends of each level, from the points upwards; the part in between is taken from the next level.
  for (std::size_t i = 0; from < to; ++i) {
    const bool isTop = i == levels_.size();
    const std::size_t whole = isTop ? to : std::min((from + kFan - 1) / kFan * kFan, to);
    const std::size_t rest = isTop ? to : std::max(to / kFan * kFan, whole);
    for (const auto& [first, last] : {std::pair(from, whole), std::pair(rest, to)}) {
      if (first < last)
        extent.add(i == 0 ? extentOfPoints(first, last) : extentOfEntries(levels_[i - 1], first, last));
    }
    from = whole / kFan;
    to = rest / kFan;
  }
  return extent;
}

std::size_t Series::search(std::size_t begin, std::size_t end, double time, bool isLater) const {
  while (begin < end) {
    const std::size_t middle = begin + (end - begin) / 2;
    const double here = timeAt(begin_ + middle);
    if (here < time || (isLater && here == time)) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

std::size_t Series::firstFromNear(std::size_t begin, std::size_t guess, double time) const {
  const auto isEarlier = [&](std::size_t index) { return timeAt(begin_ + index) < time; };
  guess = std::clamp(guess, begin, size());
  std::size_t step = 1;
  if (guess < size() && isEarlier(guess)) {
    std::size_t low = guess + 1;
    for (; low + step < size() && isEarlier(low + step); step *= 2) low += step + 1;
    return search(low, std::min(low + step, size()), time, false);
  }
  std::size_t high = guess;
  for (; high >= begin + step && !isEarlier(high - step); step *= 2) high -= step;
  return search(high >= begin + step ? high - step + 1 : begin, high, time, false);
}

std::vector<Series::Column> Series::columnsOfFew(std::size_t begin, std::size_t end, double from, double to,
                                                 std::size_t count) const {
  std::vector<Column> columns;
  columns.reserve(count);
  const double width = (to - from) / static_cast<double>(count), perTime = 1 / width;
  double until = -std::numeric_limits<double>::infinity();
  // Kept in registers, unlike the elements of a vector.
  Column column;
  Extent extent;
  const auto complete = [&] {
    column.extent = extent;
    if (column.begin < column.end) columns.push_back(column);
  };
  while (begin < end) {
    // The points of one block lie one behind the other.
    const std::size_t number = begin_ + begin;
    const double* times = block(number) + number % kBlock;
    const double* values = times + kBlock;
    const std::size_t length = std::min(kBlock - number % kBlock, end - begin);
    for (std::size_t i = 0; i < length;) {
      if (times[i] >= until) {
        complete();
        const std::size_t next = columns.empty() ? 0 : columns.back().part + 1;
        column.part = std::clamp(static_cast<std::size_t>((times[i] - from) * perTime), next, count - 1);
        column.begin = begin + i;
        column.first = values[i];
        extent = {};
        until = column.part == count - 1 ? std::numeric_limits<double>::infinity()
                                         : from + static_cast<double>(column.part + 1) * width;
      }
      do {
        extent.add({values[i], values[i]});
        ++i;
      } while (i < length && times[i] < until);
      column.end = begin + i;
      column.last = values[i - 1];
    }
    begin += length;
  }
  complete();
  return columns;
}

std::vector<Series::Column> Series::columns(double from, double to, std::size_t count) const {
  const std::size_t first = firstFrom(from), after = firstFrom(to);
  if (after - first <= kFew * count) return columnsOfFew(first, after, from, to, count);
  std::vector<Column> columns;
  columns.reserve(count);
  const double tolerance = (to - from) / static_cast<double>(count * kFan);
  std::size_t begin = firstFrom(from), width = 0;
  for (std::size_t i = 1; i <= count && begin < size(); ++i) {
    const double until = from + (to - from) * static_cast<double>(i) / static_cast<double>(count);
    const std::size_t guess = begin + width;
    // Nearly all of the time goes into reads of single points, which are far apart in memory.
    const bool isNear = i < count && width >= kFan * kFan && guess < size() &&
                        std::abs(timeAt(begin_ + guess) - until) <= tolerance;
    std::size_t end = isNear ? guess : firstFromNear(begin, guess, until);
    if (i < count && end - begin >= kFan * kFan) end -= (begin_ + end) % kFan;
    width = end - begin;
    if (width > 0) {
      columns.push_back(
          {i - 1, begin, end, valueAt(begin_ + begin), valueAt(begin_ + end - 1), extent(begin, end)});
    }
    begin = end;
  }
  return columns;
}

void Series::limit(std::size_t bytes) {
  while (blocks_.size() > 1 && this->bytes() > bytes) {
    blocks_.pop_front();
    begin_ += kBlock;
    std::size_t span = 1;
    for (Level& level : levels_) {
      span *= kFan;
      while (!level.entries.empty() && (level.first + 1) * span <= begin_) {
        level.entries.pop_front();
        ++level.first;
      }
    }
  }
}

void Series::shift(double seconds) {
  for (std::size_t i = begin_; i < end_; ++i) timeAt(i) += seconds;
  newest_ += seconds;
}

std::size_t Series::bytes() const {
  std::size_t extents = 0;
  for (const Level& level : levels_) extents += level.entries.size();
  return blocks_.size() * 2 * kBlock * sizeof(double) + extents * sizeof(Extent);
}

}  // namespace robotlink
