// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/BackgroundColors.h"

#include <array>

#include "colortool/training/StrokeCells.h"

namespace colortool {
namespace {

ColorTable cellsOfBackground(const Samples& samples) {
  std::vector<std::uint8_t> cells(ColorTable::kCellCount);
  for (const StrokePtr& stroke : samples.strokes) {
    if (stroke->colorClass != ColorClasses::kNone || stroke->mustNotBe) continue;
    for (const StrokeCell& cell : strokeCells(samples, *stroke)) cells[cell.cell] = 1;
  }
  constexpr std::array<std::uint8_t, 2> kSame{0, 1};
  return ColorTable::translated(cells, kSame);
}

}  // namespace

BackgroundColors::BackgroundColors(const Samples& samples, const ColorTable& table)
    : table_(table), background_(cellsOfBackground(samples)) {
  const auto classes = static_cast<std::size_t>(samples.classes.size());
  counts_.covered.resize(classes);
  counts_.taken.resize(classes);
}

void BackgroundColors::add(const robotlink::ImageView& image) {
  table_.classify(image, classes_);
  background_.classify(image, marked_);
  for (int y = 0; y < classes_.height; ++y) {
    const std::uint8_t *found = classes_.row(y), *marked = marked_.row(y);
    for (int x = 0; x < classes_.width; ++x) {
      if (found[x] >= counts_.covered.size()) continue;
      ++counts_.pixels;
      ++counts_.covered[found[x]];
      counts_.background += marked[x];
      counts_.taken[found[x]] += marked[x];
    }
  }
}

}  // namespace colortool
