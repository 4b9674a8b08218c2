// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Image.h"

#include <algorithm>
#include <cmath>

namespace robotlink {
namespace {

std::uint8_t clampToByte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

Rgb pixelAsRgb(const ImageView& image, int x, int y) {
  switch (image.format) {
    case PixelFormat::kYuyv:
      return toRgb(yuyvPixel(image, x, y));
    case PixelFormat::kRgb8: {
      const std::uint8_t* p = image.row(y) + std::ptrdiff_t{3} * x;
      return {p[0], p[1], p[2]};
    }
    case PixelFormat::kMono8:
      break;
  }
  const std::uint8_t grey = image.row(y)[x];
  return {grey, grey, grey};
}

}  // namespace

std::string_view encodingName(PixelFormat format) {
  switch (format) {
    case PixelFormat::kYuyv:
      return "yuyv";
    case PixelFormat::kRgb8:
      return "rgb8";
    case PixelFormat::kMono8:
      break;
  }
  return "mono8";
}

Image::Image(int imageWidth, int imageHeight, PixelFormat imageFormat)
    : width(imageWidth),
      height(imageHeight),
      format(imageFormat),
      data(static_cast<std::size_t>(imageWidth) * static_cast<std::size_t>(imageHeight) *
           static_cast<std::size_t>(bytesPerPixel(imageFormat))) {}

YCbCr toYCbCr(Rgb c) {
  const double r = c.r, g = c.g, b = c.b;
  return {clampToByte(0.299 * r + 0.587 * g + 0.114 * b),
          clampToByte(128 - 0.168736 * r - 0.331264 * g + 0.5 * b),
          clampToByte(128 + 0.5 * r - 0.418688 * g - 0.081312 * b)};
}

Rgb toRgb(YCbCr c) {
  const double y = c.y, cb = c.cb - 128.0, cr = c.cr - 128.0;
  return {clampToByte(y + 1.402 * cr), clampToByte(y - 0.344136 * cb - 0.714136 * cr),
          clampToByte(y + 1.772 * cb)};
}

Image toRgbImage(const ImageView& image) {
  Image result(image.width, image.height, PixelFormat::kRgb8);
  for (int y = 0; y < image.height; ++y) {
    std::uint8_t* out = result.row(y);
    for (int x = 0; x < image.width; ++x, out += 3) {
      const Rgb color = pixelAsRgb(image, x, y);
      out[0] = color.r;
      out[1] = color.g;
      out[2] = color.b;
    }
  }
  return result;
}

}  // namespace robotlink
