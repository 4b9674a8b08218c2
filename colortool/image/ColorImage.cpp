// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorImage.h"

#include <algorithm>
#include <cmath>

namespace colortool {

using robotlink::YCbCr;

ColorImage ColorImage::of(const robotlink::ImageView& image) {
  if (image.empty()) return {};
  ColorImage result(image.width, image.height);
  YCbCr* to = result.pixels.data();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x, ++to) *to = robotlink::pixelYCbCr(image, x, y);
  }
  return result;
}

void visitDisc(int width, int height, double x, double y, double radius,
               const std::function<void(int, int)>& use) {
  const auto bound = [](double value, int most) {
    return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(most)));
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

}  // namespace colortool
