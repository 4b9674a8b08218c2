// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a map: turns around and drives on, counts in a grid where sonars or a laser see something, by the
// odometry's pose, and saves what was seen often as a map.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <map>

#include "robotlink/arcos/PioneerRobot.h"
#include "robotlink/base/GroundMap.h"

using robotlink::GroundMap;
using robotlink::Vector2;

/// How often something was seen at a place, and how often a ray passed it.
class Grid {
 public:
  static constexpr double kCell = 0.1;  // m

  /// A ray from a place to where it ended, in the frame of the map.
  void add(const Vector2& from, const Vector2& to) {
    const double length = (to - from).norm();
    for (double way = 0; way < length - kCell; way += kCell)
      --counts_[cellOf(from + (to - from) * (way / length))];
    counts_[cellOf(to)] += kHit;
  }
  /// The places where something is, as a map with a home at its origin.
  GroundMap map() const {
    GroundMap result;
    result.resolution = kCell;
    for (const auto& [cell, count] : counts_) {
      if (count >= kSure) result.points.emplace_back((cell.first + 0.5) * kCell, (cell.second + 0.5) * kCell);
    }
    result.places.emplace_back().kind = GroundMap::Place::Kind::kHome;
    return result;
  }

 private:
  using Cell = std::pair<int, int>;
  // Rays that pass near a wall's end take away, too; one hit is worth some of them.
  static constexpr int kHit = 4, kSure = 8;

  static Cell cellOf(const Vector2& place) {
    return {static_cast<int>(std::floor(place.x() / kCell)), static_cast<int>(std::floor(place.y() / kCell))};
  }

  std::map<Cell, int> counts_;
};

/// Adds what a laser sees; its scan came with the pose at which it was made.
void addScan(Grid& grid, const robotlink::Pose2& start, const robotlink::arcos::RangeScan& scan) {
  const robotlink::Pose2 pose = start.inverse() * scan.robot;
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    if (scan.echo(i)) grid.add(pose * scan.laserInRobot.translation(), pose * scan.pointInRobot(i));
  }
}

int main(int argc, char** argv) {
  robotlink::arcos::PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double duration = argc > 2 ? std::atof(argv[2]) : 120;
  const std::string file = argc > 3 ? argv[3] : "made.map";
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  robot.setSonar(true);
  const bool hasLaser = robot.setLaser(true).has_value();  // a real laser has a line of its own
  const robotlink::Pose2 start = robot.pose();
  const auto begin = robot.state().time;
  Grid grid;
  robotlink::Instant seen;
  while (robot.read() && robotlink::seconds(robot.state().time - begin) < duration) {
    if (const auto scan = robot.laser(); scan && scan->time != seen) {
      addScan(grid, start, *scan);
      seen = scan->time;
    }
    for (const auto& sonar : robot.sonars()) {
      if (!hasLaser && sonar.echo && sonar.range < 2 && sonar.time == robot.state().time)
        grid.add((start.inverse() * sonar.robot).translation(),
                 start.inverse() * sonar.robot * sonar.pointInRobot());
    }
    // One turn on the spot, then ahead, and to the left where something comes near.
    const double passed = robotlink::seconds(robot.state().time - begin);
    const bool turns = passed < 14 || robot.nearestEcho(-0.6, 0.6) < 0.9;
    robot.drive(turns ? 0 : 0.25, turns ? 0.5 : 0);
  }
  robot.stop();
  const GroundMap map = grid.map();
  if (const auto saved = map.save(file); !saved) {
    std::cerr << saved.error().text << "\n";
    return 1;
  }
  std::cout << map.points.size() << " places are in " << file << "\n";
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() ? 0 : 1;
}
