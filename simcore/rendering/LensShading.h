// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Image.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/CameraModel.h"

namespace simcore::rendering {

/// Applies a camera's vignetting to strips that are lit but not yet written. Plain code, so the result does
/// not depend on how the kernels are compiled. A plain value for one image.
class LensShading {
 public:
  LensShading(const CameraModel& camera, robotlink::PixelFormat format);

  /// Whether it has any effect.
  bool any() const { return falloff_ != 0 || tint_ != 0; }
  /// Changes light and color of a strip's pixels.
  void apply(Strip& strip, int stride) const;

 private:
  int width_;
  /// The image's center, in coordinates of pixels' centers.
  float centerX_, centerY_;
  /// 1 / squared distance from the center to a corner.
  float inverseSquaredCorner_;
  float falloff_, tint_;
  /// The blue component of a color is its scalar product with this.
  float blueOf_[3];
  /// The channels of pure blue.
  float blue_[3];
};

}  // namespace simcore::rendering
