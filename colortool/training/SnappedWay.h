// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "colortool/image/ColorImage.h"
#include "colortool/image/PixelArea.h"

namespace colortool {

/// The way of a careful brush as it was meant: where the mouse slips off what it is led along, such as a thin
/// line of the field, the way stays on that, as far as the brush reaches. Where nothing within reach is of
/// similar color the mouse moves on to something else, and so does the way. A plain value; one for each
/// stroke.
class SnappedWay {
 public:
  /// `radius` and `tolerance` as carefulBrushArea() has them.
  SnappedWay(const ColorImage& image, ImagePoint begin, double radius, double tolerance);

  /// What the brush touches at its beginning.
  PixelArea begin(const ColorImage& image) const;
  /// What it touches between where it was and `to`, by pixels of one image.
  PixelArea moveTo(const ColorImage& image, ImagePoint to);

 private:
  using Color = std::array<double, 3>;
  ImagePoint snapped(const ColorImage& image, ImagePoint at);
  bool isLike(const ColorImage& image, int x, int y) const;

  double radius_, tolerance_;
  ImagePoint mouse_, meant_;
  Color mean_{};  ///< of what it was led along lately
  bool outside_ = false;
};

}  // namespace colortool
