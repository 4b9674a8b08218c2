// SPDX-License-Identifier: GPL-3.0-or-later
// Plans: finds the shortest way through a map from the robot's home to a place of the map, and drives it by
// odometry. What is not on the map it does not know.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <optional>
#include <queue>
#include <vector>

#include "robotlink/arcos/PioneerRobot.h"
#include "robotlink/base/GroundMap.h"

using robotlink::GroundMap;
using robotlink::Vector2;

constexpr double kCell = 0.1;       // m
constexpr double kClearance = 0.5;  // m, that the robot's center needs from walls

/// Cells that a robot can be in, and how far each is from the goal.
class Planner {
 public:
  explicit Planner(const GroundMap& map) : low_(map.bounds().low) {
    const Vector2 size = map.bounds().high - low_;
    width_ = 1 + static_cast<int>(size.x() / kCell);
    height_ = 1 + static_cast<int>(size.y() / kCell);
    blocked_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), false);
    for (const auto& line : map.lines) {
      const double length = (line.to - line.from).norm();
      for (double way = 0; way <= length; way += 0.5 * kCell)
        block(line.from + (line.to - line.from) * (length > 0 ? way / length : 0));
    }
    for (const Vector2& point : map.points) block(point);
  }

  /// The points of the shortest way; empty if there is none.
  std::vector<Vector2> path(const Vector2& from, const Vector2& to) const {
    std::vector<double> wave(blocked_.size(), kFar);
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    const int start = cellOf(from), goal = cellOf(to);
    if (start < 0 || goal < 0 || blocked_[static_cast<std::size_t>(goal)]) return {};
    wave[static_cast<std::size_t>(goal)] = 0;
    front.emplace(0.0, goal);
    while (!front.empty()) {
      const double way = front.top().first;
      const int cell = front.top().second;
      front.pop();
      if (way > wave[static_cast<std::size_t>(cell)]) continue;
      forNeighbors(cell, [&](int next, double step) {
        if (way + step >= wave[static_cast<std::size_t>(next)]) return;
        wave[static_cast<std::size_t>(next)] = way + step;
        front.emplace(way + step, next);
      });
    }
    if (wave[static_cast<std::size_t>(start)] == kFar) return {};
    std::vector<Vector2> points;
    for (int cell = start; cell != goal;) {
      int best = cell;
      forNeighbors(cell, [&](int next, double) {
        if (wave[static_cast<std::size_t>(next)] < wave[static_cast<std::size_t>(best)]) best = next;
      });
      cell = best;
      points.push_back(low_ + kCell * Vector2(cell % width_ + 0.5, cell / width_ + 0.5));
    }
    points.push_back(to);
    return points;
  }

 private:
  static constexpr double kFar = 1e9;

  int cellOf(const Vector2& place) const {
    const Vector2 at = (place - low_) / kCell;
    const bool inside = at.x() >= 0 && at.y() >= 0 && at.x() < width_ && at.y() < height_;
    return inside ? static_cast<int>(at.y()) * width_ + static_cast<int>(at.x()) : -1;
  }
  void block(const Vector2& wall) {
    for (double y = -kClearance; y <= kClearance; y += kCell) {
      for (double x = -kClearance; x <= kClearance; x += kCell) {
        const int cell = cellOf(wall + Vector2(x, y));
        if (cell >= 0 && std::hypot(x, y) < kClearance) blocked_[static_cast<std::size_t>(cell)] = true;
      }
    }
  }
  template <typename Use>
  void forNeighbors(int cell, const Use& use) const {
    const int column = cell % width_, row = cell / width_;
    for (int y = std::max(0, row - 1); y <= std::min(height_ - 1, row + 1); ++y) {
      for (int x = std::max(0, column - 1); x <= std::min(width_ - 1, column + 1); ++x) {
        const int next = y * width_ + x;
        if (next != cell && !blocked_[static_cast<std::size_t>(next)])
          use(next, std::hypot(x - column, y - row));
      }
    }
  }

  Vector2 low_;
  int width_ = 0, height_ = 0;
  std::vector<bool> blocked_;
};

/// The point of the path that is some way ahead of the robot; `passed` is the one it passed last.
Vector2 aheadOf(const std::vector<Vector2>& path, const Vector2& robot, std::size_t& passed) {
  while (passed + 1 < path.size() && (path[passed] - robot).norm() < 0.3) ++passed;
  return path[passed];
}

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: planning tcp://localhost:8101 FILE.map PLACE\n";
    return 2;
  }
  const auto map = GroundMap::load(argv[2]);
  if (!map) {
    std::cerr << robotlink::describe(map.error()) << "\n";
    return 1;
  }
  const auto* home = map->find(GroundMap::Place::Kind::kHome);
  const auto* place = map->find(std::string_view(argv[3]));
  if (home == nullptr || place == nullptr) {
    std::cerr << "the map has no " << (home == nullptr ? "home to start from" : argv[3]) << "\n";
    return 1;
  }
  const auto path = Planner(*map).path(home->pose.translation(), place->pose.translation());
  if (path.empty()) {
    std::cerr << "no way leads to " << argv[3] << "\n";
    return 1;
  }
  std::cout << "the way has " << path.size() << " points\n";
  robotlink::arcos::PioneerRobot robot(argv[1]);
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  const robotlink::Pose2 start = robot.pose();
  std::size_t passed = 0;
  while (robot.read()) {
    const robotlink::Pose2 pose = home->pose * start.inverse() * robot.pose();
    if ((path.back() - pose.translation()).norm() < 0.1) break;
    const Vector2 next = pose.inverse() * aheadOf(path, pose.translation(), passed);
    const double direction = std::atan2(next.y(), next.x());
    const double speed =
        std::abs(direction) < 0.5 ? std::clamp(next.norm(), 0.1, 0.4) * std::cos(direction) : 0;
    robot.drive(speed, std::clamp(1.5 * direction, -0.8, 0.8));
    if (robot.stalled()) {
      robot.stop();
      std::cerr << "something is in the way at " << pose.x << " m, " << pose.y << " m\n";
      return 1;
    }
  }
  robot.stop();
  const robotlink::Pose2 end = home->pose * start.inverse() * robot.pose();
  std::cout << "arrived at " << end.x << " m, " << end.y << " m\n";
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() ? 0 : 1;
}
