// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/PaletteTable.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace colortool {
namespace {

/// The line of a color, in the coordinates (weighted Y, Cb - 128, Cr - 128).
struct Line {
  float y, cb, cr;
  float inverseSquare;
  float square;
  std::uint8_t colorClass;
};

std::vector<Line> lines(std::span<const NamedColor> palette, const ColorClasses& classes, float weight) {
  std::vector<Line> result;
  for (const NamedColor& color : palette) {
    const robotlink::YCbCr ycc = robotlink::toYCbCr(color.rgb);
    const float y = static_cast<float>(ycc.y) * weight;
    const float cb = static_cast<float>(ycc.cb) - 128, cr = static_cast<float>(ycc.cr) - 128;
    const float square = y * y + cb * cb + cr * cr;
    if (square > 0) result.push_back({y, cb, cr, 1 / square, square, classes.index(color.name)});
  }
  return result;
}

/// The center of the values that fall into a cell.
float middle(int cell) {
  return static_cast<float>(cell * ColorTable::kCellSize + 1.5);
}

class ColumnClassifier {
 public:
  ColumnClassifier(std::vector<Line> allLines, const LightingRange& lighting)
      : lines_(std::move(allLines)),
        dots_(lines_.size()),
        darkest_(static_cast<float>(lighting.darkest)),
        brightest_(static_cast<float>(lighting.brightest)),
        usual_(static_cast<float>(lighting.usual)),
        limit_(static_cast<float>(lighting.tolerance * lighting.tolerance)),
        weight_(static_cast<float>(lighting.brightnessWeight)) {}

  /// Classifies all cells with the same Cb and Cr.
  void classify(int cbCell, int crCell, ColorTable& table) {
    const float cb = middle(cbCell) - 128, cr = middle(crCell) - 128;
    for (std::size_t i = 0; i < lines_.size(); ++i) dots_[i] = cb * lines_[i].cb + cr * lines_[i].cr;
    for (int yCell = 0; yCell < ColorTable::kCells; ++yCell)
      table.setCell(yCell, cbCell, crCell, nearest(weight_ * middle(yCell), cb * cb + cr * cr));
  }

 private:
  std::uint8_t nearest(float y, float chromaSquare) const {
    float best = std::numeric_limits<float>::max();
    std::uint8_t winner = ColorClasses::kNone;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const Line& line = lines_[i];
      const float dot = dots_[i] + y * line.y;
      const float light = std::clamp(dot * line.inverseSquare, darkest_, brightest_);
      const float distance = chromaSquare + y * y - 2 * light * dot + light * light * line.square;
      // Much smaller than the tolerance, so that it matters only where lines coincide.
      const float unusual = (light - usual_) * 10;
      if (distance <= limit_ && distance + unusual * unusual < best) {
        best = distance + unusual * unusual;
        winner = line.colorClass;
      }
    }
    return winner;
  }

  std::vector<Line> lines_;
  std::vector<float> dots_;
  float darkest_, brightest_, usual_, limit_, weight_;
};

}  // namespace

ColorTable paletteTable(std::span<const NamedColor> palette, const ColorClasses& classes,
                        const LightingRange& lighting) {
  ColorTable table;
  ColumnClassifier classifier(lines(palette, classes, static_cast<float>(lighting.brightnessWeight)),
                              lighting);
  for (int cb = 0; cb < ColorTable::kCells; ++cb)
    for (int cr = 0; cr < ColorTable::kCells; ++cr) classifier.classify(cb, cr, table);
  return table;
}

}  // namespace colortool
