// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/StrokeCells.h"

#include <algorithm>
#include <cmath>

namespace colortool {
namespace {

/// From this number of pixels on, counting in an array of all cells is faster than sorting.
constexpr std::size_t kManyPixels = 4096;

/// Returns the cell of each pixel of the stroke, in its order.
std::vector<std::uint32_t> cellsOfPixels(const Samples& samples, const Stroke& stroke) {
  const SampleImage* image = samples.image(stroke.image);
  const ColorCorrection correction =
      image == nullptr ? ColorCorrection{} : samples.correctionOf(image->camera);
  std::vector<std::uint32_t> cells;
  cells.reserve(stroke.colors.size());
  if (correction.none()) {
    for (const robotlink::YCbCr color : stroke.colors) {
      cells.push_back(static_cast<std::uint32_t>(ColorTable::cellOf(color)));
    }
    return cells;
  }
  auto color = stroke.colors.begin();
  for (const PixelRun& run : stroke.area) {
    for (int x = run.begin; x < run.end && color != stroke.colors.end(); ++x, ++color) {
      cells.push_back(static_cast<std::uint32_t>(
          ColorTable::cellOf(correction.apply(*color, x, run.y, image->width, image->height))));
    }
  }
  return cells;
}

}  // namespace

std::vector<StrokeCell> strokeCells(const Samples& samples, const Stroke& stroke) {
  std::vector<std::uint32_t> pixels = cellsOfPixels(samples, stroke);
  const double unitsPerPixel = (stroke.mustNotBe ? -1 : 1) * stroke.weight * double{ColorVotes::kUnit};
  std::vector<StrokeCell> cells;
  const auto addCell = [&](std::size_t cell, std::uint32_t count) {
    if (count > 0) cells.push_back({cell, std::llround(unitsPerPixel * count), count});
  };
  if (pixels.size() >= kManyPixels) {
    std::vector<std::uint32_t> counts(ColorTable::kCellCount, 0);
    for (const std::uint32_t cell : pixels) ++counts[cell];
    for (std::size_t cell = 0; cell < counts.size(); ++cell) addCell(cell, counts[cell]);
    return cells;
  }
  std::ranges::sort(pixels);
  for (auto begin = pixels.begin(); begin != pixels.end();) {
    const auto end = std::upper_bound(begin, pixels.end(), *begin);
    addCell(*begin, static_cast<std::uint32_t>(end - begin));
    begin = end;
  }
  return cells;
}

void addTo(ColorVotes& votes, std::span<const StrokeCell> cells, std::uint8_t colorClass, int sign) {
  for (const StrokeCell& cell : cells) votes.add(cell.cell, colorClass, sign * cell.units);
}

}  // namespace colortool
