// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "robotlink/base/Clock.h"

namespace widgets {

/// How many messages of a stream were told when, for any zoom of a time line. Memory is bounded: up to
/// `kExact` messages their times are kept; of longer streams only how many fell into each of `kBins` equal
/// spans, between which messages count as evenly spread. A plain value.
class MessageDensity {
 public:
  static constexpr std::size_t kExact = 1U << 15U;
  static constexpr std::size_t kBins = 1U << 15U;

  MessageDensity() = default;
  /// `times` are sorted.
  explicit MessageDensity(std::vector<robotlink::Instant> times);

  std::uint64_t count() const { return count_; }
  /// Messages in [from, to); about so many for streams that are too long to be kept exactly.
  std::uint64_t between(robotlink::Instant from, robotlink::Instant to) const {
    return before(to) - before(from);
  }
  /// The time of the message nearest to `time`, at most `reach` away; `time` itself if there is none or if
  /// they are not kept exactly.
  robotlink::Instant snapped(robotlink::Instant time, robotlink::Duration reach) const;

 private:
  /// Messages earlier than `time`.
  std::uint64_t before(robotlink::Instant time) const;

  std::uint64_t count_ = 0;
  std::vector<robotlink::Instant> times_;  // empty for long streams
  robotlink::Instant first_, last_;
  std::vector<std::uint64_t> sums_;  // of the bins up to each; kBins + 1 of them, from 0
};

}  // namespace widgets
