// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace simcore {

/// What a port carries, so that one generic view can show any of them.
struct PortInfo {
  std::string path;        ///< "red1/legFL1/position"
  std::string robot;       ///< "red1"
  std::string type;        ///< "angle", "distance", "acceleration", "contact", "image", "range", ...
  std::vector<int> shape;  ///< {} a scalar, {3} a vector, {height, width, channels} an image
  std::string unit;        ///< "rad", "m", "m/s^2", "" ...
};

}  // namespace simcore
