// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace widgets {

/// Font size in pixels for the size in a message: rounded and clamped to 6 to 200, NaN included.
inline int fontPixels(double size) {
  return static_cast<int>(std::lround(std::min(std::max(6.0, size), 200.0)));
}

}  // namespace widgets
