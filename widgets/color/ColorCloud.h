// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "robotlink/base/Image.h"

namespace widgets {

/// Pixels of an image that have nearly the same colour.
struct CloudPoint {
  robotlink::YCbCr color;  ///< of one of them
  std::uint32_t pixels = 0;
};

/// The colours of an image, each once. Immutable.
struct ColorCloud {
  std::vector<CloudPoint> points;

  /// How many pixels of the image are in a cell of the colour table.
  std::size_t pixelsIn(std::size_t cell) const;
};

/// Counts colours to within two values of a channel, so that there are eight points a cell at most. Some 8 ns
/// a pixel; keeps 16 MB for the next image. One thread.
class CloudMaker {
 public:
  std::shared_ptr<const ColorCloud> cloudOf(const robotlink::ImageView& image);

 private:
  struct Place {
    std::uint32_t pixels = 0;
    robotlink::YCbCr color;
  };
  std::vector<Place> places_;
  std::vector<std::uint32_t> used_;
};

}  // namespace widgets
