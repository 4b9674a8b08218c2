// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "robotlink/base/Geometry.h"

namespace simcore {

/// The darkening of an image toward its corners by the lens, as by the lens of a real Aibo. With r the
/// distance from the center (1 in the corners), all light is multiplied by 1 - falloff * r^2, and red and
/// green also by 1 - tint * r^2, which makes the corners bluish.
struct LensVignetting {
  /// From 0 to 1.
  double falloff = 0;
  /// From 0 to 1.
  double tint = 0;
  bool operator==(const LensVignetting&) const = default;
};

/// The distortion of a lens after Brown and Conrady, as in SDFormat and OpenCV. A point that a pinhole camera
/// shows at (x, y) = (tan of its angles), x to the right and y down, appears at (x, y) * (1 + k1 r^2 + k2 r^4
/// + k3 r^6) + (2 p1 x y + p2 (r^2 + 2 x^2), p1 (r^2 + 2 y^2) + 2 p2 x y), r^2 = x^2 + y^2.
struct LensDistortion {
  double k1 = 0, k2 = 0, k3 = 0, p1 = 0, p2 = 0;
  bool any() const { return k1 != 0 || k2 != 0 || k3 != 0 || p1 != 0 || p2 != 0; }
  bool operator==(const LensDistortion&) const = default;
};

/// When the rows of an image are exposed. The instant of the image is the end of the exposure of its last
/// row.
struct ShutterModel {
  /// For how long each row is exposed, s: what moves meanwhile is blurred.
  double exposure = 0;
  /// The time from the end of the first row to that of the last one, s; 0 is a global shutter.
  double readout = 0;
  static constexpr double kMaxTime = 0.1;
  bool any() const { return exposure > 0 || readout > 0; }
  bool operator==(const ShutterModel&) const = default;
};

/// A pinhole camera with a lens. It looks along the x-axis of its frame; y points to the left, z up.
/// The optical axis meets the image at its center (width / 2, height / 2); pixel (0, 0) covers [0, 1) x [0,
/// 1).
struct CameraModel {
  // Pixels.
  int width = 176;
  int height = 144;
  /// Full fields of view, rad.
  double horizontalAngle = robotlink::radians(57.6);
  double verticalAngle = robotlink::radians(47.8);
  LensVignetting vignetting = {};
  LensDistortion distortion = {};
  bool operator==(const CameraModel&) const = default;
};

/// The noise added to every channel of every pixel. It is computed from counters, so the same (seed, stream,
/// frame) gives the same bytes.
struct ImageNoise {
  /// Standard deviation in gray values.
  double sigma = 0;
  std::uint64_t seed = 0;
  /// The stream of random numbers, one per camera.
  std::uint64_t stream = 0;
  /// Number of the image.
  std::uint64_t frame = 0;
  bool operator==(const ImageNoise&) const = default;
};

}  // namespace simcore
