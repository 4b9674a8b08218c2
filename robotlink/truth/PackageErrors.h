// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "robotlink/truth/ErrorQuantity.h"
#include "robotlink/truth/EventErrors.h"

namespace robotlink {

/// The errors of a solution's packages in comparison with the truth.
struct PackageErrors : ErrorCounts {
  std::map<std::string, ErrorQuantity> quantities;
  /// The counts of quantities of which nothing was reported yet, and perhaps never is; they are not shown.
  std::map<std::string, ErrorCounts> unreported;
  /// From the reading that a package is based on until it was published, s of the platform's time.
  ErrorSamples latency;
  /// The events in progress, by name.
  std::map<std::string, EventErrors> events;

  void add(const std::string& quantity, const char* unit, double amount) {
    ErrorQuantity& found = quantities[quantity];
    found.unit = unit;
    found.amounts.add(amount);
  }
  /// The counts that belong to a quantity.
  const ErrorCounts& countsOf(const ErrorQuantity& quantity) const {
    return quantity.own.there + quantity.own.reported > 0 ? quantity.own : *this;
  }
};

}  // namespace robotlink
