// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/GridPlanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>

namespace modules {

using robotlink::Vector2;

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr std::array<std::array<int, 2>, 8> kSteps{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

GridFrame planningFrame(const GridFrame& fine, double cell) {
  GridFrame frame = fine;
  frame.cell = std::max(cell, fine.cell);
  frame.width = std::max(1, static_cast<int>(std::ceil(fine.width * fine.cell / frame.cell)));
  frame.height = std::max(1, static_cast<int>(std::ceil(fine.height * fine.cell / frame.cell)));
  return frame;
}

DistanceMap::Options withForbidden() {
  DistanceMap::Options options;
  options.forbidden = true;
  return options;
}

}  // namespace

double PlannedPath::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

GridPlanner::GridPlanner(const robotlink::GroundMap& map, const Options& options)
    : options_(options),
      walls_(map, {}),
      obstacles_(map, withForbidden()),
      frame_(planningFrame(obstacles_.frame(), options.cell)),
      mapCosts_(frame_.size()),
      toObstacle_(frame_.size(), DistanceMap::kFar) {
  for (int row = 0; row < frame_.height; ++row)
    for (int column = 0; column < frame_.width; ++column)
      mapCosts_[frame_.index(column, row)] =
          static_cast<float>(costOf(obstacles_.at(frame_.center(column, row))));
  costs_ = mapCosts_;
}

void GridPlanner::setObstacles(std::span<const Vector2> places) {
  std::ranges::fill(toObstacle_, DistanceMap::kFar);
  costs_ = mapCosts_;
  const double radius = std::max(options_.comfort, options_.clearance);
  const int reach = static_cast<int>(std::ceil(radius / frame_.cell));
  for (const Vector2& place : places) {
    const int column = frame_.column(place.x()), row = frame_.row(place.y());
    for (int y = std::max(0, row - reach); y <= std::min(frame_.height - 1, row + reach); ++y) {
      for (int x = std::max(0, column - reach); x <= std::min(frame_.width - 1, column + reach); ++x) {
        const double away = (frame_.center(x, y) - place).norm();
        const std::size_t cell = frame_.index(x, y);
        if (away > radius || away >= toObstacle_[cell]) continue;
        toObstacle_[cell] = static_cast<float>(away);
        costs_[cell] = std::max(mapCosts_[cell], static_cast<float>(costOf(away)));
      }
    }
  }
  if (goal_) wave_ = places.empty() ? mapWave_ : waveOf(costs_);
}

double GridPlanner::clearanceAt(const Vector2& place) const {
  const int column = frame_.column(place.x()), row = frame_.row(place.y());
  const double seen =
      frame_.contains(column, row) ? toObstacle_[frame_.index(column, row)] : DistanceMap::kFar;
  return std::min(obstacles_.at(place), seen);
}

double GridPlanner::costOf(double clearance) const {
  if (clearance < options_.clearance) return kNever;
  const double room = std::max(1e-6, options_.comfort - options_.clearance);
  const double near = std::clamp((options_.comfort - clearance) / room, 0.0, 1.0);
  return 1 + options_.nearness * near * near;
}

bool GridPlanner::passable(int column, int row) const {
  return frame_.contains(column, row) && costs_[frame_.index(column, row)] < kNever;
}

bool GridPlanner::passable(const Vector2& place) const {
  return passable(frame_.column(place.x()), frame_.row(place.y()));
}

double GridPlanner::costOf(const Vector2& from, const Vector2& to) const {
  const double length = (to - from).norm();
  const int steps = 1 + static_cast<int>(length / (0.5 * frame_.cell));
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += costOf(clearanceAt(from + (to - from) * ((i + 0.5) / steps)));
  return sum / steps * length;
}

void GridPlanner::setGoal(const Vector2& goal) {
  goal_ = goal;
  mapWave_ = waveOf(mapCosts_);
  wave_ = costs_ == mapCosts_ ? mapWave_ : waveOf(costs_);
}

std::vector<float> GridPlanner::waveOf(const std::vector<float>& costs) const {
  std::vector<float> wave(frame_.size(), kNever);
  const auto free = [&](int column, int row) {
    return frame_.contains(column, row) && costs[frame_.index(column, row)] < kNever;
  };
  const int goalColumn = frame_.column(goal_->x()), goalRow = frame_.row(goal_->y());
  if (!free(goalColumn, goalRow)) return wave;
  using Entry = std::pair<float, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
  const std::size_t start = frame_.index(goalColumn, goalRow);
  wave[start] = 0;
  front.emplace(0.0F, static_cast<std::uint32_t>(start));
  while (!front.empty()) {
    const auto [cost, cell] = front.top();
    front.pop();
    if (cost > wave[cell]) continue;
    const int column = static_cast<int>(cell) % frame_.width, row = static_cast<int>(cell) / frame_.width;
    for (const auto& step : kSteps) {
      if (!free(column + step[0], row + step[1])) continue;
      // Diagonal steps across corners are not allowed.
      if (!free(column + step[0], row) || !free(column, row + step[1])) continue;
      const std::size_t next = frame_.index(column + step[0], row + step[1]);
      const double way = frame_.cell * std::hypot(step[0], step[1]);
      const auto through = static_cast<float>(cost + way * 0.5 * (costs[cell] + costs[next]));
      if (through >= wave[next]) continue;
      wave[next] = through;
      front.emplace(through, static_cast<std::uint32_t>(next));
    }
  }
  return wave;
}

std::string GridPlanner::wrongWithGoal() const {
  const int column = frame_.column(goal_->x()), row = frame_.row(goal_->y());
  if (!frame_.contains(column, row)) return "the goal is not on the map";
  if (passable(column, row)) return "";
  if (mapCosts_[frame_.index(column, row)] < kNever)
    return "an obstacle that is not on the map is at the goal, or too near to it";
  if (walls_.at(*goal_) >= options_.clearance)
    return "the goal is forbidden: it lies in a forbidden area, or too near to one";
  return "the goal is too near to a wall for this robot";
}

bool GridPlanner::nothingBetween(const Vector2& from, const Vector2& to) const {
  constexpr double kStep = 0.025;
  // A robot that is inside an obstacle by its pose may leave it.
  const double least = std::min(clearanceAt(from), 0.5 * frame_.cell);
  const int steps = 1 + static_cast<int>((to - from).norm() / kStep);
  for (int i = 1; i <= steps; ++i) {
    if (clearanceAt(from + (to - from) * (static_cast<double>(i) / steps)) < least) return false;
  }
  return true;
}

std::optional<std::size_t> GridPlanner::startCell(const Vector2& from, const std::vector<float>& wave) const {
  const int reach = static_cast<int>(options_.reach / frame_.cell);
  const int column = frame_.column(from.x()), row = frame_.row(from.y());
  std::optional<std::size_t> best;
  double least = kNever;
  for (int y = row - reach; y <= row + reach; ++y) {
    for (int x = column - reach; x <= column + reach; ++x) {
      if (!frame_.contains(x, y) || wave[frame_.index(x, y)] == kNever) continue;
      const double away = (frame_.center(x, y) - from).norm();
      if (away > options_.reach || away >= least || !nothingBetween(from, frame_.center(x, y))) continue;
      least = away;
      best = frame_.index(x, y);
    }
  }
  return best;
}

PlannedPath GridPlanner::path(const Vector2& from) const {
  PlannedPath path;
  path.reason = wrongWithGoal();
  if (path.blocked()) return path;
  const std::optional<std::size_t> start = startCell(from, wave_);
  if (!start) {
    path.reason = startCell(from, mapWave_)
                      ? "an obstacle that is not on the map blocks every path to the goal"
                      : "no path to the goal is wide enough and outside of forbidden areas";
    return path;
  }
  constexpr float kDetour = 0.5;
  path.around = wave_[*start] > mapWave_[*start] + kDetour;
  std::vector<Vector2> points = downTheWave(*start);
  points.front() = from;
  points.back() = *goal_;
  // A robot at a place where it cannot be leaves through the nearest free cell.
  if (!passable(from) && points.size() > 1) {
    const int cell = static_cast<int>(*start);
    points.insert(points.begin() + 1, frame_.center(cell % frame_.width, cell / frame_.width));
  }
  path.points = straightened(points);
  return path;
}

std::vector<Vector2> GridPlanner::downTheWave(std::size_t cell) const {
  std::vector<Vector2> points;
  while (true) {
    const int column = static_cast<int>(cell) % frame_.width, row = static_cast<int>(cell) / frame_.width;
    points.push_back(frame_.center(column, row));
    std::size_t next = cell;
    for (const auto& step : kSteps) {
      if (!passable(column + step[0], row + step[1])) continue;
      if (!passable(column + step[0], row) || !passable(column, row + step[1])) continue;
      const std::size_t beside = frame_.index(column + step[0], row + step[1]);
      if (wave_[beside] < wave_[next]) next = beside;
    }
    if (next == cell) break;
    cell = next;
  }
  if (points.size() == 1) points.push_back(points.front());
  return points;
}

std::vector<GridPlanner::WavePoint> GridPlanner::wave(std::size_t most) const {
  std::vector<WavePoint> points;
  float farthest = 0;
  std::size_t reached = 0;
  for (const float cost : wave_) {
    if (cost == kNever) continue;
    farthest = std::max(farthest, cost);
    ++reached;
  }
  const int stride =
      1 + static_cast<int>(std::sqrt(static_cast<double>(reached) / static_cast<double>(most + 1)));
  for (int row = 0; row < frame_.height && !wave_.empty(); row += stride) {
    for (int column = 0; column < frame_.width; column += stride) {
      const float cost = wave_[frame_.index(column, row)];
      if (cost < kNever && farthest > 0) points.push_back({frame_.center(column, row), cost / farthest});
    }
  }
  return points;
}

/// Removes points between two others if the straight line between these costs no more.
std::vector<Vector2> GridPlanner::straightened(const std::vector<Vector2>& points) const {
  std::vector<Vector2> result{points.front()};
  std::size_t at = 0;
  while (at + 1 < points.size()) {
    std::size_t next = at + 1;
    double along = costOf(points[at], points[next]);
    for (std::size_t i = at + 2; i < points.size(); ++i) {
      along += costOf(points[i - 1], points[i]);
      const double straight = costOf(points[at], points[i]);
      // A slightly higher cost is acceptable: steps of the grid cause detours of up to 8 %.
      if (straight > 1.01 * along) {
        if ((points[i] - points[at]).norm() > 3) break;
        continue;
      }
      next = i;
    }
    result.push_back(points[next]);
    at = next;
  }
  return result;
}

}  // namespace modules
