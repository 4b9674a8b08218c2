// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "robotlink/series/PointFilter.h"
#include "robotlink/series/Series.h"
#include "widgets/plots/LoggedCurve.h"

namespace widgets {

/// Puts the values that the history has on disk before those that the session publishes, as they are read.
/// Times are seconds on the session's timeline. One thread.
class PastValues {
 public:
  using Point = robotlink::Series::Point;
  /// Bound of the memory for what a filter needs again while values are read.
  static constexpr std::size_t kMaxBytes = 64U << 20U;

  /// Notes a value that the session published, before the filter, if there is one.
  void note(const Point& point, bool isFiltered);
  /// Forgets all, after the clock went back.
  void restart() { *this = {}; }

  /// Whether there are values before which others may be on disk, and it is not decided yet whether they are
  /// read: by read() or skip().
  bool isWanted() const { return begin_.has_value() && !isDecided_; }
  /// The time of the first value that the session published; unset: there is none.
  const std::optional<double>& begin() const { return begin_; }
  /// Sets the values that are read from now on, in order of time.
  void read(std::shared_ptr<const LoggedCurve> values);
  void skip();
  /// Null if nothing is being read.
  const std::shared_ptr<const LoggedCurve>& values() const { return values_; }

  /// Puts what was read before the values that the session published, which `live` has as the filter made
  /// them. Returns whether it did. While reading continues it waits until there is a good deal more, since it
  /// costs as much as all values.
  bool mergeInto(robotlink::Series& live, robotlink::PointFilter& filter);
  /// From when to when values are still to be read, if there are some; unset: none are. It begins at the
  /// begin of time if nothing was read yet.
  std::optional<std::pair<double, double>> unread() const;

 private:
  std::optional<double> begin_;
  bool isDecided_ = false;
  /// Null if nothing is read, or all was.
  std::shared_ptr<const LoggedCurve> values_;
  /// The number of values that were put before the others, and the time of the last one.
  std::size_t merged_ = 0;
  std::optional<double> reached_;
  /// The values that the session published, before the filter; empty without one, and when nothing is read.
  robotlink::Series raw_;
};

}  // namespace widgets
