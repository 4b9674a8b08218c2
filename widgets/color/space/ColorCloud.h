// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "robotlink/base/Image.h"

namespace widgets {

/// Pixels of an image with nearly the same color.
struct CloudPoint {
  /// The color of one of them.
  robotlink::YCbCr color;
  /// Number of the pixels.
  std::uint32_t pixels = 0;
};

/// The colors of an image, each once. Immutable once it is made; shared between threads.
struct ColorCloud {
  std::vector<CloudPoint> points;

  /// Number of the image's pixels in a cell of the color table. Linear in the number of points.
  std::size_t pixelsIn(std::size_t cell) const;
};

/// Counts the colors of images. Two colors are the same if they fall into the same pair of values in each
/// channel, so a cell of the color table has at most eight points. Takes about 8 ns per pixel and keeps 16 MB
/// for the next image. Not thread-safe.
class CloudMaker {
 public:
  std::shared_ptr<const ColorCloud> cloudOf(const robotlink::ImageView& image);

 private:
  /// Counter of one color.
  struct Place {
    std::uint32_t pixels = 0;
    robotlink::YCbCr color;
  };
  /// A counter per color, 2^21 in all; all counts are 0 between calls.
  std::vector<Place> places_;
  /// Indices of the counters that are not 0.
  std::vector<std::uint32_t> used_;
};

}  // namespace widgets
