// SPDX-License-Identifier: GPL-3.0-or-later
// The loop of all robots' programs: sense, plan, act, each 100 ms. Drives until something is ahead, then
// turns to the freer side.
#include <cstdlib>
#include <iostream>

#include "robotlink/arcos/PioneerRobot.h"

using robotlink::arcos::PioneerRobot;

struct Motion {
  double speed = 0;     // m/s
  double rotation = 0;  // rad/s, counterclockwise
};

Motion plan(const PioneerRobot& robot, Motion last) {
  const double ahead = robot.nearestEcho(-0.6, 0.6), left = robot.nearestEcho(0.6, 1.8),
               right = robot.nearestEcho(-1.8, -0.6);
  if (ahead > 1.2) return {0.3, 0};
  if (last.rotation != 0) return last;  // once it turns it continues that way, so that corners do not hold it
  return {0, left > right ? 0.5 : -0.5};
}

int main(int argc, char** argv) {
  PioneerRobot robot(argc > 1 ? argv[1] : "tcp://localhost:8101");
  const double duration = argc > 2 ? std::atof(argv[2]) : 60;
  if (const auto begun = robot.begin(); !begun) {
    std::cerr << begun.error().text << "\n";
    return 1;
  }
  robot.setMotors(true);
  robot.setSonar(true);
  const auto start = robot.state().time;
  Motion motion;
  while (robot.read() && robotlink::seconds(robot.state().time - start) < duration) {  // sense
    motion = plan(robot, motion);                                                      // plan
    robot.drive(motion.speed, motion.rotation);                                        // act
  }
  const auto pose = robot.pose();
  std::cout << "at " << pose.x << " m, " << pose.y << " m, battery " << robot.battery() << " V\n";
  if (!robot.isConnected()) std::cerr << robot.problem() << "\n";
  return robot.isConnected() ? 0 : 1;
}
