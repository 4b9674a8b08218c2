// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace robotlink {

enum class PixelFormat : std::uint8_t {
  kYuyv,   ///< YCbCr 4:2:2, bytes Y0 Cb Y1 Cr for each two pixels; the width is even
  kRgb8,   ///< bytes R G B
  kMono8,  ///< one byte: a grey value or a class
};

constexpr int bytesPerPixel(PixelFormat format) {
  return format == PixelFormat::kRgb8 ? 3 : format == PixelFormat::kYuyv ? 2 : 1;
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

/// Full-range BT.601, as JPEG has it (JFIF 1.02). Rounded and clamped; there and back to within 2.
YCbCr toYCbCr(Rgb color);
Rgb toRgb(YCbCr color);

/// The colour of a pixel of a Yuyv image, with the Y of that very pixel.
inline YCbCr yuyvPixel(const ImageView& image, int x, int y) {
  const std::uint8_t* pair = image.row(y) + std::ptrdiff_t{2} * (x & ~1);
  return {(x & 1) == 0 ? pair[0] : pair[2], pair[1], pair[3]};
}

/// Any format to Rgb8 (kMono8 as grey).
Image toRgbImage(const ImageView& image);

}  // namespace robotlink
