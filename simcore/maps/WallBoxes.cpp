// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/maps/WallBoxes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/maps/SparseCells.h"

namespace simcore {
namespace {

using robotlink::GroundMap;
using robotlink::Vector2;

constexpr double kLineThickness = 0.01;
/// The distance that a surface may move, m.
constexpr double kTolerance = 0.02;
// Finer cells would be too many, and make no visible difference.
constexpr double kFinestCell = 0.01;
// Longer than the walls of any building; points beside lines beyond this length keep boxes of their own.
constexpr double kLongestMarked = 100'000;

WallBox boxOf(const GroundMap::Line& line) {
  const Vector2 along = line.to - line.from;
  // The ends of a box extend as far as its sides, so that corners are closed.
  return {(line.from + line.to) / 2,
          {along.norm() + kLineThickness, kLineThickness},
          std::atan2(along.y(), along.x())};
}

struct Cell {
  int x = 0, y = 0;
};

/// Both ends are inclusive.
struct CellRectangle {
  int left = 0, right = 0, bottom = 0, top = 0;
};

/// Merges cells into rectangles. A rectangle may cover empty cells that are close enough to a wall.
class CellGatherer {
 public:
  CellGatherer(std::vector<Cell> cells, int reach) : cells_(std::move(cells)) {
    for (const Cell& cell : cells_) {
      waiting_.insert(cell.x, cell.y);
      for (int dx = -reach; dx <= reach; ++dx) {
        const int rest = reach - std::abs(dx);
        for (int dy = -rest; dy <= rest; ++dy) allowed_.insert(cell.x + dx, cell.y + dy);
      }
    }
  }

  std::vector<CellRectangle> gather() {
    std::vector<CellRectangle> result;
    for (const Cell& cell : cells_) {
      if (!waiting_.contains(cell.x, cell.y)) continue;
      const Grown wide = grow(cell, true), tall = grow(cell, false);
      const Grown& best = wide.gathered >= tall.gathered ? wide : tall;
      const CellRectangle& r = best.rectangle;
      for (int y = r.bottom; y <= r.top; ++y) {
        for (int x = r.left; x <= r.right; ++x) waiting_.erase(x, y);
      }
      result.push_back(r);
    }
    return result;
  }

 private:
  /// A rectangle that is no larger than the remaining cells in it require.
  struct Grown {
    CellRectangle rectangle;
    int gathered = 0;
  };

  // Longer than walls of buildings; what grows beyond it continues in the next rectangle.
  static constexpr int kLongest = 2000;

  bool isColumnAllowed(int x, const CellRectangle& r) const {
    for (int y = r.bottom; y <= r.top; ++y) {
      if (!allowed_.contains(x, y)) return false;
    }
    return true;
  }
  bool isRowAllowed(int y, const CellRectangle& r) const {
    for (int x = r.left; x <= r.right; ++x) {
      if (!allowed_.contains(x, y)) return false;
    }
    return true;
  }

  void growWide(CellRectangle& r) const {
    while (r.right - r.left < kLongest && isColumnAllowed(r.right + 1, r)) ++r.right;
    while (r.right - r.left < kLongest && isColumnAllowed(r.left - 1, r)) --r.left;
  }
  void growTall(CellRectangle& r) const {
    while (r.top - r.bottom < kLongest && isRowAllowed(r.top + 1, r)) ++r.top;
    while (r.top - r.bottom < kLongest && isRowAllowed(r.bottom - 1, r)) --r.bottom;
  }

  Grown grow(const Cell& from, bool wideFirst) const {
    CellRectangle r{from.x, from.x, from.y, from.y};
    if (wideFirst) {
      growWide(r);
      growTall(r);
    } else {
      growTall(r);
      growWide(r);
    }
    Grown grown{{from.x, from.x, from.y, from.y}, 0};
    CellRectangle& tight = grown.rectangle;
    for (int y = r.bottom; y <= r.top; ++y) {
      for (int x = r.left; x <= r.right; ++x) {
        if (!waiting_.contains(x, y)) continue;
        ++grown.gathered;
        tight = {std::min(tight.left, x), std::max(tight.right, x), std::min(tight.bottom, y),
                 std::max(tight.top, y)};
      }
    }
    return grown;
  }

  std::vector<Cell> cells_;
  SparseCells waiting_, allowed_;
};

/// Marks the cells whose centers are so close to a line that its box covers them.
void markNear(const GroundMap::Line& line, double cell, double distance, SparseCells& near) {
  const Vector2 along = line.to - line.from;
  const double length = along.norm();
  const Vector2 unit = length > 0 ? Vector2(along / length) : Vector2(Vector2::UnitX());
  const auto cellOf = [&](double coordinate) { return static_cast<int>(std::lround(coordinate / cell)); };
  const int reach = static_cast<int>(std::ceil(distance / cell)) + 1;
  for (double at = 0; at <= length + cell; at += cell) {
    const Vector2 middle = line.from + std::min(at, length) * unit;
    for (int x = cellOf(middle.x()) - reach; x <= cellOf(middle.x()) + reach; ++x) {
      for (int y = cellOf(middle.y()) - reach; y <= cellOf(middle.y()) + reach; ++y) {
        const Vector2 offset = Vector2(x * cell, y * cell) - line.from;
        const double share = std::clamp(offset.dot(unit), 0.0, length);
        if ((offset - share * unit).norm() <= distance) near.insert(x, y);
      }
    }
  }
}

}  // namespace

std::vector<WallBox> wallBoxes(const GroundMap& map) {
  std::vector<WallBox> boxes;
  const double cell = std::max(map.resolution, kFinestCell);
  // At this distance from the line, the corner of a square is as far from the box as allowed.
  const double covered = kLineThickness / 2 + kTolerance - cell * std::numbers::sqrt2 / 2;
  SparseCells near;
  double marked = 0;
  for (const GroundMap::Line& line : map.lines) {
    boxes.push_back(boxOf(line));
    marked += (line.to - line.from).norm();
    if (!map.points.empty() && covered > 0 && marked < kLongestMarked) markNear(line, cell, covered, near);
  }
  std::vector<Cell> cells;
  for (const Vector2& point : map.points) {
    const Cell at{static_cast<int>(std::lround(point.x() / cell)),
                  static_cast<int>(std::lround(point.y() / cell))};
    if (!near.contains(at.x, at.y)) cells.push_back(at);
  }
  std::ranges::sort(cells, [](const Cell& a, const Cell& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
  for (const CellRectangle& r :
       CellGatherer(std::move(cells), static_cast<int>(kTolerance / cell + 1e-9)).gather()) {
    const Vector2 middle(r.left + r.right, r.bottom + r.top),
        count(r.right - r.left + 1, r.top - r.bottom + 1);
    boxes.push_back({middle * cell / 2, count * cell, 0});
  }
  return boxes;
}

}  // namespace simcore
