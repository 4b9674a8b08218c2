// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/physics/shapes/StaticGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simcore {
namespace {

constexpr double kCell = 0.5;  // m
constexpr double kMaxGridCells = 1 << 20;
constexpr double kRounding = 1e-6;  // of a cell's size

struct Span {
  double first = 0, last = -1;  // empty at first
};

/// The range in x of a rectangle between two values of y.
Span spanBetween(const Footprint& footprint, double low, double high) {
  const robotlink::Vector2 along = footprint.along * footprint.halfLength;
  const robotlink::Vector2 across =
      robotlink::Vector2(-footprint.along.y(), footprint.along.x()) * footprint.halfWidth;
  const robotlink::Vector2 corners[] = {footprint.center + along + across, footprint.center - along + across,
                                        footprint.center - along - across, footprint.center + along - across};
  Span span{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto extend = [&](double x) { span = {std::min(span.first, x), std::max(span.last, x)}; };
  for (std::size_t i = 0; i < 4; ++i) {
    const robotlink::Vector2 &from = corners[i], &to = corners[(i + 1) % 4];
    if (from.y() >= low && from.y() <= high) extend(from.x());
    for (const double y : {low, high}) {
      if ((from.y() < y) == (to.y() < y)) continue;
      extend(from.x() + (to.x() - from.x()) * (y - from.y()) / (to.y() - from.y()));
    }
  }
  return span;
}

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
  double cell = kCell;
  while ((width / cell + 1) * (height / cell + 1) > kMaxGridCells) cell *= 2;
  const std::size_t most = std::max(kMaxEntries, geoms_.size());
  // Two passes: the first counts the entries of each cell, the second stores them.
  for (;; cell *= 2) {
    setCellSize(cell, width, height);
    firstInCell_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    std::size_t entries = 0;
    const bool fits = forEachEntry([&](std::size_t at, std::uint32_t) {
      ++firstInCell_[at + 1];
      return ++entries <= most;
    });
    if (fits) break;
  }
  for (std::size_t i = 1; i < firstInCell_.size(); ++i) firstInCell_[i] += firstInCell_[i - 1];
  inCells_.resize(firstInCell_.back());
  std::vector<std::uint32_t> next(firstInCell_.begin(), firstInCell_.end() - 1);
  forEachEntry([&](std::size_t at, std::uint32_t i) {
    inCells_[next[at]++] = i;
    return true;
  });
  seenIn_.assign(geoms_.size(), 0);
}

void StaticGrid::setCellSize(double cell, double width, double height) {
  cell_ = cell;
  columns_ = static_cast<int>(width / cell) + 1;
  rows_ = static_cast<int>(height / cell) + 1;
}

template <typename Visit>
bool StaticGrid::forEachEntry(Visit visit) const {
  const double half = cell_ / 2;
  for (std::uint32_t i = 0; i < geoms_.size(); ++i) {
    const Bounds& b = bounds_[i];
    const Cells all = cellsOf(b[0], b[1], b[2], b[3]);
    for (int y = all.y0; y <= all.y1; ++y) {
      // A long oblique wall has wide bounds but occupies few cells of a row.
      const double low = bottom_ + y * cell_;
      const Span span = spanBetween(footprints_[i], low - kRounding * cell_, low + (1 + kRounding) * cell_);
      const Cells row = cellsOf(span.first - kRounding * cell_, span.last + kRounding * cell_, low, low);
      for (int x = std::max(row.x0, all.x0); x <= std::min(row.x1, all.x1); ++x) {
        const Footprint square{{left_ + x * cell_ + half, low + half}, {1, 0}, half, half};
        const std::size_t at =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
        if (meet(footprints_[i], square) && !visit(at, i)) return false;
      }
    }
  }
  return true;
}

StaticGrid::Cells StaticGrid::cellsOf(double x0, double x1, double y0, double y1) const {
  const auto index = [&](double value, double origin, int count) {
    return static_cast<int>(
        std::clamp(std::floor((value - origin) / cell_), -1.0, static_cast<double>(count)));
  };
  // A rectangle beside the grid gets an empty range.
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
  const Footprint place{{(bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2},
                        {1, 0},
                        (bounds[1] - bounds[0]) / 2,
                        (bounds[3] - bounds[2]) / 2};
  if (++query_ == 0) {
    std::ranges::fill(seenIn_, 0);
    query_ = 1;
  }
  forEachIn(cells, [&](std::uint32_t i) {
    if (seenIn_[i] == query_) return;
    seenIn_[i] = query_;
    if (overlap(bounds_[i], bounds) && meet(footprints_[i], place)) found.push_back(geoms_[i]);
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
