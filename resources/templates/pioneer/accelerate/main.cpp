// SPDX-License-Identifier: GPL-3.0-or-later
// Drives straight on, faster as time passes: from standing to 0.5 m/s in ten seconds. Stands when something
// is near ahead.
#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "robotlink/arcos/PioneerRobot.h"

int main(int argc, char** argv) {
  robotlink::arcos::PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double duration = argc > 2 ? std::atof(argv[2]) : 15;
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  robot.setSonar(true);
  const auto start = robot.state().time;
  double reported = 0, fastest = 0;
  while (robot.read()) {
    const auto state = robot.state();
    const double time = robotlink::seconds(state.time - start);
    if (time >= duration) break;
    const bool blocked = robot.nearestEcho(-0.5, 0.5) < 0.8;
    robot.setSpeed(blocked ? 0 : std::min(0.05 * time, 0.5));
    fastest = std::max(fastest, state.speed);
    if (time - reported >= 1)
      std::cout << (reported = time) << " s: " << state.speed << " m/s at " << state.pose.x << " m\n";
  }
  std::cout << "fastest: " << fastest << " m/s\n";
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() ? 0 : 1;
}
