// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulatedPlatform.h"

#include <algorithm>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "simcore/Scene.h"

namespace app {
namespace {

/// The first camera of the robot, as its robot frame sees it: on the ground, below the model.
void addCamera(const simcore::Simulation& simulation, const std::string& robot,
               robotcontrol::OracleWorld& to) {
  const auto cameras = simulation.cameras();
  const auto found = std::ranges::find_if(
      cameras, [&](const simcore::CameraSensor& camera) { return camera.info.robot == robot; });
  const auto pose = simulation.modelPose(robot);
  if (found == cameras.end() || !pose) return;
  const robotlink::Pose2 ground = robotlink::groundPose(*pose);
  const robotlink::Pose3 robotInField =
      Eigen::Translation3d(ground.x, ground.y, 0) *
      robotlink::Pose3(Eigen::AngleAxisd(ground.heading, Eigen::Vector3d::UnitZ()));
  const robotlink::Pose3 cameraInField =
      simulation.bodyPoses()[static_cast<std::size_t>(found->body)] * found->cameraInBody;
  auto& camera = *to.mutable_camera();
  *camera.mutable_timestamp() = to.timestamp();
  robotlink::assign(*camera.mutable_camera_in_robot(),
                    robotlink::Pose3(robotInField.inverse() * cameraInField));
  camera.set_horizontal_angle(found->model.horizontalAngle);
  camera.set_vertical_angle(found->model.verticalAngle);
  camera.set_width(static_cast<std::uint32_t>(found->model.width));
  camera.set_height(static_cast<std::uint32_t>(found->model.height));
}

}  // namespace

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
  addCamera(simulation, robot_, *oracle);
  oracle_.send(std::move(oracle));
}

}  // namespace app
