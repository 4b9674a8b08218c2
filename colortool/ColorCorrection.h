// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "robotlink/base/Image.h"

namespace colortool {

/// How a camera's image differs from the middle of itself: lenses darken corners and tint them. With r^2 =
/// squared distance from the image's centre, 1 at the corners:
/// Y is divided by 1 + luma[0] r^2 + luma[1] r^4; of Cb and Cr blue[0] r^2 + blue[1] r^4 and red[...] is
/// taken away.
struct Vignetting {
  std::array<double, 2> luma{}, blue{}, red{};
  bool operator==(const Vignetting&) const = default;
};

/// One channel of a camera against that of another: other = gain * value + offset.
struct ChannelLine {
  double gain = 1;
  double offset = 0;
  double of(double value) const { return gain * value + offset; }
  bool operator==(const ChannelLine&) const = default;
};

/// What is done to the colours of a camera before a table sees them: vignetting is taken out, then each
/// channel (Y, Cb, Cr) goes through its line. A plain value; by default nothing is changed.
struct ColorCorrection {
  /// What vignetting divides Y by stays within these.
  static constexpr double kMinShade = 0.125, kMaxShade = 8;
  /// What is done to a channel at any place has no larger gain or offset than these, so that ImageCorrector
  /// can do the same in integers.
  static constexpr double kMaxGain = 15, kMaxOffset = 1000;

  Vignetting vignetting;
  std::array<ChannelLine, 3> channels{};

  bool none() const { return *this == ColorCorrection{}; }
  /// Whether all are numbers; what is not must not be applied.
  bool isFinite() const;
  /// Returns the corrected color of a pixel at (x, y) of an image of that size, rounded and within 0 to 255.
  robotlink::YCbCr apply(robotlink::YCbCr color, int x, int y, int width, int height) const;
  /// All that is done to a channel at a distance from the centre of the image.
  ChannelLine lumaAt(double squaredRadius) const;
  ChannelLine blueAt(double squaredRadius) const;
  ChannelLine redAt(double squaredRadius) const;
  bool operator==(const ColorCorrection&) const = default;
};

/// The r^2 of Vignetting at a place of an image; the centre of the upper left pixel is at (0, 0).
double squaredImageRadius(double x, double y, int width, int height);

}  // namespace colortool
