// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/Image.h"

#include <algorithm>
#include <cmath>

namespace robotlink {
namespace {

std::uint8_t clampToByte(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

}  // namespace

std::string_view encodingName(PixelFormat format) {
  switch (format) {
    case PixelFormat::kYuyv:
      return "yuyv";
    case PixelFormat::kUyvy:
      return "uyvy";
    case PixelFormat::kNv12:
      return "nv12";
    case PixelFormat::kRgb8:
      return "rgb8";
    case PixelFormat::kBgr8:
      return "bgr8";
    case PixelFormat::kMono8:
      break;
  }
  return "mono8";
}

Image::Image(int imageWidth, int imageHeight, PixelFormat imageFormat)
    : width(imageWidth),
      height(imageHeight),
      format(imageFormat),
      data(static_cast<std::size_t>(imageWidth) * static_cast<std::size_t>(rowsOf(imageFormat, imageHeight)) *
           static_cast<std::size_t>(bytesPerPixel(imageFormat))) {}

Rgb toRgb(YCbCr c) {
  const double y = c.y, cb = c.cb - 128.0, cr = c.cr - 128.0;
  return {clampToByte(y + 1.402 * cr), clampToByte(y - 0.344136 * cb - 0.714136 * cr),
          clampToByte(y + 1.772 * cb)};
}

YCbCr pixelYCbCr(const ImageView& image, int x, int y) {
  const std::uint8_t* row = image.row(y);
  const std::ptrdiff_t pair = x & ~1;
  switch (image.format) {
    case PixelFormat::kYuyv:
      return yuyvPixel(image, x, y);
    case PixelFormat::kUyvy:
      row += 2 * pair;
      return {(x & 1) == 0 ? row[1] : row[3], row[0], row[2]};
    case PixelFormat::kNv12:
      return {row[x], image.chromaRow(y)[pair], image.chromaRow(y)[pair + 1]};
    case PixelFormat::kRgb8:
    case PixelFormat::kBgr8:
      return toYCbCr(pixelRgb(image, x, y));
    case PixelFormat::kMono8:
      break;
  }
  return {row[x], 128, 128};
}

Rgb pixelRgb(const ImageView& image, int x, int y) {
  const std::uint8_t* row = image.row(y);
  const std::ptrdiff_t at = x;
  switch (image.format) {
    case PixelFormat::kRgb8:
      return {row[3 * at], row[3 * at + 1], row[3 * at + 2]};
    case PixelFormat::kBgr8:
      return {row[3 * at + 2], row[3 * at + 1], row[3 * at]};
    case PixelFormat::kMono8:
      return {row[x], row[x], row[x]};
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
    case PixelFormat::kNv12:
      break;
  }
  return toRgb(pixelYCbCr(image, x, y));
}

Image toRgbImage(const ImageView& image) {
  Image result(image.width, image.height, PixelFormat::kRgb8);
  for (int y = 0; y < image.height; ++y) {
    std::uint8_t* out = result.row(y);
    for (int x = 0; x < image.width; ++x, out += 3) {
      const Rgb color = pixelRgb(image, x, y);
      out[0] = color.r;
      out[1] = color.g;
      out[2] = color.b;
    }
  }
  return result;
}

}  // namespace robotlink
