// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace robotlink {

/// The layout of an image's pixels in memory.
enum class PixelFormat : std::uint8_t {
  /// YCbCr 4:2:2, bytes Y0 Cb Y1 Cr for every two pixels; the width is even.
  kYuyv,
  /// YCbCr 4:2:2, bytes Cb Y0 Cr Y1 for every two pixels; the width is even.
  kUyvy,
  /// YCbCr 4:2:0: rows of Y, then half as many rows of Cb Cr for each 2 x 2 pixels; width and height are
  /// even.
  kNv12,
  kRgb8,  ///< bytes R G B
  kBgr8,  ///< bytes B G R
  /// A byte per pixel: a gray value or a color class.
  kMono8,
};
/// All formats, to look one up by its encoding.
inline constexpr std::array kPixelFormats = {PixelFormat::kYuyv, PixelFormat::kUyvy, PixelFormat::kNv12,
                                             PixelFormat::kRgb8, PixelFormat::kBgr8, PixelFormat::kMono8};

/// Bytes per pixel in a row; for kNv12 in a row of Y.
constexpr int bytesPerPixel(PixelFormat format) {
  switch (format) {
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
      return 2;
    case PixelFormat::kRgb8:
    case PixelFormat::kBgr8:
      return 3;
    case PixelFormat::kNv12:
    case PixelFormat::kMono8:
      break;
  }
  return 1;
}
/// The number of rows of `step` bytes that an image of this height occupies.
constexpr int rowsOf(PixelFormat format, int height) {
  return format == PixelFormat::kNv12 ? height + height / 2 : height;
}
/// Whether an image can have this size: both sides are positive, and even where pixels share chroma.
constexpr bool canHaveSize(PixelFormat format, int width, int height) {
  const bool pairs =
      format == PixelFormat::kYuyv || format == PixelFormat::kUyvy || format == PixelFormat::kNv12;
  const bool even = (!pairs || width % 2 == 0) && (format != PixelFormat::kNv12 || height % 2 == 0);
  return width > 0 && height > 0 && even;
}

/// The name of the format in foxglove.RawImage.encoding: "yuyv", "rgb8", "mono8".
std::string_view encodingName(PixelFormat format);

/// A view of an image's pixels, top row first, rows `step` bytes apart. It owns nothing: the pixels must
/// outlive it.
struct ImageView {
  int width = 0;
  int height = 0;
  /// Bytes from the start of a row to the start of the next.
  int step = 0;
  PixelFormat format = PixelFormat::kMono8;
  const std::uint8_t* data = nullptr;

  const std::uint8_t* row(int y) const { return data + static_cast<std::ptrdiff_t>(y) * step; }
  /// The row of Cb Cr pairs for row y. Only for kNv12.
  const std::uint8_t* chromaRow(int y) const { return row(height + y / 2); }
  /// True if there is no pixel to read.
  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
};

/// An image that owns its pixels; rows without gaps, top row first.
struct Image {
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::kMono8;
  std::vector<std::uint8_t> data;

  /// An empty image.
  Image() = default;
  /// All bytes are 0.
  Image(int imageWidth, int imageHeight, PixelFormat imageFormat);
  int step() const { return width * bytesPerPixel(format); }
  std::uint8_t* row(int y) { return data.data() + static_cast<std::ptrdiff_t>(y) * step(); }
  const std::uint8_t* row(int y) const { return data.data() + static_cast<std::ptrdiff_t>(y) * step(); }
  ImageView view() const { return {width, height, step(), format, data.data()}; }
  bool operator==(const Image&) const = default;
};

/// A color as cameras deliver it: luma and two chroma channels, full range, chroma centered at 128.
struct YCbCr {
  std::uint8_t y = 0, cb = 128, cr = 128;
  bool operator==(const YCbCr&) const = default;
};
/// A color for displays and palettes, each channel 0..255.
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// Full-range BT.601, as in JPEG (JFIF 1.02). Clamped, and rounded to within 1 in fixed point, so that vector
/// code can compute the same; a round trip is exact to within 2.
constexpr YCbCr toYCbCr(Rgb color) {
  constexpr int kHalf = 1 << 14, kMiddle = (128 << 15) + kHalf;
  const int r = color.r, g = color.g, b = color.b;
  const int cb = (kMiddle - 5529 * r - 10855 * g + 16384 * b) >> 15;
  const int cr = (kMiddle + 16384 * r - 13720 * g - 2664 * b) >> 15;
  return {static_cast<std::uint8_t>((kHalf + 9798 * r + 19235 * g + 3735 * b) >> 15),
          static_cast<std::uint8_t>(cb < 255 ? cb : 255), static_cast<std::uint8_t>(cr < 255 ? cr : 255)};
}
/// The inverse of toYCbCr(), clamped to 0..255.
Rgb toRgb(YCbCr color);

/// The color of a pixel of a kYuyv image: its own Y and the chroma that it shares with its neighbor.
inline YCbCr yuyvPixel(const ImageView& image, int x, int y) {
  const std::uint8_t* pair = image.row(y) + std::ptrdiff_t{2} * (x & ~1);
  return {(x & 1) == 0 ? pair[0] : pair[2], pair[1], pair[3]};
}

/// The color of a pixel of any format; kMono8 gives gray.
YCbCr pixelYCbCr(const ImageView& image, int x, int y);
Rgb pixelRgb(const ImageView& image, int x, int y);

/// Converts an image of any format to kRgb8; kMono8 becomes gray.
Image toRgbImage(const ImageView& image);

}  // namespace robotlink
