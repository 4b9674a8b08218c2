// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "robotlink/base/Image.h"

namespace colortool {

/// The colours of an image, one a pixel, top row first, whatever format they came in. A plain value.
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

  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  const robotlink::YCbCr& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// Calls `use` for each pixel of an image of that size whose centre is within a disc, centre and radius in
/// pixels (a radius of 3 around a pixel's centre: 29 pixels), row by row.
void visitDisc(int width, int height, double x, double y, double radius,
               const std::function<void(int, int)>& use);

}  // namespace colortool
