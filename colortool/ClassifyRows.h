// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "robotlink/base/Image.h"

namespace colortool {

/// A row of pixels, as ImageView has it.
struct PixelRow {
  const std::uint8_t* pixels = nullptr;
  const std::uint8_t* chroma = nullptr;  ///< of kNv12 the pairs Cb Cr
  int width = 0;
};

/// Looks up the class of each pixel of a row. `cells` has kCellPadding readable bytes behind it.
using ClassifyRow = void (*)(const std::uint8_t* cells, const PixelRow& row, std::uint8_t* classes);
constexpr int kCellPadding = 3;

/// In plain C++. Null for formats without colours (kMono8).
ClassifyRow plainClassifyRow(robotlink::PixelFormat format);
/// With AVX2, to the same results; null where the processor lacks it.
ClassifyRow avx2ClassifyRow(robotlink::PixelFormat format);

}  // namespace colortool
