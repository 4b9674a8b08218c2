// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "robotlink/truth/ErrorSamples.h"

namespace robotlink {

/// Things that were there to be seen or known and were not, of those that were there; and things that were
/// reported and were not there, of those that were reported.
struct ErrorCounts {
  std::size_t there = 0, missed = 0, reported = 0, invented = 0;
};

/// The comparison of a quantity ("position") with the simulator's truth, with its unit.
struct ErrorQuantity {
  ErrorSamples amounts;
  std::string unit;
  /// The counts if the things of this quantity are others than those of the package; else all are 0.
  ErrorCounts own;
};

/// The unit of quantities whose amounts are 1 where a report was wrong and 0 where it was right: only their
/// mean is meaningful.
inline constexpr char kShareOfTime[] = "share of time";

}  // namespace robotlink
