// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/assert/source_location.hpp>
#include <string>

namespace simcore::truth {

/// What a quantity is held against.
struct Known {
  /// What is measured, such as "free fall, way after 1 s".
  const char* quantity;
  /// Where the expected value comes from: a formula, or what computes it.
  const char* reference;
  double expected = 0;
  /// The largest difference from `expected` that is right.
  double tolerance = 0;
  const char* unit = "";
};

/// Fails the running test unless a measured value is finite and within the tolerance, and adds a row to the
/// table of the test's suite. If a quantity is compared several times, the row has the largest error.
///
/// Where the environment variable ROBOTCONTROL_TRUTH_TABLE names a file, the table is written there after all
/// tests, replacing what is below the line kTableBegin. When a program has run all of its tests, all rows
/// must be in simcore/TRUTH.md, with the same references and tolerances; errors differ between processors.
void compare(const Known& known, double measured,
             const boost::source_location& where = BOOST_CURRENT_LOCATION);

/// The larger of two numbers; NaN if one of them is NaN, which std::max may hide.
double largerOf(double one, double other);

inline constexpr const char* kTableBegin = "<!-- The table is written by simcore_truth_tests. -->";

}  // namespace simcore::truth
