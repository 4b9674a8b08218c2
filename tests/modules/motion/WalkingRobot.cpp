// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/motion/WalkingRobot.h"

#include <google/protobuf/text_format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include "MotionParameters.pb.h"
#include "modules/motion/ParameterConversion.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/motions/MotionLibrary.h"
#include "simcore/Scene.h"

namespace modules {
namespace {

template <typename R>
auto loaded(R result) {
  if (result) return std::move(*result);
  if constexpr (requires { result.error().describe(); }) {
    std::cerr << result.error().describe() << std::endl;
  } else {
    std::cerr << robotlink::describe(result.error()) << std::endl;
  }
  std::abort();
}

template <typename Ports>
std::size_t portIndex(const Ports& ports, const std::string& path) {
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (ports[i].info.path == path) return i;
  }
  std::cerr << "there is no port " << path << std::endl;
  std::abort();
}

}  // namespace

GaitParameters shippedGait(const std::filesystem::path& resources, FootMode mode) {
  return shippedGait(
      resources, mode == FootMode::kRectangle ? "wheel-model-rectangle" : "wheel-model-half-ellipse", mode);
}

GaitParameters shippedGait(const std::filesystem::path& resources, const std::string& solution,
                           FootMode mode) {
  std::ifstream file(resources / "parameters/ers210" / ("motion." + solution + ".textproto"));
  std::stringstream text;
  text << file.rdbuf();
  robotcontrol::GaitMotionParameters message;
  if (!google::protobuf::TextFormat::ParseFromString(text.str(), &message)) {
    loaded(
        robotlink::Result<int>(robotlink::failure("walking.gait", "the gait cannot be read: " + solution)));
  }
  return gaitParameters(message, mode);
}

WalkingRobot::WalkingRobot(const Options& options) {
  const auto scene = loaded(simcore::Scene::load(
      options.scene.empty() ? options.resources / "scenes/field2002.sdf" : options.scene));
  simulation_ = loaded(simcore::Simulation::create(scene, {options.seed, true}));
  robot_ = scene->robots().front().name;
  const auto description = loaded(robotlink::readRobotDescription(
      options.resources / "robots" / (scene->robots().front().description + ".yaml")));
  auto layout = loaded(JointLayout::of(description.joints));
  auto motions = loaded(robotlink::loadMotions(options.resources / "motions", layout.names()));
  for (const std::string& joint : layout.names()) {
    servos_.push_back(portIndex(simulation_->servos(), robot_ + "/" + joint + "/request"));
    angles_.push_back(portIndex(simulation_->sensors(), robot_ + "/" + joint + "/position"));
  }
  accelerometer_ = portIndex(simulation_->sensors(), robot_ + "/accelerometer");
  engine_ = std::make_unique<MotionEngine>(layout, motions, options.gait, options.motion);
  std::vector<double> angles;
  for (const std::size_t sensor : angles_) angles.push_back(simulation_->sensors()[sensor].values[0]);
  engine_->start(angles);
}

void WalkingRobot::frame(const MotionCommand& desired) {
  const auto& values = simulation_->sensors()[accelerometer_].values;
  const robotlink::Vector3 acceleration(values[0], values[1], values[2]);
  engine_->advance({desired, head_, &acceleration, std::chrono::milliseconds(8)});
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    simulation_->requestAngle(servos_[i], engine_->positions()[i]);
    simulation_->setTorqueLimit(servos_[i], engine_->stiffness());
  }
  simulation_->step();
  simulation_->step();
}

void WalkingRobot::run(const MotionCommand& desired, double seconds) {
  for (int i = 0; i < static_cast<int>(seconds / 0.008); ++i) frame(desired);
}

WalkingRobot::Measured WalkingRobot::walk(const WalkSpeed& speed, double seconds) {
  const MotionCommand desired{MotionCommand::Kind::kWalk, speed, {}};
  run({}, 1);
  run(desired, 1.5);
  Measured result;
  const int cycle = engine_->gait().parameters().stepFrames;
  const int frames = static_cast<int>(seconds / 0.008) / cycle * cycle;
  robotlink::Pose2 last = robotlink::groundPose(pose());
  for (int i = 1; i <= frames; ++i) {
    frame(desired);
    result.leastUpright = std::min(result.leastUpright, upright());
    if (i % cycle != 0) continue;
    // Whole cycles, each in the direction in which the robot stood in its middle.
    const robotlink::Pose2 now = robotlink::groundPose(pose());
    const robotlink::Pose2 move = last.inverse() * now;
    const robotlink::Vector2 way = robotlink::Pose2{0, 0, -move.heading / 2} * move.translation();
    result.speed.x += way.x();
    result.speed.y += way.y();
    result.speed.rotation += move.heading;
    last = now;
  }
  const double time = frames * 0.008;
  result.speed = {result.speed.x / time, result.speed.y / time, result.speed.rotation / time};
  return result;
}

void WalkingRobot::placeRobot(const robotlink::Pose2& pose) {
  if (const auto placed = simulation_->placeModel(robot_, pose); !placed)
    loaded(robotlink::Result<int>(tl::unexpected(placed.error())));
}

void WalkingRobot::placeBall(const robotlink::Vector2& position) {
  const robotlink::Vector2 at = robotlink::groundPose(pose()) * position;
  if (const auto placed = simulation_->placeModel("ball", {at.x(), at.y(), 0}); !placed) {
    loaded(robotlink::Result<int>(tl::unexpected(placed.error())));
  }
}

}  // namespace modules
