// SPDX-License-Identifier: GPL-3.0-or-later
// Navigates without a map: drives to a place, around whatever sonars or a laser see on the way. Ends there,
// or where it does not get any nearer.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "robotlink/arcos/PioneerRobot.h"

using robotlink::Vector2;

constexpr double kRadius = 0.45;  // m, of the robot as a disc, with a hand's breadth to spare
constexpr double kSight = 2.5;    // m
constexpr double kNear = 0.15;    // m, from the goal

/// How far the robot could go in this direction, as a disc.
double freeWay(const std::vector<Vector2>& echoes, double direction) {
  double way = kSight;
  for (const Vector2& echo : echoes) {
    const double along = echo.x() * std::cos(direction) + echo.y() * std::sin(direction);
    const double across = echo.y() * std::cos(direction) - echo.x() * std::sin(direction);
    if (along <= 0 || std::abs(across) >= kRadius) continue;
    way = std::min(way, along - std::sqrt(kRadius * kRadius - across * across));
  }
  return way;
}

/// The direction that leads to the goal and is free; `before` is the one chosen last, so that it does not
/// waver.
double chosenDirection(const std::vector<Vector2>& echoes, const Vector2& goal, double before) {
  const double toGoal = std::atan2(goal.y(), goal.x()), needed = std::min(kSight, goal.norm());
  double best = 0, most = -1e9;
  for (double direction = -1.9; direction <= 1.9; direction += 0.08) {
    const double liking = 1.5 * std::min(needed, freeWay(echoes, direction)) -
                          std::abs(robotlink::normalizedAngle(direction - toGoal)) -
                          0.4 * std::abs(direction - before);
    if (liking > most) most = liking, best = direction;
  }
  return best;
}

int main(int argc, char** argv) {
  robotlink::arcos::PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const Vector2 goal{argc > 2 ? std::atof(argv[2]) : 3.0, argc > 3 ? std::atof(argv[3]) : 0.0};
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  robot.setSonar(true);
  robot.setLaser(true);  // fails on robots whose laser has a line of its own; sonars will do
  const robotlink::Pose2 start = robot.pose();
  double nearest = 1e9, direction = 0;
  robotlink::Instant progress = robot.state().time;
  while (robot.read()) {
    const robotlink::Pose2 pose = start.inverse() * robot.pose();
    const Vector2 toGoal = pose.inverse() * goal;  // as seen from the robot
    if (toGoal.norm() < kNear) {
      robot.stop();
      std::cout << "arrived at " << pose.x << " m, " << pose.y << " m\n";
      return 0;
    }
    if (toGoal.norm() < nearest - 0.05) nearest = toGoal.norm(), progress = robot.state().time;
    if (robot.state().time - progress > std::chrono::seconds(40)) {
      robot.stop();
      std::cerr << "no way found from " << pose.x << " m, " << pose.y << " m\n";
      return 1;
    }
    const auto echoes = robot.echoes();
    direction = chosenDirection(echoes, toGoal, direction);
    const double ahead = std::min(freeWay(echoes, 0), toGoal.norm());
    const double straight = std::max(0.0, 1 - std::abs(direction) / 0.6);
    robot.drive(std::clamp(0.7 * ahead, 0.0, 0.4) * straight, std::clamp(1.3 * direction, -0.7, 0.7));
  }
  std::cerr << robot.problem() << "\n";
  return 1;
}
