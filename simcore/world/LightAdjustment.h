// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace simcore {

/// How the light in camera images differs from that of the scene's file: lamps, ambient light and background
/// alike; and what the camera makes of it. A plain value; the default changes nothing.
struct LightAdjustment {
  /// A factor, 0 to kMaxBrightness.
  double brightness = 1;
  /// In -1 to 1. Above 0 the light lacks this fraction of blue and half of it of green, as of bulbs; below 0
  /// it lacks red and half as much green, as of the sky.
  double warmth = 0;
  /// The warmth of the light that the camera takes for white, in -kMaxWhiteBalance to kMaxWhiteBalance: where
  /// it is that of the light, colors are as in white light.
  double whiteBalance = 0;

  /// The upper limit of brightness.
  static constexpr double kMaxBrightness = 10;
  static constexpr double kMaxWhiteBalance = 0.8;
  bool operator==(const LightAdjustment&) const = default;
};

}  // namespace simcore
