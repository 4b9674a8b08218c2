// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <optional>
#include <span>
#include <string>

#include "robotlink/base/Image.h"

namespace widgets {

/// An image as Qt paints it, Format_RGB32. `into` is used again where its size fits, so that a stream of
/// images costs no memory. YCbCr is converted by tables, about 0.1 ms for 176 x 144 pixels. `classColors`: a
/// kMono8 image holds classes and is shown in these colours; values past its end are black. Empty: grey
/// values. Pure; any thread.
QImage toQImage(const robotlink::ImageView& image, std::span<const robotlink::Rgb> classColors = {},
                QImage into = {});

/// One pixel, as a person reads it.
struct PixelValue {
  int x = 0;
  int y = 0;
  robotlink::Rgb rgb;
  std::optional<robotlink::YCbCr> ycbcr;  ///< only of images that have it
  std::optional<int> value;               ///< only of kMono8: grey value or class
};

/// Nothing outside of the image.
std::optional<PixelValue> pixelAt(const robotlink::ImageView& image, int x, int y);
/// "x 12  y 34   Y 120  Cb 90  Cr 200   #ff6900". `className` is appended unless it is empty.
QString describe(const PixelValue& pixel, const std::string& className = {});

}  // namespace widgets
