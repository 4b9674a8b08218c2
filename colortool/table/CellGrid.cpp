// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/CellGrid.h"

#include <algorithm>
#include <span>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

constexpr int kSide = ColorTable::kCells;
constexpr std::size_t kMaxParts = 8;
static_assert(CellGrid::kMaxCells == 2 * kSide);

/// The range of cells of the grid, along one axis, that one cell of the table covers.
struct Stretch {
  int begin, end;
};
Stretch stretchOf(int cell, int side) {
  const int begin = cell * side / kSide;
  return {begin, std::max(begin + 1, (cell + 1) * side / kSide)};
}

/// Returns the most frequent one of sorted classes.
std::uint8_t mostFrequent(std::span<const std::uint8_t> sorted) {
  std::uint8_t best = ColorClasses::kNone;
  std::ptrdiff_t most = 0;
  for (auto begin = sorted.begin(); begin != sorted.end();) {
    const auto end = std::upper_bound(begin, sorted.end(), *begin);
    if (end - begin > most || (end - begin == most && best == ColorClasses::kNone)) {
      best = *begin;
      most = end - begin;
    }
    begin = end;
  }
  return best;
}

/// Computes the class of each cell of the table.
class Regridder {
 public:
  explicit Regridder(const CellGrid& grid) : grid_(grid) {}

  RegriddedCells run() {
    result_.classes.reserve(ColorTable::kCellCount);
    for (int y = 0; y < kSide; ++y) {
      for (int cb = 0; cb < kSide; ++cb) {
        for (int cr = 0; cr < kSide; ++cr) result_.classes.push_back(classOf(y, cb, cr));
      }
    }
    return std::move(result_);
  }

 private:
  std::uint8_t classOf(int y, int cb, int cr) {
    const Stretch a = stretchOf(y, grid_.sides[0]), b = stretchOf(grid_.crFirst ? cr : cb, grid_.sides[1]),
                  c = stretchOf(grid_.crFirst ? cb : cr, grid_.sides[2]);
    std::array<std::uint8_t, kMaxParts> parts{};
    std::size_t count = 0;
    for (int i = a.begin; i < a.end; ++i) {
      for (int j = b.begin; j < b.end; ++j) {
        for (int k = c.begin; k < c.end; ++k) parts[count++] = at(i, j, k);
      }
    }
    const std::span<std::uint8_t> all(parts.data(), count);
    if (std::ranges::adjacent_find(all, std::ranges::not_equal_to()) == all.end()) return all[0];
    ++result_.mixedCells;
    std::ranges::sort(all);
    return mostFrequent(all);
  }
  std::uint8_t at(int i, int j, int k) const {
    const int cell = (i * grid_.sides[1] + j) * grid_.sides[2] + k;
    return grid_.classes[static_cast<std::size_t>(cell)];
  }

  const CellGrid& grid_;
  RegriddedCells result_;
};

}  // namespace

RegriddedCells regrid(const CellGrid& grid) {
  return Regridder(grid).run();
}

}  // namespace colortool
