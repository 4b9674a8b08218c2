// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/LensShading.h"

#include <algorithm>

namespace simcore::rendering {
namespace {

// The coefficients of robotlink::toYCbCr and its inverse, chroma without its offset.
constexpr float kBlueOfYCbCr[3] = {1, 1.772F, 0}, kBlueInYCbCr[3] = {0.114F, 0.5F, -0.081312F};
constexpr float kBlueOfRgb[3] = {0, 0, 1}, kBlueInRgb[3] = {0, 0, 1};

}  // namespace

LensShading::LensShading(const CameraModel& camera, robotlink::PixelFormat format)
    : width_(camera.width),
      centerX_(static_cast<float>(camera.width) / 2 - 0.5F),
      centerY_(static_cast<float>(camera.height) / 2 - 0.5F),
      inverseSquaredCorner_(4 /
                            static_cast<float>(camera.width * camera.width + camera.height * camera.height)),
      falloff_(static_cast<float>(camera.vignetting.falloff)),
      tint_(static_cast<float>(camera.vignetting.tint)) {
  const bool luma = format == robotlink::PixelFormat::kYuyv;
  std::copy_n(luma ? kBlueOfYCbCr : kBlueOfRgb, 3, blueOf_);
  std::copy_n(luma ? kBlueInYCbCr : kBlueInRgb, 3, blue_);
}

void LensShading::apply(Strip& strip, int stride) const {
  for (int i = 0; i < strip.rows; ++i) {
    const int at = i * stride;
    const float dy = static_cast<float>(strip.firstRow + i) - centerY_;
    for (int x = 0; x < width_; ++x) {
      const float dx = static_cast<float>(x) - centerX_;
      const float r2 = (dx * dx + dy * dy) * inverseSquaredCorner_;
      strip.light[at + x] *= 1 - falloff_ * r2;
      // Red and green lose a fraction: the whole color loses it, and its blue component is added back.
      const float loss = tint_ * r2;
      float* const channel[3] = {strip.color[0] + at + x, strip.color[1] + at + x, strip.color[2] + at + x};
      const float blue = *channel[0] * blueOf_[0] + *channel[1] * blueOf_[1] + *channel[2] * blueOf_[2];
      for (int k = 0; k < 3; ++k) *channel[k] = *channel[k] * (1 - loss) + blue * blue_[k] * loss;
    }
  }
}

}  // namespace simcore::rendering
