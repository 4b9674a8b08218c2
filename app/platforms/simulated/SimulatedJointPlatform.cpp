// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/SimulatedJointPlatform.h"

#include <array>
#include <cmath>
#include <tuple>

#include "app/platforms/simulated/world/TrueState.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"
#include "simcore/Scene.h"

namespace app {

using robotlink::Blocking;

namespace {

/// Share of the torque with which joints hold during STOP: enough not to collapse, too little to pinch.
constexpr double kStoppedTorque = 0.3;

/// Returns the index of the port with a path; -1 if there is none.
template <typename Ports>
int indexOf(const Ports& ports, const std::string& path) {
  for (std::size_t i = 0; i < ports.size(); ++i) {
    if (ports[i].info.path == path) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

SimulatedJointPlatform::SimulatedJointPlatform(SimulatedWorld& world, std::string robot)
    : SimulatedPlatform(world, std::move(robot)),
      image_(*this, robotlink::kCameraImage.name, Blocking::kNo),
      classes_(*this, robotlink::kOracleClasses.name, Blocking::kNo),
      settings_(*this),
      jointStates_(*this, robotlink::kJointStates.name, Blocking::kNo),
      bodySensors_(*this, robotlink::kBodySensors.name, Blocking::kNo),
      trueState_(*this, robotlink::kOracleState.name, Blocking::kNo),
      jointRequest_(*this, robotlink::kJointRequest.name, Blocking::kNo) {}

robotlink::Result<std::unique_ptr<SimulatedPlatform>> SimulatedJointPlatform::create(
    SimulatedWorld& world, std::string robot, const robotlink::RobotDescription& description) {
  auto platform =
      std::unique_ptr<SimulatedJointPlatform>(new SimulatedJointPlatform(world, std::move(robot)));
  if (auto bound = platform->bindJoints(description); !bound) return tl::unexpected(bound.error());
  platform->bindSensors();
  platform->bindWalk();
  return platform;
}

robotlink::Result<void> SimulatedJointPlatform::bindJoints(const robotlink::RobotDescription& description) {
  const simcore::Simulation& simulation = world().simulation();
  for (const auto& joint : description.joints) {
    const int sensor = indexOf(simulation.sensors(), robot() + "/" + joint.name + "/position");
    const int servo = indexOf(simulation.servos(), robot() + "/" + joint.name + "/request");
    if (sensor < 0 || servo < 0) {
      return robotlink::failure(
          "platform.joint",
          "robot " + robot() + " has no joint " + joint.name + ", which its description " + description.name +
              " names; correct the model or resources/robots/" + description.name + ".yaml",
          {simulation.scene().file().string(), 0, 0}, {robot(), joint.name});
    }
    joints_.push_back(
        {joint.name, static_cast<std::size_t>(sensor), static_cast<std::size_t>(servo), std::nan("")});
  }
  return {};
}

void SimulatedJointPlatform::bindSensors() {
  const simcore::Simulation& simulation = world().simulation();
  const auto sensors = simulation.sensors();
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    const simcore::PortInfo& info = sensors[i].info;
    if (info.robot != robot()) continue;
    if (info.type == "contact") contacts_.push_back(i);
    if (info.type == "acceleration") accelerometer_ = static_cast<int>(i);
    if (info.type == "distance") distance_ = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < simulation.cameras().size(); ++i) {
    if (simulation.cameras()[i].info.robot == robot()) cameras_.push_back(i);
  }
}

bool SimulatedJointPlatform::rebind() {
  const simcore::Simulation& simulation = world().simulation();
  std::vector<Joint> joints = joints_;
  for (Joint& joint : joints) {
    const int sensor = indexOf(simulation.sensors(), robot() + "/" + joint.name + "/position");
    const int servo = indexOf(simulation.servos(), robot() + "/" + joint.name + "/request");
    if (sensor < 0 || servo < 0) return false;
    joint.sensor = static_cast<std::size_t>(sensor);
    joint.servo = static_cast<std::size_t>(servo);
  }
  joints_ = std::move(joints);
  const auto had = std::tuple(cameras_.size(), contacts_.size(), accelerometer_ >= 0, distance_ >= 0);
  cameras_.clear();
  contacts_.clear();
  accelerometer_ = distance_ = -1;
  bindSensors();
  if (!rebindWalk()) return false;
  return had == std::tuple(cameras_.size(), contacts_.size(), accelerometer_ >= 0, distance_ >= 0);
}

std::optional<std::size_t> SimulatedJointPlatform::walkPort() const {
  const auto guides = world().simulation().guides();
  for (std::size_t i = 0; i < guides.size(); ++i) {
    const bool isOwn = guides[i].info.robot == robot();
    if (isOwn && guides[i].motion.kind == simcore::GuidedMotion::Kind::kWalk) return i;
  }
  return std::nullopt;
}

void SimulatedJointPlatform::bindWalk() {
  const auto port = walkPort();
  if (!port) return;
  walk_ = *port;
  motionStatus_.emplace(*this, robotlink::kMotionStatus.name, Blocking::kNo);
}

bool SimulatedJointPlatform::rebindWalk() {
  const auto port = walkPort();
  if (port) walk_ = *port;
  return port.has_value() == motionStatus_.has_value();
}

void SimulatedJointPlatform::walk(double x, double y, double rotation) {
  world().simulation().guide(walk_, std::array{x, y, rotation});
}

void SimulatedJointPlatform::holdStill() {
  if (motionStatus_) walk(0, 0, 0);
  if (holding_) return;
  holding_ = true;
  simcore::Simulation& simulation = world().simulation();
  for (const Joint& joint : joints_) {
    simulation.requestAngle(joint.servo, simulation.sensors()[joint.sensor].values[0]);
    simulation.setTorqueLimit(joint.servo, kStoppedTorque);
  }
}

void SimulatedJointPlatform::actuate() {
  if (mustStand()) {
    holdStill();
    return;
  }
  const robotcontrol::JointRequest* request = jointRequest_.get();
  if (request == nullptr) return;
  holding_ = false;
  if (motionStatus_ && motionStatus_->get() != nullptr) {
    const robotcontrol::Velocity2& velocity = motionStatus_->get()->velocity();
    walk(velocity.x(), velocity.y(), velocity.rotation());
  }
  const double torque = std::isfinite(request->stiffness()) ? request->stiffness() : 1;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    world().simulation().setTorqueLimit(joints_[i].servo, torque);
    const int index = static_cast<int>(i);
    if (index >= request->positions_size() || !std::isfinite(request->positions(index))) continue;
    world().simulation().requestAngle(joints_[i].servo, request->positions(index));
  }
}

void SimulatedJointPlatform::execute() {
  sendJoints();
  sendBody();
  sendOracle();
  sendTrueState();
  exchangeGame();
  sendImages();
}

void SimulatedJointPlatform::sendJoints() {
  auto states = std::make_shared<foxglove::JointStates>();
  robotlink::assign(*states->mutable_timestamp(), clock().now());
  const auto sensors = world().simulation().sensors();
  for (Joint& joint : joints_) {
    const double angle = sensors[joint.sensor].values[0];
    auto& state = *states->add_joints();
    state.set_name(joint.name);
    state.set_position(angle);
    if (std::isfinite(joint.lastAngle)) {
      state.set_velocity((angle - joint.lastAngle) / robotlink::seconds(SimulatedWorld::kStep));
    }
    state.set_effort(world().simulation().servoTorque(joint.servo));
    joint.lastAngle = angle;
  }
  jointStates_.send(std::move(states));
}

void SimulatedJointPlatform::sendBody() {
  auto body = std::make_shared<robotcontrol::BodySensors>();
  robotlink::assign(*body->mutable_timestamp(), clock().now());
  const auto sensors = world().simulation().sensors();
  if (accelerometer_ >= 0) {
    const auto& a = sensors[static_cast<std::size_t>(accelerometer_)].values;
    robotlink::assign(*body->mutable_acceleration(), robotlink::Vector3(a[0], a[1], a[2]));
  }
  if (distance_ >= 0) body->set_distance(sensors[static_cast<std::size_t>(distance_)].values[0]);
  // A robot that is moved without forces stands on the ground, though nothing presses its paws.
  const bool isGuided = motionStatus_.has_value();
  for (const std::size_t contact : contacts_)
    body->add_paw_contacts(isGuided || sensors[contact].values[0] > 0.5);
  bodySensors_.send(std::move(body));
}

void SimulatedJointPlatform::sendTrueState() {
  auto state = std::make_shared<robotcontrol::RobotState>(trueState(world().simulation(), robot()));
  robotlink::assign(*state->mutable_timestamp(), clock().now());
  trueState_.send(std::move(state));
}

void SimulatedJointPlatform::sendImages() {
  for (const std::size_t camera : cameras_) {
    if (!world().imageDue(camera)) continue;
    auto image = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*image, world().render(camera).view(), clock().now(), robot() + "/camera");
    image_.send(image);
    if (classesAlways_ || classes_.connected()) sendClasses(*image);
  }
  if (settings_.isWanted()) settings_.send(cameraSettings(), clock().now());
}

namespace {

/// A setting of a simulated camera.
struct SimulatedSetting {
  const char *name, *title;
  double SimulatedWorld::CameraSetting::*value;
  double minimum, maximum;
};
constexpr SimulatedSetting kSimulatedSettings[]{
    {"exposure", "Exposure", &SimulatedWorld::CameraSetting::exposure, 0.1, 4},
    {"gain", "Gain", &SimulatedWorld::CameraSetting::gain, 0.25, 4},
    {"white_balance", "White balance", &SimulatedWorld::CameraSetting::whiteBalance,
     -simcore::LightAdjustment::kMaxWhiteBalance, simcore::LightAdjustment::kMaxWhiteBalance},
};

}  // namespace

robotcontrol::CameraSettings SimulatedJointPlatform::cameraSettings() const {
  robotcontrol::CameraSettings settings;
  if (cameras_.empty()) return settings;
  const SimulatedWorld::CameraSetting initial;
  for (const SimulatedSetting& each : kSimulatedSettings) {
    auto& setting = *settings.add_settings();
    setting.set_name(each.name);
    setting.set_title(each.title);
    setting.set_value(world().cameraSetting(cameras_.front()).*each.value);
    setting.set_minimum(each.minimum);
    setting.set_maximum(each.maximum);
    setting.set_step(0.05);
    setting.set_initial(initial.*each.value);
  }
  return settings;
}

robotlink::Result<void> SimulatedJointPlatform::setCamera(const robotcontrol::SetCamera& details) {
  if (cameras_.empty()) return SimulatedPlatform::setCamera(details);
  if (auto checked = checkCameraSetting(cameraSettings(), details.setting(), details.value()); !checked)
    return checked;
  for (const SimulatedSetting& each : kSimulatedSettings) {
    if (details.setting() != each.name) continue;
    for (const std::size_t camera : cameras_) world().cameraSetting(camera).*each.value = details.value();
  }
  return {};
}

void SimulatedJointPlatform::alwaysSendClasses(LabeledListener listener) {
  classesAlways_ = true;
  labeledListener_ = std::move(listener);
}

void SimulatedJointPlatform::sendClasses(const foxglove::RawImage& image) {
  auto classes = std::make_shared<foxglove::RawImage>();
  robotlink::assign(*classes, world().trueClasses().view(), clock().now(), image.frame_id());
  classes_.send(classes);
  if (labeledListener_) labeledListener_(image, *classes);
}

}  // namespace app
