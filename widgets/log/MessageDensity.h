// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Clock.h"

namespace widgets {

/// The times of a stream's messages in bounded memory, for drawing them at any zoom of a timeline. For up to
/// `kExact` messages all times are kept; for longer streams only the number of messages in each of `kBins`
/// intervals of equal length, within which they count as evenly distributed. A plain value.
class MessageDensity {
 public:
  /// Largest number of messages whose times are kept.
  static constexpr std::size_t kExact = 1U << 15U;
  /// Number of intervals for longer streams.
  static constexpr std::size_t kBins = 1U << 15U;

  MessageDensity() = default;
  /// `times` must be sorted.
  explicit MessageDensity(std::vector<robotlink::Instant> times);

  std::uint64_t count() const { return count_; }
  /// Number of messages in [from, to); an estimate for streams longer than kExact.
  std::uint64_t between(robotlink::Instant from, robotlink::Instant to) const {
    return before(to) - before(from);
  }
  /// The time of the message nearest to `time`, at most `reach` away; `time` itself if there is none or the
  /// times are not kept.
  robotlink::Instant snapped(robotlink::Instant time, robotlink::Duration reach) const;

 private:
  /// Number of messages earlier than `time`.
  std::uint64_t before(robotlink::Instant time) const;

  std::uint64_t count_ = 0;
  /// All times, sorted; empty for long streams.
  std::vector<robotlink::Instant> times_;
  /// Ends of the intervals; only for long streams.
  robotlink::Instant first_, last_;
  /// sums_[i] is the number of messages in the first i intervals; kBins + 1 entries, empty for short streams.
  std::vector<std::uint64_t> sums_;
};

}  // namespace widgets
