// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class WorldObject;
class WorldPort;
}  // namespace robotcontrol

namespace widgets {

/// The unit and the range of one of the numbers of a port.
struct PortNumber {
  /// Its range, in the unit; not known if they are not in order.
  double minimum = 0, maximum = 0;
  std::string unit;

  bool hasRange() const { return minimum < maximum; }
};

/// Returns the number of a port's numbers: 1 for a scalar. Shapes that no port has count as far as they can.
int numberCount(const robotcontrol::WorldPort& port);
/// A number of the port of an object, from 0: with its own range and unit where the numbers differ.
PortNumber portNumber(const robotcontrol::WorldObject& object, int number);

}  // namespace widgets
