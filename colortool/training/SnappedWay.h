// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "colortool/image/ColorImage.h"
#include "colortool/image/PixelArea.h"

namespace colortool {

/// The intended path of a careful brush: if the mouse slips off the thing that it follows, such as a thin
/// line of the field, the path stays on that, as far as the brush reaches. If nothing within reach is of
/// similar color, the mouse moves on to another thing, and so does the path. A plain value; one for each
/// stroke.
class SnappedWay {
 public:
  /// `radius` and `tolerance` as carefulBrushArea() has them.
  SnappedWay(const ColorImage& image, ImagePoint begin, double radius, double tolerance);

  /// Returns the pixels that the brush touches at its start.
  PixelArea begin(const ColorImage& image) const;
  /// Moves the brush to `to`. Returns the pixels of one image that it touches on the way.
  PixelArea moveTo(const ColorImage& image, ImagePoint to);

 private:
  using Color = std::array<double, 3>;
  ImagePoint snapped(const ColorImage& image, ImagePoint at);
  bool isLike(const ColorImage& image, int x, int y) const;

  double radius_, tolerance_;
  ImagePoint mouse_, meant_;
  Color mean_{};  ///< of the thing that it followed lately
  bool outside_ = false;
};

}  // namespace colortool
