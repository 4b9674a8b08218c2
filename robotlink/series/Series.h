// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <memory>
#include <vector>

namespace robotlink {

/// Numbers over time, in order of time, with a pyramid of minima and maxima above them: each entry of a level
/// is the extent of kFan entries of the level below. So what millions of points look like in a plot is known
/// from a few thousand reads. A point takes kBytesPerPoint at most, pyramid included. Values may be NaN,
/// times must not be. Indices count from the oldest point that is kept. Movable; one thread.
class Series {
 public:
  struct Point {
    double time = 0;  ///< s
    double value = 0;
    bool operator==(const Point&) const = default;
  };
  /// The smallest and the largest of some values; NaN does not count.
  struct Extent {
    double min = std::numeric_limits<double>::infinity();
    double max = -std::numeric_limits<double>::infinity();
    /// Whether there was no value.
    bool isEmpty() const { return min > max; }
    void add(const Extent& other) {
      min = other.min < min ? other.min : min;
      max = other.max > max ? other.max : max;
    }
  };
  /// The points in one of several equal parts of a range of time, [begin, end) by their indices.
  struct Column {
    std::size_t part = 0;  ///< The index of the part, from 0.
    std::size_t begin = 0, end = 0;
    double first = 0, last = 0;  ///< The values of its first and its last point.
    Extent extent;
  };
  static constexpr std::size_t kBytesPerPoint = 18;

  /// Adds a point; one that is older than the last one gets its place by time, at a cost that grows with the
  /// number of points after it.
  void append(Point point) {
    if (point.time < newest_) {
      insert(point);
      return;
    }
    push(point);
    newest_ = point.time;
    if (end_ % kFan == 0) summarize();
  }
  void clear() { *this = {}; }
  /// Drops the oldest points, kBlock at a time, until bytes() is not greater; the newest ones stay.
  void limit(std::size_t bytes);
  /// Adds this to all times; in s.
  void shift(double seconds);

  bool empty() const { return begin_ == end_; }
  std::size_t size() const { return end_ - begin_; }
  Point operator[](std::size_t index) const { return pointAt(begin_ + index); }
  Point front() const { return (*this)[0]; }
  Point back() const { return (*this)[size() - 1]; }
  /// The index of the first point that is not earlier, or that is later; size() if there is none.
  std::size_t firstFrom(double time) const { return search(0, size(), time, false); }
  std::size_t firstAfter(double time) const { return search(0, size(), time, true); }
  /// The extent of the points [begin, end).
  Extent extent(std::size_t begin, std::size_t end) const;
  /// The points in `count` equal parts of [from, to); those without points are left out. Parts with hundreds
  /// of points may begin and end a sixteenth of their length too early or too late. O(count log size()).
  std::vector<Column> columns(double from, double to, std::size_t count) const;
  /// The memory that is held.
  std::size_t bytes() const;

  /// Points that are allocated, and dropped, at a time.
  static constexpr std::size_t kBlock = 1024;
  static constexpr std::size_t kFan = 16;
  /// The number of points per column up to which each point is looked at.
  static constexpr std::size_t kFew = 32;

 private:
  /// The times of kBlock points, then their values.
  using Block = std::unique_ptr<double[]>;
  struct Level {
    /// Number of the first entry that is kept, counted from the first one ever.
    std::size_t first = 0;
    std::deque<Extent> entries = {};
    std::size_t end() const { return first + entries.size(); }
  };

  // Here numbers of points count from the first one ever.
  double* block(std::size_t number) const { return blocks_[number / kBlock - begin_ / kBlock].get(); }
  double& timeAt(std::size_t number) const { return block(number)[number % kBlock]; }
  double& valueAt(std::size_t number) const { return block(number)[kBlock + number % kBlock]; }
  Point pointAt(std::size_t number) const { return {timeAt(number), valueAt(number)}; }
  void push(Point point) {
    const std::size_t place = end_ % kBlock;
    if (place == 0) addBlock();
    tail_[place] = point.time;
    tail_[kBlock + place] = point.value;
    ++end_;
  }
  void addBlock();
  void insert(Point point);
  /// Adds the entries of all levels whose points are complete.
  void summarize();
  /// The extent of points of one block, at least one.
  Extent extentOfPoints(std::size_t begin, std::size_t end) const;
  Extent extentOfEntries(const Level& level, std::size_t begin, std::size_t end) const;
  /// The first index in [begin, end) whose time is not earlier, or later; `end` if there is none.
  std::size_t search(std::size_t begin, std::size_t end, double time, bool isLater) const;
  /// The same as columns() of the points [begin, end), each of which is looked at.
  std::vector<Column> columnsOfFew(std::size_t begin, std::size_t end, double from, double to,
                                   std::size_t count) const;
  /// firstFrom(), which is quick if the index is near `guess`; it is not less than `begin`.
  std::size_t firstFromNear(std::size_t begin, std::size_t guess, double time) const;

  std::deque<Block> blocks_;
  /// The newest block.
  double* tail_ = nullptr;
  std::vector<Level> levels_;
  /// Number of the first point that is kept, a multiple of kBlock, and of the next one.
  std::size_t begin_ = 0, end_ = 0;
  /// The time of the last point.
  double newest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace robotlink
