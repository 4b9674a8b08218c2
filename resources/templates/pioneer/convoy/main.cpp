// SPDX-License-Identifier: GPL-3.0-or-later
// Two robots in a convoy: the first drives as it finds room, the second in its tracks, a meter and a half
// behind. Put the second one 1.5 m behind the first, with the same heading; in a simulator the program does
// it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>
#include <iostream>

#include "robotlink/arcos/PioneerRobot.h"

using robotlink::Pose2;
using robotlink::Vector2;
using robotlink::arcos::PioneerRobot;

constexpr double kGap = 1.5;  // m

bool beginConvoy(PioneerRobot& leader, PioneerRobot& follower) {
  for (PioneerRobot* robot : {&leader, &follower}) {
    if (const auto begun = robot->begin(); !begun) {
      std::cerr << begun.error().text << "\n";
      return false;
    }
    robot->setMotors(true);
    robot->setSonar(true);
  }
  if (leader.isSimulated() && leader.setTruePose(true)) {
    while (leader.read() && !leader.truePose()) {
    }
    if (const auto there = leader.truePose()) follower.putAt(*there * Pose2{-kGap, 0, 0});
  }
  return true;
}

/// Straight on, and a wide turn before obstacles.
void lead(PioneerRobot& robot) {
  const double ahead = robot.nearestEcho(-0.7, 0.7);
  robot.drive(std::clamp(0.3 * (ahead - 0.6), 0.0, 0.25), ahead < 1.6 ? 0.5 : 0);
}

int main(int argc, char** argv) {
  PioneerRobot leader(argc > 1 ? argv[1] : "tcp://localhost:8101"),
      follower(argc > 2 ? argv[2] : "tcp://localhost:8102");
  const double duration = argc > 3 ? std::atof(argv[3]) : 60;
  if (!beginConvoy(leader, follower)) return 1;
  // Both count from where they stood, so the second's frame is that of the first moved back by the gap.
  const Pose2 leaderStart = leader.pose(), followerStart = follower.pose();
  std::deque<Vector2> track = {{0, 0}};
  const auto start = leader.state().time;
  double gap = kGap;
  while (leader.read() && follower.read() && robotlink::seconds(leader.state().time - start) < duration) {
    const Pose2 first = leaderStart.inverse() * leader.pose();
    const Pose2 second = Pose2{-kGap, 0, 0} * followerStart.inverse() * follower.pose();
    if ((first.translation() - track.back()).norm() > 0.1) track.push_back(first.translation());
    while (track.size() > 1 && (track.front() - second.translation()).norm() < 0.3) track.pop_front();
    gap = (first.translation() - second.translation()).norm();
    lead(leader);
    const Vector2 next = second.inverse() * track.front();
    const double direction = std::atan2(next.y(), next.x());
    const bool near = gap < kGap || follower.nearestEcho(-0.5, 0.5) < 0.7;
    follower.drive(near ? 0 : std::min(0.8 * (gap - kGap) + 0.1, 0.4),
                   std::clamp(1.5 * direction, -0.6, 0.6));
  }
  std::cout << "the gap at the end: " << gap << " m\n";
  for (const PioneerRobot* robot : {&leader, &follower}) {
    if (robot->isConnected()) continue;
    std::cerr << robot->problem() << "\n";
    return 1;
  }
  return 0;
}
