// SPDX-License-Identifier: GPL-3.0-or-later
// Three robots meet: each shares where it is, all drive to the middle between them and stop around it.
// Real robots are put where kStarts says; simulated ones ask their simulator where they are.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>

#include "robotlink/arcos/PioneerRobot.h"

using robotlink::Pose2;
using robotlink::Vector2;
using robotlink::arcos::PioneerRobot;

constexpr double kApart = 0.9;  // m from the middle: so far three of them have room around it
constexpr std::array<Pose2, 3> kStarts = {{{0, 0, 0}, {3, 0, robotlink::kPi}, {0, 3, 0}}};

struct Member {
  std::unique_ptr<PioneerRobot> robot;
  Pose2 odometryInField;

  Pose2 pose() const { return odometryInField * robot->pose(); }
  bool begin(const Pose2& start) {
    const auto begun = robot->begin();
    if (!begun) std::cerr << begun.error().text << "\n";
    if (!begun) return false;
    robot->setMotors(true);
    robot->setSonar(true);
    if (robot->isSimulated()) {
      robot->setTruePose(true);
      while (robot->read() && !robot->truePose()) {
      }
    }
    odometryInField = robot->truePose().value_or(start) * robot->pose().inverse();
    return true;
  }
  /// True if it is there.
  bool driveTo(const Vector2& goal) {
    const Vector2 way = pose().inverse() * goal;
    const double direction = std::atan2(way.y(), way.x());
    const bool there = way.norm() < 0.1;
    const bool blocked = robot->nearestEcho(-0.4, 0.4) < 0.6;
    const double speed = there || blocked || std::abs(direction) > 0.4 ? 0 : std::clamp(way.norm(), 0.1, 0.4);
    robot->drive(speed, there ? 0 : std::clamp(direction, -0.6, 0.6));
    return there;
  }
};

int main(int argc, char** argv) {
  std::array<Member, 3> members;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const int argument = static_cast<int>(i) + 1;
    members[i].robot = std::make_unique<PioneerRobot>(
        argc > argument ? argv[argument] : "tcp://localhost:" + std::to_string(8101 + i));
    if (!members[i].begin(kStarts[i])) return 1;
  }
  const double limit = argc > 4 ? std::atof(argv[4]) : 60;
  Vector2 middle(0, 0);
  for (const Member& member : members) middle += member.pose().translation() / 3;
  std::array<Vector2, 3> goals;
  for (std::size_t i = 0; i < 3; ++i) {
    goals[i] = middle + kApart * (members[i].pose().translation() - middle).normalized();
  }
  const auto start = members[0].robot->state().time;
  std::size_t there = 0;
  while (there < 3 && robotlink::seconds(members[0].robot->state().time - start) < limit) {
    there = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!members[i].robot->read()) {
        std::cerr << members[i].robot->problem() << "\n";
        return 1;
      }
      there += members[i].driveTo(goals[i]) ? 1 : 0;
    }
  }
  std::cout << there << " of 3 met around " << middle.x() << " m, " << middle.y() << " m\n";
  return there == 3 ? 0 : 1;
}
