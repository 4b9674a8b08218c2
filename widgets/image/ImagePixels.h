// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <optional>
#include <span>
#include <string>

#include "robotlink/base/Image.h"

namespace widgets {

/// Converts an image to Format_RGB32. `into` is reused if its size fits, so that a stream of images allocates
/// nothing. YCbCr is converted by tables, about 0.1 ms for 176 x 144 pixels. With `classColors` a kMono8
/// image contains class numbers and is shown in these colors, numbers past the end in black; without, gray
/// values. Pure; any thread.
QImage toQImage(const robotlink::ImageView& image, std::span<const robotlink::Rgb> classColors = {},
                QImage into = {});

/// A pixel as the user reads it.
struct PixelValue {
  /// Position in the image, pixels.
  int x = 0;
  int y = 0;
  /// Its color as it is shown.
  robotlink::Rgb rgb;
  /// Only of images in YCbCr.
  std::optional<robotlink::YCbCr> ycbcr;
  /// Only of kMono8 and mono16: the gray value or class number.
  std::optional<int> value;
  /// Only of depths: m; NaN: none was measured.
  std::optional<double> depth = {};
};

/// Unset outside of the image.
std::optional<PixelValue> pixelAt(const robotlink::ImageView& image, int x, int y);
/// "x 12  y 34   Y 120  Cb 90  Cr 200   #ff6900", followed by `className` unless it is empty.
QString describe(const PixelValue& pixel, const std::string& className = {});

}  // namespace widgets
