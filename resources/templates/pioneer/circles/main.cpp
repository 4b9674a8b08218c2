// SPDX-License-Identifier: GPL-3.0-or-later
// Draws circles of one meter across, left and right in turn: an eight, if the wheels did not slip.
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "robotlink/arcos/PioneerRobot.h"

int main(int argc, char** argv) {
  robotlink::arcos::PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double duration = argc > 2 ? std::atof(argv[2]) : 60;
  constexpr double kRadius = 0.5, kRotation = robotlink::radians(24.0);  // m, rad/s: a circle in 15 s
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  const auto start = robot.state().time;
  double turned = 0, side = 1, last = robot.heading();
  while (robot.read() && robotlink::seconds(robot.state().time - start) < duration) {
    const auto pose = robot.pose();
    turned += robotlink::normalizedAngle(pose.heading - last);
    last = pose.heading;
    if (std::abs(turned) >= 2 * robotlink::kPi) {
      std::cout << "a circle to the " << (side > 0 ? "left" : "right") << " ended at " << pose.x << " m, "
                << pose.y << " m\n";
      turned = 0;
      side = -side;
    }
    robot.drive(kRadius * kRotation, side * kRotation);
  }
  std::cout << "turned " << robotlink::degrees(turned) << " degrees of the last one\n";
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() ? 0 : 1;
}
