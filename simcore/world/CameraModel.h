// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// The darkening of an image towards its corners by the lens, as by the lens of a real Aibo. With r the
/// distance from the center (1 in the corners), all light is multiplied by 1 - falloff * r^2, and red and
/// green also by 1 - tint * r^2, which makes the corners bluish.
struct LensVignetting {
  /// From 0 to 1.
  double falloff = 0;
  /// From 0 to 1.
  double tint = 0;
  bool operator==(const LensVignetting&) const = default;
};

/// A pinhole camera without distortion. It looks along the x-axis of its frame; y points to the left, z up.
/// The optical axis meets the image at its center (width / 2, height / 2); pixel (0, 0) covers [0, 1) x [0,
/// 1).
struct CameraModel {
  // Pixels.
  int width = 176;
  int height = 144;
  /// Full opening angles, rad.
  double horizontalAngle = robotlink::radians(57.6);
  double verticalAngle = robotlink::radians(47.8);
  LensVignetting vignetting = {};
};

/// The noise added to every channel of every pixel. It is computed from counters, so the same (seed, stream,
/// frame) gives the same bytes.
struct ImageNoise {
  /// Standard deviation in gray values.
  double sigma = 0;
  std::uint64_t seed = 0;
  /// One per camera.
  std::uint64_t stream = 0;
  /// Number of the image.
  std::uint64_t frame = 0;
};

}  // namespace simcore
