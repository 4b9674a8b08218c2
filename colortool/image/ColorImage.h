// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/Image.h"

namespace colortool {

/// An image with one YCbCr color per pixel, top row first, independent of the format it came in. A plain
/// value.
struct ColorImage {
  int width = 0;
  int height = 0;
  std::vector<robotlink::YCbCr> pixels;

  ColorImage() = default;
  ColorImage(int imageWidth, int imageHeight)
      : width(imageWidth),
        height(imageHeight),
        pixels(static_cast<std::size_t>(imageWidth) * static_cast<std::size_t>(imageHeight)) {}
  /// Reads an image of any format that robotlink knows; pixels that share their chroma get the same.
  static ColorImage of(const robotlink::ImageView& image);

  /// Whether (x, y) is a pixel of the image.
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  /// The pixel must lie in the image; this is not checked.
  const robotlink::YCbCr& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

}  // namespace colortool
