// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/driving/FlatWorld.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace modules {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// The share of the way from `from` along `direction` (of length 1) to a line, in m; negative if it is not
/// met.
double crossing(const Vector2& from, const Vector2& direction, const GroundMap::Line& line) {
  const Vector2 way = line.to - line.from, start = line.from - from;
  const double cross = direction.x() * way.y() - direction.y() * way.x();
  if (std::abs(cross) < 1e-12) return -1;
  const double along = (start.x() * way.y() - start.y() * way.x()) / cross;
  const double share = (start.x() * direction.y() - start.y() * direction.x()) / cross;
  return share >= 0 && share <= 1 ? along : -1;
}

}  // namespace

FlatWorld::FlatWorld(const GroundMap& map) {
  const GroundMap::Bounds bounds = map.bounds();
  low_ = bounds.low - Vector2(1, 1);
  width_ = 2 + static_cast<int>(std::ceil(bounds.high.x() - bounds.low.x()));
  height_ = 2 + static_cast<int>(std::ceil(bounds.high.y() - bounds.low.y()));
  squares_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (const Line& line : map.lines) add(line);
  const double half = 0.5 * map.resolution;
  for (const Vector2& point : map.points) {
    add({point - Vector2(half, 0), point + Vector2(half, 0)});
    add({point - Vector2(0, half), point + Vector2(0, half)});
  }
}

const std::vector<std::size_t>* FlatWorld::square(int column, int row) const {
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return nullptr;
  return &squares_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(column)];
}

void FlatWorld::add(const Line& line) {
  lines_.push_back(line);
  const int steps = 1 + static_cast<int>((line.to - line.from).norm() / 0.01);
  for (int i = 0; i <= steps; ++i) {
    const Vector2 place = line.from + (line.to - line.from) * (static_cast<double>(i) / steps);
    auto* cell = const_cast<std::vector<std::size_t>*>(square(columnOf(place.x()), rowOf(place.y())));
    if (cell != nullptr && (cell->empty() || cell->back() != lines_.size() - 1))
      cell->push_back(lines_.size() - 1);
  }
}

double FlatWorld::ray(const Pose2& sensor, double maximum) const {
  const Vector2 from = sensor.translation(), direction(std::cos(sensor.heading), std::sin(sensor.heading));
  int column = columnOf(from.x()), row = rowOf(from.y());
  const int right = direction.x() > 0 ? 1 : -1, up = direction.y() > 0 ? 1 : -1;
  // m, along the ray to the next border of a square.
  const double perX = 1 / std::max(1e-9, std::abs(direction.x()));
  const double perY = 1 / std::max(1e-9, std::abs(direction.y()));
  double toX = (right > 0 ? column + 1 - (from.x() - low_.x()) : from.x() - low_.x() - column) * perX;
  double toY = (up > 0 ? row + 1 - (from.y() - low_.y()) : from.y() - low_.y() - row) * perY;
  double least = maximum, way = 0;
  while (way < least) {
    const auto* cell = square(column, row);
    if (cell == nullptr) break;
    for (const std::size_t index : *cell) {
      const double along = crossing(from, direction, lines_[index]);
      if (along >= 0) least = std::min(least, along);
    }
    way = std::min(toX, toY);
    if (toX < toY) {
      column += right;
      toX += perX;
    } else {
      row += up;
      toY += perY;
    }
  }
  return least;
}

double FlatWorld::cone(const Pose2& sensor, double openingAngle, double maximum) const {
  double least = maximum;
  const int rays = 1 + static_cast<int>(std::ceil(openingAngle / robotlink::radians(3)));
  for (int i = 0; i < rays; ++i) {
    const double angle = rays > 1 ? openingAngle * (static_cast<double>(i) / (rays - 1) - 0.5) : 0;
    least = std::min(least, ray(sensor * Pose2{0, 0, angle}, maximum));
  }
  // Rays pass by the ends of lines that are near.
  const Pose2 fieldInSensor = sensor.inverse();
  for (int y = rowOf(sensor.y - least); y <= rowOf(sensor.y + least); ++y) {
    for (int x = columnOf(sensor.x - least); x <= columnOf(sensor.x + least); ++x) {
      const auto* cell = square(x, y);
      if (cell == nullptr) continue;
      for (const std::size_t index : *cell) {
        for (const Vector2& end : {lines_[index].from, lines_[index].to}) {
          const Vector2 place = fieldInSensor * end;
          if (place.norm() < least && std::abs(std::atan2(place.y(), place.x())) < 0.5 * openingAngle)
            least = place.norm();
        }
      }
    }
  }
  return least;
}

double FlatWorld::distance(const Outline& outline, const Pose2& robot) const {
  double least = 0.5;
  const int column = columnOf(robot.x), row = rowOf(robot.y);
  const Pose2 fieldInRobot = robot.inverse();
  for (int y = row - 1; y <= row + 1; ++y) {
    for (int x = column - 1; x <= column + 1; ++x) {
      const auto* cell = square(x, y);
      if (cell == nullptr) continue;
      for (const std::size_t index : *cell) {
        const Vector2 from = fieldInRobot * lines_[index].from, to = fieldInRobot * lines_[index].to;
        // Long lines matter near the robot only: walk along the part of it that is within reach.
        const double length = (to - from).norm();
        const double middle = length > 0 ? std::clamp(-from.dot(to - from) / (length * length), 0.0, 1.0) : 0;
        const double span = length > 0 ? 1.0 / length : 0;
        for (double share = std::max(0.0, middle - span); share <= std::min(1.0, middle + span) + 1e-9;
             share += std::max(1e-3, 0.02 / std::max(length, 0.02)))
          least = std::min(least, outline.distance(from + share * (to - from)));
      }
    }
  }
  return least;
}

GroundMap roomMap(double length, double width) {
  GroundMap map;
  map.name = "room";
  addWall(map, 0, 0, length, 0);
  addWall(map, length, 0, length, width);
  addWall(map, length, width, 0, width);
  addWall(map, 0, width, 0, 0);
  return map;
}

void addWall(GroundMap& map, double x1, double y1, double x2, double y2) {
  map.lines.push_back({{x1, y1}, {x2, y2}});
}

GroundMap sharedMap(const char* name) {
  auto map = GroundMap::load(std::filesystem::path(ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos") / name);
  return map ? *map : GroundMap{};
}

}  // namespace modules
