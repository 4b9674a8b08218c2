// SPDX-License-Identifier: GPL-3.0-or-later
// Wanders through a building without touching anything: by sonar, and by laser where there is one.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "robotlink/arcos/PioneerRobot.h"

// All of the robot is within this of the center it turns about, with a hand's breadth to spare: so it may
// turn wherever it got.
constexpr double kRadius = 0.47;  // m
constexpr double kSight = 3;      // m

/// How far the robot could go in this direction, as a disc.
double freeWay(const std::vector<robotlink::Vector2>& echoes, double direction) {
  double way = kSight;
  for (const auto& echo : echoes) {
    const double along = echo.x() * std::cos(direction) + echo.y() * std::sin(direction);
    const double across = echo.y() * std::cos(direction) - echo.x() * std::sin(direction);
    if (along <= 0 || std::abs(across) >= kRadius) continue;
    way = std::min(way, along - std::sqrt(kRadius * kRadius - across * across));
  }
  return way;
}

int main(int argc, char** argv) {
  robotlink::arcos::PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double duration = argc > 2 ? std::atof(argv[2]) : 600;
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  robot.setSonar(true);
  robot.setLaser(true);  // fails on robots whose laser has a line of its own; sonars will do
  const auto start = robot.state().time;
  double course = robot.heading();  // rad, that it chose
  while (robot.read() && robotlink::seconds(robot.state().time - start) < duration) {
    const auto echoes = robot.echoes();
    const double chosen = robotlink::normalizedAngle(course - robot.heading());  // from ahead
    // The way that is free for longest; rather ahead, and much rather the one chosen before, so that it does
    // not waver. By and by it likes the left more, then the right: so it comes around.
    const double curiosity = 0.3 * std::sin(robotlink::seconds(robot.state().time - start) / 15);
    double best = 0, most = -1e9;
    for (double direction = -1.6; direction <= 1.6; direction += 0.08) {
      const double liking = freeWay(echoes, direction) + curiosity * direction - 0.2 * std::abs(direction) -
                            0.6 * std::abs(direction - chosen);
      if (liking > most) most = liking, best = direction;
    }
    if (freeWay(echoes, best) < 0.3) best = chosen < 0 ? -1.6 : 1.6;  // no way out: turns until there is one
    course = robot.heading() + best;
    const double ahead = freeWay(echoes, 0), straight = std::max(0.0, 1 - std::abs(best) / 0.6);
    robot.drive(std::clamp(0.6 * (ahead - 0.1), 0.0, 0.4) * straight, std::clamp(1.2 * best, -0.6, 0.6));
  }
  std::cout << (robot.isConnected() ? "wandered to the end" : robot.problem()) << "\n";
  return robot.isConnected() ? 0 : 1;
}
