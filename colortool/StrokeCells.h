// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/ColorVotes.h"
#include "colortool/Samples.h"

namespace colortool {

/// What a stroke says of a cell of the colour table.
struct StrokeCell {
  std::size_t cell = 0;
  /// Its pixels there times its weight, in ColorVotes::kUnit-ths of a pixel; less than 0 if they must not be
  /// of the stroke's class.
  std::int64_t units = 0;
  std::uint32_t pixels = 0;  ///< of the stroke, whatever its weight
  bool operator==(const StrokeCell&) const = default;
};

/// The cells of a stroke's pixels, after what the samples' settings correct of its camera's colours: sorted
/// by cell, each of them once. Some microseconds for a brush's stroke.
std::vector<StrokeCell> strokeCells(const Samples& samples, const Stroke& stroke);

/// Adds a stroke's cells to what `votes` knows of `colorClass`, or takes them away again (`sign` -1).
void addTo(ColorVotes& votes, std::span<const StrokeCell> cells, std::uint8_t colorClass, int sign = 1);

}  // namespace colortool
