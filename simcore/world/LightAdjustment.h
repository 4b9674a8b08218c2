// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace simcore {

/// How the light in camera images differs from that of the scene's file: lamps, ambient light and background
/// alike. A plain value; the default changes nothing.
struct LightAdjustment {
  /// A factor, 0 to kMaxBrightness.
  double brightness = 1;
  /// In -1 to 1. Above 0 the light lacks this fraction of blue and half of it of green, as of bulbs; below 0
  /// it lacks red and half as much green, as of the sky.
  double warmth = 0;

  /// The upper limit of brightness.
  static constexpr double kMaxBrightness = 10;
  bool operator==(const LightAdjustment&) const = default;
};

}  // namespace simcore
