// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <optional>
#include <span>

#include "robotlink/base/Image.h"
#include "widgets/image/ImagePixels.h"

namespace foxglove {
class RawImage;
}

namespace widgets {

/// Converts an image of any encoding for display; null if its encoding is unknown or its data do not fit.
/// Depths (32FC1 in m, 16UC1 in mm) are gray from near (bright) to far, brightnesses of 16 bits (mono16) from
/// dark to bright, both scaled to the lowest and the highest value in the image. What is no depth (NaN,
/// infinite, 0 mm) is black. Everything else is drawn by toQImage(). Pure; any thread.
QImage rawPicture(const foxglove::RawImage& image, std::span<const robotlink::Rgb> classColors = {});

/// A pixel of such an image; unset outside of it. The colors of depths and mono16 are left out.
std::optional<PixelValue> rawPixel(const foxglove::RawImage& image, int x, int y);

}  // namespace widgets
