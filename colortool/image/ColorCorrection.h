// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "robotlink/base/Image.h"

namespace colortool {

/// How the colors of a camera's image change from its center outwards: lenses darken the corners and tint
/// them. With r^2 the squared distance from the image center, scaled to 1 at the corners, Y is divided by 1 +
/// luma[0] r^2 + luma[1] r^4; blue[0] r^2 + blue[1] r^4 is subtracted from Cb, and the same with `red` from
/// Cr.
struct Vignetting {
  /// Coefficients of r^2 and r^4; all 0: no vignetting.
  std::array<double, 2> luma{}, blue{}, red{};
  bool operator==(const Vignetting&) const = default;
};

/// A linear map of one channel of a camera to that of the reference camera: other = gain * value + offset.
struct ChannelLine {
  /// Factor without unit.
  double gain = 1;
  /// In values of the channel, 0 to 255.
  double offset = 0;
  /// The mapped value, neither rounded nor clamped.
  double of(double value) const { return gain * value + offset; }
  bool operator==(const ChannelLine&) const = default;
};

/// The correction of a camera's colors that precedes the look-up in a table: vignetting is removed, then each
/// channel is mapped linearly. A plain value; the default changes nothing.
struct ColorCorrection {
  /// The range of the shade, by which Y is divided to remove vignetting.
  static constexpr double kMinShade = 0.125, kMaxShade = 8;
  /// The limits of the gain and the offset that are applied to a channel at any place, so that ImageCorrector
  /// can do the same in integers.
  static constexpr double kMaxGain = 15, kMaxOffset = 1000;

  Vignetting vignetting;
  /// Y, Cb, Cr.
  std::array<ChannelLine, 3> channels{};

  /// Whether the correction changes nothing.
  bool none() const { return *this == ColorCorrection{}; }
  /// Whether all coefficients are finite. Others must not be applied.
  bool isFinite() const;
  /// Returns the corrected color of a pixel at (x, y) of an image of that size, rounded and within 0 to 255.
  robotlink::YCbCr apply(robotlink::YCbCr color, int x, int y, int width, int height) const;
  /// The whole correction of a channel at a squared distance from the image center (see
  /// squaredImageRadius()).
  ChannelLine lumaAt(double squaredRadius) const;
  ChannelLine blueAt(double squaredRadius) const;
  ChannelLine redAt(double squaredRadius) const;
  bool operator==(const ColorCorrection&) const = default;
};

/// The r^2 of Vignetting at a point of an image, 1 at the corners. The center of the upper left pixel is (0,
/// 0).
double squaredImageRadius(double x, double y, int width, int height);

}  // namespace colortool
