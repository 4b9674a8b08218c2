// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "robotlink/base/Image.h"

namespace colortool {

/// A row of pixels in the layout of ImageView. The pointers are not owned.
struct PixelRow {
  /// First byte of the row; for kNv12 the row of Y values.
  const std::uint8_t* pixels = nullptr;
  /// Only for kNv12: the Cb Cr pairs that the row shares with its neighbor.
  const std::uint8_t* chroma = nullptr;
  /// Pixels.
  int width = 0;
};

/// Writes the class of each pixel of a row to `classes`, which has room for `row.width` bytes. `cells` must
/// have kCellPadding readable bytes behind its end, since vector code reads four bytes at each cell.
using ClassifyRow = void (*)(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes);
/// Bytes that must be readable behind the last cell.
constexpr int kCellPadding = 3;

/// Returns the portable version; null for formats without color (kMono8).
ClassifyRow plainClassifyRow(robotlink::PixelFormat format);
/// Returns the version for AVX2, which yields the same results; null if the processor lacks AVX2 or the
/// format has no color.
ClassifyRow avx2ClassifyRow(robotlink::PixelFormat format);

}  // namespace colortool
