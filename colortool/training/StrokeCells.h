// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/votes/ColorVotes.h"

namespace colortool {

/// The evidence of a stroke for one cell of the color table.
struct StrokeCell {
  /// The index of the cell, as returned by ColorTable::cellOf().
  std::size_t cell = 0;
  /// The number of its pixels there times its weight, in ColorVotes::kUnit-ths of a pixel; negative if they
  /// must not be of the stroke's class.
  std::int64_t units = 0;
  /// The number of its pixels there, without weight.
  std::uint32_t pixels = 0;
  bool operator==(const StrokeCell&) const = default;
};

/// The cells of a stroke's pixels after the correction of its camera's colors: sorted by cell, each cell
/// once. Takes some microseconds for a stroke of the brush.
std::vector<StrokeCell> strokeCells(const Samples& samples, const Stroke& stroke);

/// Adds the cells of a stroke to the votes for `colorClass`, or removes them again (`sign` -1).
void addTo(ColorVotes& votes, std::span<const StrokeCell> cells, std::uint8_t colorClass, int sign = 1);

}  // namespace colortool
