// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace colortool::test {

/// Calls `use(x, y)`, row by row, for each pixel of an image of this size whose center lies in a disc. Center
/// and radius are in pixels, pixel centers at whole numbers; a radius of 3 around a pixel center covers 29
/// pixels.
template <typename Use>
void visitDisc(int width, int height, double x, double y, double radius, const Use& use) {
  const auto bound = [](double value, int max) {
    return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(max)));
  };
  const int top = std::max(0, bound(std::ceil(y - radius), height)),
            bottom = bound(std::floor(y + radius), height - 1);
  const int left = std::max(0, bound(std::ceil(x - radius), width)),
            right = bound(std::floor(x + radius), width - 1);
  for (int atY = top; atY <= bottom; ++atY) {
    for (int atX = left; atX <= right; ++atX) {
      if ((atX - x) * (atX - x) + (atY - y) * (atY - y) <= radius * radius) use(atX, atY);
    }
  }
}

}  // namespace colortool::test
