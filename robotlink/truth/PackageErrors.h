// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "robotlink/truth/ErrorSamples.h"

namespace robotlink {

/// What is compared with the simulator's truth, by the name of its quantity ("position"), with its unit.
struct ErrorQuantity {
  ErrorSamples amounts;
  std::string unit;
};

/// How far what a solution publishes is from the truth.
struct PackageErrors {
  std::map<std::string, ErrorQuantity> quantities;
  /// Things that were there to be seen or known and were not, of those that were there; and things that were
  /// reported and were not there, of those that were reported.
  std::size_t there = 0, missed = 0, reported = 0, invented = 0;
  /// From the reading that a package is based on until it was published, s of the platform's time.
  ErrorSamples latency;
};

}  // namespace robotlink
