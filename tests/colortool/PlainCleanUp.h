// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdlib>
#include <vector>

#include "colortool/votes/TableCleanUp.h"

namespace colortool {

// The algorithms of CellSet and TableCleanUp in their simplest form, cell by cell, for comparison.

/// Calls `use` with each neighbor of a cell.
template <typename Use>
void visitNeighbors(std::size_t cell, CellNeighbors neighbors, Use use) {
  const int y = static_cast<int>(cell / 4096), cb = static_cast<int>(cell / 64 % 64),
            cr = static_cast<int>(cell % 64);
  const auto inside = [](int i) { return i >= 0 && i < 64; };
  for (int dy = -1; dy <= 1; ++dy) {
    for (int db = -1; db <= 1; ++db) {
      for (int dr = -1; dr <= 1; ++dr) {
        const int steps = std::abs(dy) + std::abs(db) + std::abs(dr);
        if (steps == 0 || (neighbors == CellNeighbors::k6 && steps > 1)) continue;
        if (inside(y + dy) && inside(cb + db) && inside(cr + dr))
          use(static_cast<std::size_t>((y + dy) * 4096 + (cb + db) * 64 + cr + dr));
      }
    }
  }
}

inline CellSet plainConnectedCells(const CellSet& seeds, const CellSet& within, CellNeighbors neighbors) {
  CellSet reached;
  std::vector<std::size_t> next;
  const auto reach = [&](std::size_t cell) {
    if (!within.contains(cell) || reached.contains(cell)) return;
    reached.set(cell);
    next.push_back(cell);
  };
  for (std::size_t cell = 0; cell < ColorTable::kCellCount; ++cell) {
    if (seeds.contains(cell)) reach(cell);
  }
  while (!next.empty()) {
    const std::size_t cell = next.back();
    next.pop_back();
    visitNeighbors(cell, neighbors, reach);
  }
  return reached;
}

inline std::vector<std::uint8_t> plainCleanUp(const ColorTable& raw, const std::vector<CellSet>& sampled,
                                              const CleanUpOptions& options) {
  std::vector<std::uint8_t> cells(raw.cells().begin(), raw.cells().end());
  /// Calls `use` with each connected set of equal cells.
  const auto visitComponents = [&](CellNeighbors neighbors, auto use) {
    std::vector<bool> seen(cells.size(), false);
    for (std::size_t first = 0; first < cells.size(); ++first) {
      if (seen[first]) continue;
      std::vector<std::size_t> component{first};
      seen[first] = true;
      for (std::size_t i = 0; i < component.size(); ++i) {
        visitNeighbors(component[i], neighbors, [&](std::size_t other) {
          if (seen[other] || cells[other] != cells[first]) return;
          seen[other] = true;
          component.push_back(other);
        });
      }
      use(cells[first], component);
    }
  };
  if (options.removeUnsupported) {
    std::vector<std::uint8_t> kept = cells;
    visitComponents(
        CellNeighbors::k26, [&](std::uint8_t colorClass, const std::vector<std::size_t>& component) {
          if (colorClass == 0) return;
          bool supported = false;
          for (const std::size_t cell : component)
            supported = supported || (colorClass < sampled.size() && sampled[colorClass].contains(cell));
          for (const std::size_t cell : component) kept[cell] = supported ? colorClass : 0;
        });
    cells = kept;
  }
  if (!options.fillHoles) return cells;
  std::vector<std::uint8_t> filled = cells;
  visitComponents(CellNeighbors::k6, [&](std::uint8_t colorClass, const std::vector<std::size_t>& component) {
    if (colorClass != 0) return;
    std::array<bool, 256> touched{};
    bool open = false;
    for (const std::size_t cell : component) {
      open = open || (!sampled.empty() && sampled[0].contains(cell));
      std::size_t neighbors = 0;
      visitNeighbors(cell, CellNeighbors::k6, [&](std::size_t other) {
        ++neighbors;
        touched[cells[other]] = cells[other] != 0 || touched[0];
      });
      open = open || neighbors < 6;
    }
    if (open || std::ranges::count(touched, true) != 1) return;
    const auto surrounding = static_cast<std::uint8_t>(std::ranges::find(touched, true) - touched.begin());
    for (const std::size_t cell : component) filled[cell] = surrounding;
  });
  return filled;
}

}  // namespace colortool
