// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace simcore {
class Simulation;
struct Port;
}  // namespace simcore

namespace app {

/// The limits of a port's number, in its unit; unknown if they are not in order.
struct ValueRange {
  double minimum = 0, maximum = 0;

  bool isKnown() const { return minimum < maximum; }
  bool operator==(const ValueRange&) const = default;
};

/// The range of each number of an actuator, or of a sensor that is no image.
std::vector<ValueRange> rangesOf(const simcore::Simulation& simulation, const simcore::Port& port);

}  // namespace app
