// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace simcore {

/// Describes the data of a port, so that one generic view can show any port.
struct PortInfo {
  /// Unique name: "red1/legFL1/position".
  std::string path;
  /// The model's name: "red1".
  std::string robot;
  /// Kind of data: "angle", "distance", "acceleration", "contact", "image", "range", ...
  std::string type;
  /// Dimensions: {} for a scalar, {3} for a vector, {height, width, channels} for an image.
  std::vector<int> shape;
  /// The unit, such as "rad", "m", "m/s^2"; empty if there is none.
  std::string unit;
  /// The range of its numbers, in the unit; unknown if maximum <= minimum.
  double minimum = 0, maximum = 0;
};

}  // namespace simcore
