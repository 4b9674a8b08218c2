// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/StaticGrid.h"

#include <algorithm>
#include <cmath>

namespace simcore {
namespace {

constexpr double kCell = 0.5;  // m
constexpr double kMostCells = 1 << 20;

}  // namespace

void StaticGrid::add(dGeomID geom) {
  Bounds bounds;
  dGeomGetAABB(geom, bounds.data());
  if (!std::ranges::all_of(bounds, [](dReal value) { return std::isfinite(value); })) {
    unbounded_.push_back(geom);
    return;
  }
  geoms_.push_back(geom);
  bounds_.push_back(bounds);
  footprints_.push_back(footprintOf(geom));
}

void StaticGrid::build() {
  if (geoms_.empty()) return;
  Bounds all = bounds_[0];
  for (const Bounds& one : bounds_) {
    for (std::size_t i = 0; i < 6; i += 2) {
      all[i] = std::min(all[i], one[i]);
      all[i + 1] = std::max(all[i + 1], one[i + 1]);
    }
  }
  left_ = all[0];
  bottom_ = all[2];
  const double width = all[1] - all[0], height = all[3] - all[2];
  for (cell_ = kCell; (width / cell_ + 1) * (height / cell_ + 1) > kMostCells;) cell_ *= 2;
  columns_ = static_cast<int>(width / cell_) + 1;
  rows_ = static_cast<int>(height / cell_) + 1;
  // In two rounds: how many are in each cell, then which.
  firstInCell_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  const auto forEachEntry = [&](auto visit) {
    for (std::uint32_t i = 0; i < geoms_.size(); ++i) {
      const Bounds& b = bounds_[i];
      const Cells cells = cellsOf(b[0], b[1], b[2], b[3]);
      for (int y = cells.y0; y <= cells.y1; ++y) {
        for (int x = cells.x0; x <= cells.x1; ++x) {
          // A long wall that stands askew has wide bounds, yet is in few cells.
          const double half = cell_ / 2;
          const Footprint square{{left_ + x * cell_ + half, bottom_ + y * cell_ + half}, {1, 0}, half, half};
          if (meet(footprints_[i], square)) {
            visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(x),
                  i);
          }
        }
      }
    }
  };
  forEachEntry([&](std::size_t cell, std::uint32_t) { ++firstInCell_[cell + 1]; });
  for (std::size_t i = 1; i < firstInCell_.size(); ++i) firstInCell_[i] += firstInCell_[i - 1];
  inCells_.resize(firstInCell_.back());
  std::vector<std::uint32_t> next(firstInCell_.begin(), firstInCell_.end() - 1);
  forEachEntry([&](std::size_t cell, std::uint32_t i) { inCells_[next[cell]++] = i; });
  seenIn_.assign(geoms_.size(), 0);
}

StaticGrid::Cells StaticGrid::cellsOf(double x0, double x1, double y0, double y1) const {
  const auto index = [&](double value, double origin, int count) {
    return static_cast<int>(
        std::clamp(std::floor((value - origin) / cell_), -1.0, static_cast<double>(count)));
  };
  // What lies beside the grid altogether gets an empty range.
  return {std::max(0, index(x0, left_, columns_)), std::min(columns_ - 1, index(x1, left_, columns_)),
          std::max(0, index(y0, bottom_, rows_)), std::min(rows_ - 1, index(y1, bottom_, rows_))};
}

template <typename Visit>
void StaticGrid::forEachIn(const Cells& cells, Visit visit) const {
  if (cells.x0 > cells.x1) return;
  for (int y = cells.y0; y <= cells.y1; ++y) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_);
    const std::uint32_t begin = firstInCell_[row + static_cast<std::size_t>(cells.x0)];
    const std::uint32_t end = firstInCell_[row + static_cast<std::size_t>(cells.x1) + 1];
    for (std::uint32_t i = begin; i < end; ++i) visit(inCells_[i]);
  }
}

void StaticGrid::near(const Bounds& bounds, std::vector<dGeomID>& found) const {
  found.clear();
  const Cells cells = cellsOf(bounds[0], bounds[1], bounds[2], bounds[3]);
  if (++query_ == 0) {
    std::ranges::fill(seenIn_, 0);
    query_ = 1;
  }
  forEachIn(cells, [&](std::uint32_t i) {
    if (seenIn_[i] == query_) return;
    seenIn_[i] = query_;
    if (overlap(bounds_[i], bounds)) found.push_back(geoms_[i]);
  });
}

bool StaticGrid::meetsAny(const Footprint& footprint) const {
  const double c = std::abs(footprint.along.x()), d = std::abs(footprint.along.y());
  const double x = c * footprint.halfLength + d * footprint.halfWidth;
  const double y = d * footprint.halfLength + c * footprint.halfWidth;
  const robotlink::Vector2& center = footprint.center;
  bool met = false;
  forEachIn(cellsOf(center.x() - x, center.x() + x, center.y() - y, center.y() + y),
            [&](std::uint32_t i) { met = met || meet(footprints_[i], footprint); });
  return met;
}

double StaticGrid::clearance(double x, double y, double most) const {
  const Cells cells = cellsOf(x - most, x + most, y - most, y + most);
  double least = most * most;
  forEachIn(cells, [&](std::uint32_t i) {
    const Bounds& b = bounds_[i];
    const double dx = std::max({0.0, b[0] - x, x - b[1]}), dy = std::max({0.0, b[2] - y, y - b[3]});
    least = std::min(least, dx * dx + dy * dy);
  });
  return std::sqrt(least);
}

}  // namespace simcore
