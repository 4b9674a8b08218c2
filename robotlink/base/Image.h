// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace robotlink {

enum class PixelFormat : std::uint8_t {
  kYuyv,   ///< YCbCr 4:2:2, bytes Y0 Cb Y1 Cr for each two pixels; the width is even
  kUyvy,   ///< the same as Cb Y0 Cr Y1
  kNv12,   ///< YCbCr 4:2:0: rows of Y, then half as many rows of Cb Cr for each 2 x 2 pixels; both sides are
           ///< even
  kRgb8,   ///< bytes R G B
  kBgr8,   ///< bytes B G R
  kMono8,  ///< one byte: a grey value or a class
};
inline constexpr std::array kPixelFormats = {PixelFormat::kYuyv, PixelFormat::kUyvy, PixelFormat::kNv12,
                                             PixelFormat::kRgb8, PixelFormat::kBgr8, PixelFormat::kMono8};

/// In a row; of kNv12 in a row of Y.
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
/// How many rows of `step` bytes hold an image of that height.
constexpr int rowsOf(PixelFormat format, int height) {
  return format == PixelFormat::kNv12 ? height + height / 2 : height;
}
/// Whether an image can have that size: both positive, and even where chroma is shared.
constexpr bool canHaveSize(PixelFormat format, int width, int height) {
  const bool pairs =
      format == PixelFormat::kYuyv || format == PixelFormat::kUyvy || format == PixelFormat::kNv12;
  const bool even = (!pairs || width % 2 == 0) && (format != PixelFormat::kNv12 || height % 2 == 0);
  return width > 0 && height > 0 && even;
}

/// The name that foxglove.RawImage.encoding has for a format: "yuyv", "rgb8", "mono8".
std::string_view encodingName(PixelFormat format);

/// Pixels that belong to somebody else, top row first, rows `step` bytes apart.
struct ImageView {
  int width = 0;
  int height = 0;
  int step = 0;  ///< bytes
  PixelFormat format = PixelFormat::kMono8;
  const std::uint8_t* data = nullptr;

  const std::uint8_t* row(int y) const { return data + static_cast<std::ptrdiff_t>(y) * step; }
  /// The row of Cb Cr pairs that belongs to row y. For kNv12 only.
  const std::uint8_t* chromaRow(int y) const { return row(height + y / 2); }
  bool empty() const { return data == nullptr || width <= 0 || height <= 0; }
};

/// Pixels of its own, rows without gaps.
struct Image {
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::kMono8;
  std::vector<std::uint8_t> data;

  Image() = default;
  Image(int imageWidth, int imageHeight, PixelFormat imageFormat);
  int step() const { return width * bytesPerPixel(format); }
  std::uint8_t* row(int y) { return data.data() + static_cast<std::ptrdiff_t>(y) * step(); }
  const std::uint8_t* row(int y) const { return data.data() + static_cast<std::ptrdiff_t>(y) * step(); }
  ImageView view() const { return {width, height, step(), format, data.data()}; }
  bool operator==(const Image&) const = default;
};

struct YCbCr {
  std::uint8_t y = 0, cb = 128, cr = 128;
  bool operator==(const YCbCr&) const = default;
};
struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  bool operator==(const Rgb&) const = default;
};

/// Full-range BT.601, as JPEG has it (JFIF 1.02). Clamped, and rounded to within 1 in fixed point, so that
/// vector code can do the same; there and back to within 2.
constexpr YCbCr toYCbCr(Rgb color) {
  constexpr int kHalf = 1 << 14, kMiddle = (128 << 15) + kHalf;
  const int r = color.r, g = color.g, b = color.b;
  const int cb = (kMiddle - 5529 * r - 10855 * g + 16384 * b) >> 15;
  const int cr = (kMiddle + 16384 * r - 13720 * g - 2664 * b) >> 15;
  return {static_cast<std::uint8_t>((kHalf + 9798 * r + 19235 * g + 3735 * b) >> 15),
          static_cast<std::uint8_t>(cb < 255 ? cb : 255), static_cast<std::uint8_t>(cr < 255 ? cr : 255)};
}
Rgb toRgb(YCbCr color);

/// The colour of a pixel of a Yuyv image, with the Y of that very pixel.
inline YCbCr yuyvPixel(const ImageView& image, int x, int y) {
  const std::uint8_t* pair = image.row(y) + std::ptrdiff_t{2} * (x & ~1);
  return {(x & 1) == 0 ? pair[0] : pair[2], pair[1], pair[3]};
}

/// The colour of a pixel of any format, with the Y of that very pixel; kMono8 is grey.
YCbCr pixelYCbCr(const ImageView& image, int x, int y);
Rgb pixelRgb(const ImageView& image, int x, int y);

/// Any format to Rgb8 (kMono8 as grey).
Image toRgbImage(const ImageView& image);

}  // namespace robotlink
