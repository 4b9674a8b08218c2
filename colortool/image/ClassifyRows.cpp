// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/image/ClassifyRows.h"

#include <cstddef>

namespace colortool {
namespace {

using robotlink::PixelFormat;

constexpr std::size_t chromaIndex(std::uint8_t cb, std::uint8_t cr) {
  return (static_cast<std::size_t>(cb >> 2) << 6U) | static_cast<std::size_t>(cr >> 2);
}
constexpr std::size_t brightnessIndex(std::uint8_t y) {
  return static_cast<std::size_t>(y >> 2) << 12U;
}

/// The template arguments are the positions of luma and chroma in the four bytes of a pair of pixels.
template <int y0, int cb, int y1, int cr>
void classifyPairs(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes) {
  const std::uint8_t* pair = row.pixels;
  for (int x = 0; x + 1 < row.width; x += 2, pair += 4) {
    const std::size_t chroma = chromaIndex(pair[cb], pair[cr]);
    classes[x] = cells[brightnessIndex(pair[y0]) | chroma];
    classes[x + 1] = cells[brightnessIndex(pair[y1]) | chroma];
  }
}

void classifyNv12(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes) {
  for (int x = 0; x + 1 < row.width; x += 2) {
    const std::size_t chroma = chromaIndex(row.chroma[x], row.chroma[x + 1]);
    classes[x] = cells[brightnessIndex(row.pixels[x]) | chroma];
    classes[x + 1] = cells[brightnessIndex(row.pixels[x + 1]) | chroma];
  }
}

template <int r, int g, int b>
void classifyTriples(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes) {
  const std::uint8_t* pixel = row.pixels;
  for (int x = 0; x < row.width; ++x, pixel += 3) {
    const robotlink::YCbCr color = robotlink::toYCbCr({pixel[r], pixel[g], pixel[b]});
    classes[x] = cells[brightnessIndex(color.y) | chromaIndex(color.cb, color.cr)];
  }
}

}  // namespace

ClassifyRow plainClassifyRow(PixelFormat format) {
  switch (format) {
    case PixelFormat::kYuyv:
      return classifyPairs<0, 1, 2, 3>;
    case PixelFormat::kUyvy:
      return classifyPairs<1, 0, 3, 2>;
    case PixelFormat::kNv12:
      return classifyNv12;
    case PixelFormat::kRgb8:
      return classifyTriples<0, 1, 2>;
    case PixelFormat::kBgr8:
      return classifyTriples<2, 1, 0>;
    case PixelFormat::kMono8:
      break;
  }
  return nullptr;
}

}  // namespace colortool
