// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/simulated/SimulatedPlatform.h"

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "simcore/Scene.h"

namespace app {

SimulatedPlatform::SimulatedPlatform(SimulatedWorld& world, std::string robot)
    : Platform("platform", world.clock()),
      world_(world),
      robot_(std::move(robot)),
      oracle_(*this, robotlink::kOracleWorld.name, robotlink::Blocking::kNo) {}

robotlink::Result<void> SimulatedPlatform::control(const robotcontrol::ControlDrive& details) {
  (void)details;
  return robotlink::failure("platform.no-drive", robot_ + " has no wheels, which this needs", {}, {robot_});
}

void SimulatedPlatform::sendOracle() {
  const simcore::Simulation& simulation = world_.simulation();
  auto oracle = std::make_shared<robotcontrol::OracleWorld>();
  robotlink::assign(*oracle->mutable_timestamp(), clock().now());
  if (const auto pose = simulation.modelPose(robot_)) {
    robotlink::assign(*oracle->mutable_robot_in_field(), robotlink::groundPose(*pose));
  }
  if (const auto& balls = simulation.scene().balls(); !balls.empty()) {
    const auto ball = simulation.modelPose(balls.front());
    robotlink::assign(*oracle->mutable_ball_in_field(), robotlink::Vector3(ball->translation()));
  }
  for (const auto& robot : simulation.scene().robots()) {
    const auto pose = simulation.modelPose(robot.name);
    if (robot.name == robot_ || !pose) continue;
    auto& other = *oracle->add_others();
    other.set_name(robot.name);
    other.set_team(robot.team);
    robotlink::assign(*other.mutable_pose_in_field(), robotlink::groundPose(*pose));
  }
  oracle_.send(std::move(oracle));
}

}  // namespace app
