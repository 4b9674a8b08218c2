// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ColorImage.h"

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

}  // namespace colortool
