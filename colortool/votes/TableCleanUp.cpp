// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/TableCleanUp.h"

#include <algorithm>
#include <array>
#include <bit>

namespace colortool {
namespace {

using Row = CellSet::Row;

void setCells(ColorTable& table, const CellSet& cells, std::uint8_t colorClass) {
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    for (Row rest = cells.row(row); rest != 0; rest &= rest - 1) {
      table.setCell(static_cast<int>(row / 64), static_cast<int>(row % 64), std::countr_zero(rest),
                    colorClass);
    }
  }
}

/// All cells at the sides of the cube.
CellSet sides() {
  CellSet cells;
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    const std::size_t y = row / 64, cb = row % 64;
    const bool whole = y == 0 || y == 63 || cb == 0 || cb == 63;
    cells.row(row) = whole ? ~Row{0} : Row{1} | Row{1} << 63U;
  }
  return cells;
}

template <typename Combine>
void combine(CellSet& result, const CellSet& other, Combine combineRows) {
  for (std::size_t row = 0; row < CellSet::kRows; ++row)
    result.row(row) = combineRows(result.row(row), other.row(row));
}

constexpr auto kAnd = [](Row a, Row b) { return a & b; };
constexpr auto kWithout = [](Row a, Row b) { return a & ~b; };
constexpr auto kOr = [](Row a, Row b) { return a | b; };

}  // namespace

const ColorTable& TableCleanUp::clean(const ColorTable& raw, std::span<const CellSet> sampled,
                                      const CleanUpOptions& options) {
  if (options != options_) {
    for (Class& colorClass : classes_) colorClass.changed = true;
  }
  options_ = options;
  follow(raw, sampled);
  if (std::ranges::none_of(classes_, &Class::changed)) return table_;
  findSupported(options.removeUnsupported);
  table_ = raw;
  removeCells();
  if (options.fillHoles) fillHoles();
  for (Class& colorClass : classes_) colorClass.changed = false;
  return table_;
}

void TableCleanUp::follow(const ColorTable& raw, std::span<const CellSet> sampled) {
  const auto cells = raw.cells();
  classes_.resize(std::max({classes_.size(), sampled.size(), std::size_t{1}}));
  const CellSet nothing;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    const CellSet& now = i < sampled.size() ? sampled[i] : nothing;
    if (classes_[i].sampled == now) continue;
    classes_[i].sampled = now;
    classes_[i].changed = true;
  }
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    const auto next = cells.subspan(row * 64, 64);
    if (!raw_ || !std::ranges::equal(next, raw_->cells().subspan(row * 64, 64))) followRow(row, next);
  }
  raw_ = raw;
}

void TableCleanUp::followRow(std::size_t row, std::span<const std::uint8_t> cells) {
  std::uint8_t highest = 0;
  for (const std::uint8_t cell : cells) highest = std::max(highest, cell);
  classes_.resize(std::max(classes_.size(), std::size_t{highest} + 1));
  std::array<Row, 256> found;
  std::fill_n(found.begin(), classes_.size(), 0);
  for (std::size_t cr = 0; cr < cells.size(); ++cr) found[cells[cr]] |= Row{1} << cr;
  for (std::size_t i = 0; i < classes_.size(); ++i) {
    if (classes_[i].raw.row(row) == found[i]) continue;
    classes_[i].raw.row(row) = found[i];
    classes_[i].changed = true;
  }
}

void TableCleanUp::findSupported(bool removeUnsupported) {
  for (std::size_t i = 1; i < classes_.size(); ++i) {
    Class& colorClass = classes_[i];
    if (!colorClass.changed) continue;
    colorClass.kept = removeUnsupported
                          ? connectedCells(colorClass.sampled, colorClass.raw, CellNeighbors::k26)
                          : colorClass.raw;
  }
}

void TableCleanUp::removeCells() {
  CellSet removed;
  for (std::size_t i = 1; i < classes_.size(); ++i) {
    for (std::size_t row = 0; row < CellSet::kRows; ++row)
      removed.row(row) |= classes_[i].raw.row(row) & ~classes_[i].kept.row(row);
  }
  setCells(table_, removed, ColorClasses::kNone);
}

void TableCleanUp::fillHoles() {
  CellSet enclosed;  // cells of none that are not connected to the sides
  for (std::size_t row = 0; row < CellSet::kRows; ++row) enclosed.row(row) = ~Row{0};
  for (std::size_t i = 1; i < classes_.size(); ++i) combine(enclosed, classes_[i].kept, kWithout);
  combine(enclosed, connectedCells(sides(), enclosed, CellNeighbors::k6), kWithout);
  if (enclosed.empty()) return;

  std::vector<CellSet> touched;  // by class, from class 1 on
  CellSet once, twice;           // by at least one class, by at least two
  for (std::size_t i = 1; i < classes_.size(); ++i) {
    touched.push_back(facesOf(classes_[i].kept));
    combine(touched.back(), enclosed, kAnd);
    CellSet again = once;
    combine(again, touched.back(), kAnd);
    combine(twice, again, kOr);
    combine(once, touched.back(), kOr);
  }
  for (std::size_t i = 1; i < classes_.size(); ++i) {
    if (touched[i - 1].empty()) continue;
    // Cells that are connected to another class's neighbor, or to background, are no hole of this class.
    CellSet others = once;
    combine(others, touched[i - 1], kWithout);
    combine(others, twice, kOr);
    combine(others, classes_[0].sampled, kOr);
    CellSet holes = enclosed;
    combine(holes, connectedCells(others, enclosed, CellNeighbors::k6), kWithout);
    setCells(table_, holes, static_cast<std::uint8_t>(i));
  }
}

}  // namespace colortool
