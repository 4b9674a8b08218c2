// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Image.h"
#include "simcore/rendering/KernelTypes.h"
#include "simcore/world/CameraModel.h"

namespace simcore::rendering {

/// Applies a camera's vignetting to strips that are lit and not yet written: plain code, so that it is the
/// same whatever the kernels are compiled for. A plain value, for one image.
class LensShading {
 public:
  LensShading(const CameraModel& camera, robotlink::PixelFormat format);

  /// Whether it changes anything.
  bool any() const { return falloff_ != 0 || tint_ != 0; }
  void apply(Strip& strip, int stride) const;

 private:
  int width_;
  float centerX_, centerY_;     // pixels, of pixels' centres
  float inverseSquaredCorner_;  // 1 / squared distance from the centre to a corner
  float falloff_, tint_;
  float blueOf_[3];  // a colour's blue, as a product with its channels
  float blue_[3];    // the channels of blue alone
};

}  // namespace simcore::rendering
