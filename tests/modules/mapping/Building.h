// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "tests/modules/driving/RollingRobot.h"

namespace modules {

/// A floor of 14 m by 9 m: four rooms with doors of a meter along a corridor, with a cupboard in one of them.
inline robotlink::GroundMap buildingMap() {
  robotlink::GroundMap map = roomMap(14, 9);
  for (const double y : {3.5, 5.5}) {
    for (const auto& [from, to] : {std::pair{0.0, 3.0}, std::pair{4.0, 10.0}, std::pair{11.0, 14.0}})
      addWall(map, from, y, to, y);
  }
  addWall(map, 7, 0, 7, 3.5);
  addWall(map, 6, 5.5, 6, 9);
  addWall(map, 1, 1, 1.6, 1);
  addWall(map, 1.6, 1, 1.6, 2);
  addWall(map, 1, 2, 1.6, 2);
  addWall(map, 1, 1, 1, 2);
  return map;
}

/// A way through all rooms of the building and back to where it starts.
inline std::vector<robotlink::Vector2> buildingTour() {
  return {{3.5, 4.5}, {3.5, 2},   {5.5, 1.5},  {3.5, 2.5},  {3.5, 7}, {2, 7.5},
          {3.5, 6.5}, {3.5, 4.5}, {10.5, 4.5}, {10.5, 2},   {12, 1},  {10.5, 2.5},
          {10.5, 7},  {8, 8},     {10.5, 6.5}, {10.5, 4.5}, {2, 4.5}};
}

/// Drives a robot along points by its true pose, as a person would; `sensed` is called each cycle.
inline void driveAlong(RollingRobot& robot, std::span<const robotlink::Vector2> points,
                       const std::function<void()>& sensed) {
  for (const robotlink::Vector2& point : points) {
    const double until = robot.time() + 120;
    while (robot.time() < until) {
      const robotlink::Vector2 toPoint = robot.pose().inverse() * point;
      if (toPoint.norm() < 0.1) break;
      const double direction = std::atan2(toPoint.y(), toPoint.x());
      const double speed = std::abs(direction) < 0.3 ? std::min(0.6, toPoint.norm()) : 0;
      robot.drive({speed, std::clamp(1.5 * direction, -0.8, 0.8)});
      sensed();
    }
  }
}

/// How well a map agrees with the true one. Both are in the same frame.
struct MapAgreement {
  /// The share of what is on the map that is at most 10 cm from a true wall.
  double right = 0;
  /// The share of the true walls that are at most 10 cm from something on the map.
  double complete = 0;
};

inline MapAgreement agreement(const robotlink::GroundMap& truth, std::span<const robotlink::Vector2> mapped) {
  constexpr double kNear = 0.1, kStep = 0.05;
  MapAgreement result;
  const DistanceMap walls(truth, {.cell = 0.02});
  for (const robotlink::Vector2& point : mapped) result.right += walls.at(point) <= kNear ? 1 : 0;
  result.right /= std::max<double>(1, static_cast<double>(mapped.size()));
  robotlink::GroundMap points;
  points.points.assign(mapped.begin(), mapped.end());
  const DistanceMap near(points, {.cell = 0.02});
  double all = 0;
  for (const auto& line : truth.lines) {
    const int count = std::max(1, static_cast<int>((line.to - line.from).norm() / kStep));
    for (int i = 0; i < count; ++i, ++all)
      result.complete += near.at(line.from + (line.to - line.from) * ((i + 0.5) / count)) <= kNear ? 1 : 0;
  }
  result.complete /= std::max(1.0, all);
  return result;
}

}  // namespace modules
