// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace widgets {

/// The size of a font that a message asks for, in pixels: whole, readable and not absurd, also if it is not a
/// number.
inline int fontPixels(double size) {
  return static_cast<int>(std::lround(std::min(std::max(6.0, size), 200.0)));
}

}  // namespace widgets
