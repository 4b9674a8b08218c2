// SPDX-License-Identifier: GPL-3.0-or-later
// Follows a path: a square of 1.5 m, in the frame of where it started. Ends where it began, or where
// something is in the way.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "robotlink/arcos/PioneerRobot.h"

using robotlink::Vector2;

// Notices that the robot does not come nearer to where it wants to go: a wall, a wheel that slips, motors
// that were switched off.
class StallCheck {
 public:
  // A new point to go to.
  void restart() { nearest_ = 1e9; }
  bool stuck(const robotlink::arcos::RobotState& state, double left, double turn) {
    const double rest = left + std::abs(turn);  // a turn on the spot is progress, too
    if (rest < nearest_ - 0.03) {
      nearest_ = rest;
      progress_ = state.time;
    }
    return state.time - progress_ > std::chrono::seconds(4);
  }

 private:
  double nearest_ = 1e9;
  robotlink::Instant progress_;
};

int main(int argc, char** argv) {
  robotlink::arcos::PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double side = argc > 2 ? std::atof(argv[2]) : 1.5;  // m
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  const std::vector<Vector2> path = {{side, 0}, {side, side}, {0, side}, {0, 0}};
  const robotlink::Pose2 start = robot.pose();
  auto next = path.begin();
  StallCheck stall;
  while (next != path.end() && robot.read()) {
    const robotlink::Pose2 pose = start.inverse() * robot.pose();
    const Vector2 toNext = pose.inverse() * *next;  // as seen from the robot
    if (toNext.norm() < 0.08) {
      std::cout << "at " << pose.x << " m, " << pose.y << " m\n";
      ++next;
      stall.restart();
      continue;
    }
    const double direction = std::atan2(toNext.y(), toNext.x());
    if (stall.stuck(robot.state(), toNext.norm(), direction)) {
      robot.stop();
      std::cerr << "stuck at " << pose.x << " m, " << pose.y << " m"
                << (robot.stalled()    ? ": something blocks the wheels\n"
                    : robot.motorsOn() ? "\n"
                                       : ": the motors are off\n");
      return 1;
    }
    // First it turns, then it drives; the nearer it comes the slower.
    const double speed =
        std::abs(direction) < 0.4 ? std::clamp(toNext.norm(), 0.1, 0.4) * std::cos(direction) : 0;
    robot.drive(speed, std::clamp(1.5 * direction, -0.8, 0.8));
  }
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() ? 0 : 1;
}
