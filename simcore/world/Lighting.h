// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace simcore {

/// How the light that cameras see differs from that of the scene's file: lamps, ambient light and background
/// alike. A plain value; as it is made, nothing differs.
struct Lighting {
  double brightness = 1;  ///< times the scene's; 0 to kMostBrightness
  /// -1 to 1. Above 0 the light lacks this share of blue and half of it of green, as that of bulbs; below 0
  /// it lacks red and half as much of green, as that of the sky.
  double warmth = 0;

  static constexpr double kMostBrightness = 10;
  bool operator==(const Lighting&) const = default;
};

}  // namespace simcore
