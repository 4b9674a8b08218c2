// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/ExactSensing.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

using SourceKind = SensorSource::Kind;

/// Returns the pose of a body on the ground that moves with constant speeds along a circle.
robotlink::Pose2 alongArc(const robotlink::Pose2& from, double way, double turn) {
  const double direction = from.heading + turn / 2;
  const double chord = std::abs(turn) < 1e-9 ? way : way * std::sin(turn / 2) / (turn / 2);
  return {from.x + chord * std::cos(direction), from.y + chord * std::sin(direction),
          robotlink::normalizedAngle(from.heading + turn)};
}

}  // namespace

ExactSensing::ExactSensing(const Physics& physics, const std::vector<SensorSource>& sources,
                           const WorldDescription& world)
    : physics_(physics), sources_(sources), world_(world), memories_(sources.size()) {
  for (std::size_t i = 0; i < sources_.size(); ++i) start(i);
}

void ExactSensing::start(std::size_t index) {
  const SensorSource& source = sources_[index];
  Memory& memory = memories_[index];
  memory.specificForce = -world_.gravity;
  if (source.kind == SourceKind::kAltimeter) memory.height = poseOf(source).translation().z();
  if (source.kind == SourceKind::kOdometry) memory.before = robotlink::groundPose(poseOf(source));
  if (source.kind == SourceKind::kBattery) memory.energy = source.battery.capacity * source.battery.charge;
}

void ExactSensing::afterStep() {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const SensorSource& source = sources_[i];
    if (source.kind == SourceKind::kAccelerometer) accelerate(source, memories_[i]);
    if (source.kind == SourceKind::kOdometry) drive(source, memories_[i]);
    if (source.kind == SourceKind::kBattery) discharge(source, memories_[i]);
  }
}

void ExactSensing::accelerate(const SensorSource& source, Memory& memory) const {
  const Vector3 point = physics_.linkInWorld(source.body) * source.poseInLink.translation();
  const Vector3 velocity = physics_.velocityAt(source.body, point);
  memory.specificForce = (velocity - memory.velocity) / kStepSeconds - world_.gravity;
  memory.velocity = velocity;
}

void ExactSensing::drive(const SensorSource& source, Memory& memory) const {
  const robotlink::Pose2 now = robotlink::groundPose(poseOf(source));
  if (source.drive < 0) {
    // Without wheels, the steps that were made are added up.
    const double dx = now.x - memory.before.x, dy = now.y - memory.before.y;
    const double turned = memory.odometry.heading - memory.before.heading;
    memory.odometry.x += std::cos(turned) * dx - std::sin(turned) * dy;
    memory.odometry.y += std::sin(turned) * dx + std::cos(turned) * dy;
    memory.odometry.heading =
        robotlink::normalizedAngle(memory.odometry.heading + now.heading - memory.before.heading);
  } else {
    const auto side = 2 * static_cast<std::size_t>(source.drive);
    const double left = physics_.sideState(side).travel, right = physics_.sideState(side + 1).travel;
    const double leftWay = left - memory.left, rightWay = right - memory.right;
    memory.odometry =
        alongArc(memory.odometry, (leftWay + rightWay) / 2, (rightWay - leftWay) / source.track);
    memory.left = left;
    memory.right = right;
  }
  memory.before = now;
}

void ExactSensing::discharge(const SensorSource& source, Memory& memory) const {
  const double power =
      source.battery.idlePower + physics_.motorPower(source.model) / source.battery.efficiency;
  memory.energy = std::max(0.0, memory.energy - power * kStepSeconds);
}

void ExactSensing::transfer(StateStream& stream) {
  for (Memory& memory : memories_) {
    stream.vector(memory.velocity);
    for (int i = 0; i < 3; ++i) stream.within(memory.specificForce[i], -1e12, 1e12);
    stream.pose(memory.odometry);
    for (double* travel : {&memory.left, &memory.right}) stream.within(*travel, -1e12, 1e12);
    stream.pose(memory.before);
    stream.number(memory.height);
    stream.within(memory.energy, 0, 1e15);
  }
}

void ExactSensing::forgetVelocitiesOf(int model) {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (sources_[i].model != model) continue;
    memories_[i].velocity = Vector3::Zero();
    memories_[i].specificForce = -world_.gravity;
    if (sources_[i].kind == SourceKind::kOdometry)
      memories_[i].before = robotlink::groundPose(poseOf(sources_[i]));
  }
}

void ExactSensing::adoptVelocitiesOf(int model) {
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const SensorSource& source = sources_[i];
    if (source.model != model) continue;
    if (source.kind == SourceKind::kOdometry) {
      memories_[i].before = robotlink::groundPose(poseOf(source));
      if (source.drive >= 0) {
        const auto side = 2 * static_cast<std::size_t>(source.drive);
        memories_[i].left = physics_.sideState(side).travel;
        memories_[i].right = physics_.sideState(side + 1).travel;
      }
    }
    if (source.kind != SourceKind::kAccelerometer) continue;
    const Vector3 point = physics_.linkInWorld(source.body) * source.poseInLink.translation();
    memories_[i].velocity = physics_.velocityAt(source.body, point);
    memories_[i].specificForce = -world_.gravity;
  }
}

double ExactSensing::contactOf(const SensorSource& source) const {
  if (source.collision >= 0) return physics_.touched(source.body, source.collision) ? 1 : 0;
  for (int i = 0; i < source.collisions; ++i) {
    if (physics_.touched(source.body, i)) return 1;
  }
  return 0;
}

void ExactSensing::readJoint(const SensorSource& source, std::vector<double>& values) const {
  if (source.kind == SourceKind::kAngle || source.kind == SourceKind::kSlide)
    values[0] = physics_.angle(source.hinge);
  if (source.kind == SourceKind::kJointSpeed) values[0] = physics_.rate(source.hinge);
  if (source.kind == SourceKind::kJointLoad) values[0] = physics_.torque(source.hinge);
  if (source.kind != SourceKind::kForceTorque) return;
  const Physics::Wrench wrench =
      source.isFixed ? physics_.fixedReaction(source.hinge) : physics_.reaction(source.hinge);
  const Eigen::Matrix3d worldInLink = physics_.linkInWorld(source.body).linear().transpose();
  Eigen::Map<Vector3>(values.data()) = source.sign * (worldInLink * wrench.force);
  Eigen::Map<Vector3>(values.data() + 3) = source.sign * (worldInLink * wrench.torque);
}

void ExactSensing::readPlace(const SensorSource& source, const Memory& memory,
                             std::vector<double>& values) const {
  const Pose3 pose = poseOf(source);
  switch (source.kind) {
    case SourceKind::kDistance:
      values[0] = physics_.castRay(pose.translation(), pose.linear().col(0), source.maximum, source.model);
      break;
    case SourceKind::kWhisker: {
      const double distance =
          physics_.castRay(pose.translation(), pose.linear().col(0), source.length, source.model);
      values[0] = distance < source.length ? 1 : 0;
      break;
    }
    case SourceKind::kMagnetometer:
      Eigen::Map<Vector3>(values.data()) = pose.linear().transpose() * world_.magneticField;
      break;
    case SourceKind::kOdometry:
      values[0] = memory.odometry.x;
      values[1] = memory.odometry.y;
      values[2] = memory.odometry.heading;
      break;
    default:
      break;
  }
}

void ExactSensing::readMotion(const SensorSource& source, const Memory& memory,
                              std::vector<double>& values) const {
  const Pose3 pose = poseOf(source);
  const Vector3 velocity = physics_.velocityAt(source.body, pose.translation());
  switch (source.kind) {
    case SourceKind::kGyroscope:
      Eigen::Map<Vector3>(values.data()) =
          pose.linear().transpose() * physics_.angularVelocityOf(source.body);
      break;
    case SourceKind::kAccelerometer:
      Eigen::Map<Vector3>(values.data()) = pose.linear().transpose() * memory.specificForce;
      break;
    case SourceKind::kNavSat:
      Eigen::Map<Vector3>(values.data()) = pose.translation();
      Eigen::Map<Vector3>(values.data() + 3) = velocity;
      break;
    case SourceKind::kAltimeter:
      values[0] = pose.translation().z() - memory.height;
      values[1] = velocity.z();
      break;
    default:
      break;
  }
}

void ExactSensing::read(std::size_t index, std::vector<double>& values) const {
  const SensorSource& source = sources_[index];
  const Memory& memory = memories_[index];
  switch (source.kind) {
    case SourceKind::kAngle:
    case SourceKind::kSlide:
    case SourceKind::kJointSpeed:
    case SourceKind::kJointLoad:
    case SourceKind::kForceTorque:
      return readJoint(source, values);
    case SourceKind::kWheelAngle:
      values[0] = physics_.wheelState(source.hinge).travel / source.length;
      return;
    case SourceKind::kWheelSpeed:
      values[0] = physics_.wheelState(source.hinge).speed / source.length;
      return;
    case SourceKind::kContact:
      values[0] = contactOf(source);
      return;
    case SourceKind::kBattery: {
      const BatteryDescription& battery = source.battery;
      const double charge = memory.energy / battery.capacity;
      values[0] = battery.emptyVoltage + charge * (battery.fullVoltage - battery.emptyVoltage);
      values[1] = charge;
      return;
    }
    case SourceKind::kDistance:
    case SourceKind::kWhisker:
    case SourceKind::kMagnetometer:
    case SourceKind::kOdometry:
      return readPlace(source, memory, values);
    case SourceKind::kGyroscope:
    case SourceKind::kAccelerometer:
    case SourceKind::kNavSat:
    case SourceKind::kAltimeter:
      return readMotion(source, memory, values);
  }
}

}  // namespace simcore
