// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/driving/Ride.h"

namespace modules {

Ride::Ride(const FlatWorld& world, const RollingRobot::Options& options, Avoidance avoidance)
    : robot_(world, options), avoidance_(avoidance), vectorField_({}), dynamicWindow_({}) {}

void Ride::cycle(const Desired& desired) {
  odometry_.add(robot_.now(), robot_.odometry());
  memory_.see(robot_.beams(), odometry_);
  memory_.forget(robot_.now(), robot_.odometry());
  const std::vector<robotlink::Vector2> points = memory_.pointsInRobot(robot_.odometry());
  const AvoidanceSituation situation{desired(points), robot_.velocity(), points, robot_.limits(),
                                     robot_.time()};
  const DriveVelocity wanted = avoidance_ == Avoidance::kVectorField ? vectorField_.decide(situation)
                                                                     : dynamicWindow_.decide(situation);
  request_ = limiter_.limit(wanted, robot_.limits(), RollingRobot::kCycle);
  robot_.drive(request_);
}

void Ride::run(double seconds, const Desired& desired) {
  for (const double end = robot_.time() + seconds; robot_.time() < end - 1e-6;) cycle(desired);
}

bool Ride::runUntil(double seconds, const Desired& desired, const std::function<bool()>& done) {
  for (const double end = robot_.time() + seconds; robot_.time() < end - 1e-6;) {
    cycle(desired);
    if (done()) return true;
  }
  return false;
}

}  // namespace modules
