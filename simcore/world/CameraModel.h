// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// What a lens lets through less and less from the image's centre to its corners, as that of a real Aibo
/// does. With r the distance from the centre, 1 in the corners, all light is multiplied by 1 - falloff * r^2,
/// and red and green by 1 - tint * r^2 besides, which makes the corners bluish.
struct Vignetting {
  double falloff = 0;  ///< 0 to 1
  double tint = 0;     ///< 0 to 1
  bool operator==(const Vignetting&) const = default;
};

/// A pinhole camera without distortion. It looks along its frame's x-axis; y is to the left, z up. The
/// optical axis pierces the image at its centre (width / 2, height / 2), with pixel (0, 0) covering [0, 1) x
/// [0, 1).
struct CameraModel {
  int width = 176;
  int height = 144;
  double horizontalAngle = robotlink::radians(57.6);  ///< opening angle, rad
  double verticalAngle = robotlink::radians(47.8);
  Vignetting vignetting = {};
};

/// Noise added to every channel of every pixel: counter-based, so the same (seed, stream, frame) gives the
/// same bytes.
struct ImageNoise {
  double sigma = 0;  ///< standard deviation, grey values
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;  ///< one per camera
  std::uint64_t frame = 0;
};

}  // namespace simcore
