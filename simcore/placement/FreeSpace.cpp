// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/placement/FreeSpace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace simcore {

using robotlink::Vector2;

namespace {

constexpr double kFarAhead = 5;  ///< m; longer free ways do not count more
constexpr int kDirections = 16;
/// The number of random candidates; the one farthest from all others is taken.
constexpr int kDraws = 48;
// A position is inside if there is something in this many of eight directions.
constexpr int kSidesAround = 7;

double distanceToNearest(const Vector2& point, const std::vector<Vector2>& others) {
  double nearest = std::numeric_limits<double>::max();
  for (const Vector2& other : others) nearest = std::min(nearest, (point - other).norm());
  return nearest;
}

}  // namespace

/// A connected set of free cells.
struct FreeSpace::Part {
  std::vector<Cell> cells;
  // Whether one of the cells is at the border of the grid.
  bool open = false;
};

FreeSpace::FreeSpace(const ClearanceGrid& grid, double radius, std::optional<Vector2> start)
    : grid_(grid), radius_(radius) {
  std::vector<std::uint8_t> visited(static_cast<std::size_t>(grid.width()) *
                                    static_cast<std::size_t>(grid.height()));
  const std::optional<Cell> first = start ? freeCellNextTo(*start) : std::nullopt;
  Part part = first ? partAround(*first, visited) : largestPart();
  cells_ = std::move(part.cells);
  if (part.open) keepSurrounded();
}

std::optional<ClearanceGrid::Cell> FreeSpace::freeCellNextTo(const Vector2& point) const {
  std::optional<Cell> best;
  double nearest = std::numeric_limits<double>::max();
  for (int y = 0; y < grid_.height(); ++y) {
    for (int x = 0; x < grid_.width(); ++x) {
      const double distance = (grid_.centerOf({x, y}) - point).squaredNorm();
      if (distance >= nearest || !isFree({x, y})) continue;
      nearest = distance;
      best = Cell{x, y};
    }
  }
  return best;
}

FreeSpace::Part FreeSpace::partAround(const Cell& start, std::vector<std::uint8_t>& visited) const {
  Part part;
  part.cells.push_back(start);
  visited[grid_.indexOf(start)] = 1;
  for (std::size_t next = 0; next < part.cells.size(); ++next) {
    const Cell cell = part.cells[next];
    const Cell neighbors[] = {
        {cell.x + 1, cell.y}, {cell.x - 1, cell.y}, {cell.x, cell.y + 1}, {cell.x, cell.y - 1}};
    for (const Cell& neighbor : neighbors) {
      if (!grid_.contains(neighbor)) {
        part.open = true;
      } else if (visited[grid_.indexOf(neighbor)] == 0 && isFree(neighbor)) {
        visited[grid_.indexOf(neighbor)] = 1;
        part.cells.push_back(neighbor);
      }
    }
  }
  return part;
}

FreeSpace::Part FreeSpace::largestPart() const {
  std::vector<std::uint8_t> visited(static_cast<std::size_t>(grid_.width()) *
                                    static_cast<std::size_t>(grid_.height()));
  Part closed, open;
  for (int y = 0; y < grid_.height(); ++y) {
    for (int x = 0; x < grid_.width(); ++x) {
      if (!isFree({x, y}) || visited[grid_.indexOf({x, y})] != 0) continue;
      Part part = partAround({x, y}, visited);
      Part& best = part.open ? open : closed;
      if (part.cells.size() > best.cells.size()) best = std::move(part);
    }
  }
  return closed.cells.empty() ? open : closed;
}

/// From the border inwards, one direction after the other: a cell has something on a side if the next one is
/// marked or has. So the time depends on the cells alone, not on how far it is to what is around them.
void FreeSpace::keepSurrounded() {
  constexpr Cell kSides[] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const std::size_t size = static_cast<std::size_t>(grid_.width()) * static_cast<std::size_t>(grid_.height());
  std::vector<std::uint8_t> sides(size), something(size);
  for (const Cell& side : kSides) {
    for (int row = 0; row < grid_.height(); ++row) {
      const int y = side.y > 0 ? grid_.height() - 1 - row : row;
      for (int column = 0; column < grid_.width(); ++column) {
        const int x = side.x > 0 ? grid_.width() - 1 - column : column;
        const Cell next{x + side.x, y + side.y};
        const std::size_t at = grid_.indexOf({x, y});
        const bool beyond = grid_.contains(next) && something[grid_.indexOf(next)] != 0;
        something[at] = beyond || grid_.isMarked({x, y}) ? 1 : 0;
        sides[at] = static_cast<std::uint8_t>(sides[at] + something[at]);
      }
    }
  }
  std::vector<Cell> inside;
  std::ranges::copy_if(cells_, std::back_inserter(inside),
                       [&](const Cell& cell) { return sides[grid_.indexOf(cell)] >= kSidesAround; });
  if (!inside.empty()) cells_ = std::move(inside);
}

std::optional<Vector2> FreeSpace::nearest(const Vector2& point) const {
  std::optional<Vector2> best;
  for (const Cell& cell : cells_) {
    const Vector2 center = grid_.centerOf(cell);
    if (!best || (center - point).squaredNorm() < (*best - point).squaredNorm()) best = center;
  }
  return best;
}

std::optional<Vector2> FreeSpace::pick(const std::vector<Vector2>& taken, double apart,
                                       robotlink::Random& random) const {
  if (cells_.empty()) return std::nullopt;
  const auto centerOf = [&](std::uint64_t number) { return grid_.centerOf(cells_[number % cells_.size()]); };
  std::optional<Vector2> best;
  double farthest = apart;
  for (int i = 0; i < kDraws; ++i) {
    const Vector2 center = centerOf(random.bits());
    const double distance = distanceToNearest(center, taken);
    if (distance < farthest) continue;
    farthest = distance;
    best = center;
  }
  // The floor is nearly full: try all cells, beginning at a random one.
  const std::uint64_t first = random.bits() % cells_.size();
  for (std::uint64_t i = 0; !best && i < cells_.size(); ++i) {
    const Vector2 center = centerOf(first + i);
    if (distanceToNearest(center, taken) >= apart) best = center;
  }
  return best;
}

double FreeSpace::headingAt(const Vector2& place, robotlink::Random& random) const {
  const double turn = random.uniform(0, 2 * robotlink::kPi / kDirections);
  const auto first = static_cast<int>(random.bits() % kDirections);
  double best = 0, longest = -1;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = turn + 2 * robotlink::kPi * (first + i) / kDirections;
    const Vector2 along(std::cos(angle), std::sin(angle));
    double way = 0;
    while (way < kFarAhead && isFree(grid_.cellAt(place + way * along))) way += grid_.cellSize();
    if (way <= longest) continue;
    longest = way;
    best = angle;
  }
  return robotlink::normalizedAngle(best);
}

}  // namespace simcore
