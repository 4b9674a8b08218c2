// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/Actuation.h"

#include <algorithm>
#include <cmath>

#include "robotlink/base/Random.h"
#include "simcore/devices/VehicleMotion.h"
#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

// A command is reached within this share of the range of the actuator.
constexpr double kReached = 0.01;
// How many commands of a servo may wait: one in each step of the longest delay.
constexpr std::size_t kMaxWaiting = 256;
/// A guided model is pushed with at most this multiple of the force that its acceleration needs; the rest is
/// for friction and slopes.
constexpr double kPushReserve = 3;

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

}  // namespace

Actuation::Actuation(Physics& physics, const Ports& ports)
    : physics_(physics), ports_(ports), guides_(ports.guides.size()) {
  for (const ServoState& state : ports.servoStates) servos_.push_back({state, {}, 0, true});
}

void Actuation::command(std::size_t servo, double value, std::uint64_t step) {
  if (std::isnan(value)) return;
  const Servo& limits = ports_.servos[servo];
  ServoMotor& motor = servos_[servo];
  motor.unobstructed = true;
  const double clamped = std::clamp(value, limits.minimum, limits.maximum);
  const auto delay = static_cast<std::uint64_t>(std::ceil(limits.control.delay / kStepSeconds - 1e-6));
  if (delay == 0) {
    motor.state.target = clamped;
    return;
  }
  if (!motor.waiting.empty() && motor.waiting.back().step == step + delay) motor.waiting.pop_back();
  if (motor.waiting.size() < kMaxWaiting) motor.waiting.push_back({step + delay, clamped});
}

void Actuation::guide(std::size_t guide, std::span<const double> values) {
  const bool fits = values.size() == static_cast<std::size_t>(ports_.guides[guide].info.shape[0]);
  if (!fits || !std::ranges::all_of(values, [](double value) { return std::isfinite(value); })) return;
  std::ranges::copy(values, guides_[guide].wanted.begin());
  guides_[guide].unobstructed = true;
}

void Actuation::takeOver(std::size_t servo, const Actuation& from, std::size_t fromServo,
                         std::uint64_t later) {
  const Servo& limits = ports_.servos[servo];
  const ServoMotor& before = from.servos_[fromServo];
  ServoMotor& motor = servos_[servo];
  motor.waiting = before.waiting;
  for (auto& command : motor.waiting) command.step += later;
  motor.integral = before.integral;
  motor.state.target = std::clamp(before.state.target, limits.minimum, limits.maximum);
  motor.state.torqueShare = before.state.torqueShare;
}

void Actuation::transferServo(StateStream& stream, std::size_t index) {
  const Servo& limits = ports_.servos[index];
  ServoMotor& motor = servos_[index];
  // A joint may begin outside of its servo's range.
  stream.number(motor.state.target);
  stream.within(motor.state.torqueShare, 0, 1);
  stream.size(motor.waiting, kMaxWaiting);
  for (Command& command : motor.waiting) {
    stream.raw(command.step);
    stream.within(command.value, limits.minimum, limits.maximum);
  }
  stream.number(motor.integral);
  stream.flag(motor.unobstructed);
}

void Actuation::transfer(StateStream& stream) {
  for (std::size_t i = 0; i < servos_.size(); ++i) transferServo(stream, i);
  for (GuideMotor& motor : guides_) {
    for (double& value : motor.wanted) stream.within(value, -1e300, 1e300);
    for (double& value : motor.present) stream.within(value, -1e300, 1e300);
    stream.vector(motor.velocity);
    stream.vector(motor.rate);
    stream.flag(motor.unobstructed);
  }
}

void Actuation::beforeStep(std::uint64_t step, const Randomness& random) {
  // Vehicles command the servos that steer them.
  for (std::size_t i = 0; i < guides_.size(); ++i) {
    switch (ports_.guideMeans[i].kind) {
      case GuideMeans::Kind::kPushed:
        push(i);
        break;
      case GuideMeans::Kind::kWheels:
        roll(i);
        break;
      case GuideMeans::Kind::kFollows:
        follow(i, step, random);
        break;
    }
  }
  for (std::size_t i = 0; i < servos_.size(); ++i) {
    ServoMotor& motor = servos_[i];
    while (!motor.waiting.empty() && motor.waiting.front().step <= step) {
      motor.state.target = motor.waiting.front().value;
      motor.waiting.pop_front();
    }
    drive(i);
  }
}

void Actuation::drive(std::size_t index) {
  const Servo& servo = ports_.servos[index];
  ServoMotor& motor = servos_[index];
  const ServoState& state = motor.state;
  const double limit = servo.maximumTorque * state.torqueShare;
  switch (servo.control.kind) {
    case MotorControl::Kind::kPosition:
      return servo.control.usesGains() ? driveByGains(servo, motor) : drivePosition(servo, motor);
    case MotorControl::Kind::kVelocity:
      return physics_.setMotor(state.hinge, state.target, limit);
    case MotorControl::Kind::kTorque:
      return exert(servo, state.hinge, std::clamp(state.target, -limit, limit));
  }
}

void Actuation::exert(const Servo& servo, std::size_t hinge, double torque) const {
  // A motor that is far from its speed exerts all of its torque.
  physics_.setMotor(hinge, std::copysign(servo.maximumSpeed, torque), std::abs(torque));
}

void Actuation::drivePosition(const Servo& servo, ServoMotor& motor) const {
  const ServoState& state = motor.state;
  const double missing = state.target - physics_.angle(state.hinge);
  const double speed =
      std::clamp(kStiffServoShare * missing / kStepSeconds, -servo.maximumSpeed, servo.maximumSpeed);
  physics_.setMotor(state.hinge, speed, servo.maximumTorque * state.torqueShare);
}

void Actuation::driveByGains(const Servo& servo, ServoMotor& motor) const {
  const ServoState& state = motor.state;
  const MotorControl& control = servo.control;
  const double limit = servo.maximumTorque * state.torqueShare;
  const double missing = state.target - physics_.angle(state.hinge);
  const double rate = physics_.rate(state.hinge);
  const double more = motor.integral + missing * kStepSeconds;
  const double torque = control.p * missing + control.i * more - control.d * rate;
  // The integral does not grow while the motor is at its limit (anti-windup).
  if (std::abs(torque) < limit || torque * missing < 0) motor.integral = more;
  exert(servo, state.hinge, std::clamp(torque, -limit, limit));
}

void Actuation::wantedMotion(const GuidedMotion& motion, const std::array<double, 6>& wanted,
                             Vector3& velocity, Vector3& rate) {
  velocity.setZero();
  rate.setZero();
  switch (motion.kind) {
    case GuidedMotion::Kind::kFree:
      velocity = {wanted[0], wanted[1], wanted[2]};
      rate = {wanted[3], wanted[4], wanted[5]};
      break;
    case GuidedMotion::Kind::kOmni:
    case GuidedMotion::Kind::kWalk:
      velocity = {wanted[0], wanted[1], 0};
      rate.z() = wanted[2];
      break;
    case GuidedMotion::Kind::kDifferential:
    case GuidedMotion::Kind::kSkid: {
      const double left = std::clamp(wanted[0], -motion.maximumSpeed, motion.maximumSpeed);
      const double right = std::clamp(wanted[1], -motion.maximumSpeed, motion.maximumSpeed);
      velocity.x() = (left + right) / 2;
      rate.z() = (right - left) / motion.track;
      if (motion.kind == GuidedMotion::Kind::kSkid) rate.z() *= motion.skid;
      break;
    }
    case GuidedMotion::Kind::kAckermann: {
      const double steering = std::clamp(wanted[1], -motion.maximumSteering, motion.maximumSteering);
      velocity.x() = std::clamp(wanted[0], -motion.maximumSpeed, motion.maximumSpeed);
      rate.z() = velocity.x() * std::tan(steering) / motion.wheelbase;
      break;
    }
  }
  if (velocity.norm() > motion.maximumSpeed) velocity *= motion.maximumSpeed / velocity.norm();
  if (rate.norm() > motion.maximumRate) rate *= motion.maximumRate / rate.norm();
}

void Actuation::push(std::size_t index) {
  const GuidedMotion& motion = ports_.guides[index].motion;
  GuideMotor& motor = guides_[index];
  const int model = ports_.guideModels[index];
  Vector3 velocity, rate;
  wantedMotion(motion, motor.wanted, velocity, rate);
  for (int k = 0; k < 3; ++k) {
    motor.velocity[k] = towards(motor.velocity[k], velocity[k], motion.acceleration * kStepSeconds);
    motor.rate[k] = towards(motor.rate[k], rate[k], motion.angularAcceleration * kStepSeconds);
  }
  const Pose3 pose = physics_.modelInWorld(model);
  Eigen::Matrix3d axes = pose.linear();
  if (motion.kind != GuidedMotion::Kind::kFree) {
    axes = Eigen::AngleAxisd(robotlink::groundPose(pose).heading, Vector3::UnitZ()).toRotationMatrix();
  }
  const Vector3 turning = axes * motor.rate;
  // The velocity is that of the model's origin; the motor pushes its first body's center.
  const Vector3 arm = physics_.firstCenter(model) - pose.translation();
  const double mass = physics_.massOf(model);
  const double force = kPushReserve * mass * (motion.acceleration + 9.81);
  physics_.setGuide(model, axes * motor.velocity + turning.cross(arm), turning, force,
                    kPushReserve * physics_.inertiaOf(model) * motion.angularAcceleration);
}

std::array<double, 6> Actuation::approached(std::size_t index) {
  const GuidedMotion& motion = ports_.guides[index].motion;
  const GuideMeans& means = ports_.guideMeans[index];
  GuideMotor& motor = guides_[index];
  std::array<double, 6> wanted = motor.wanted;
  if (means.vehicle != nullptr) wanted = limitedCommand(motion, *means.vehicle, wanted);
  const bool steers = motion.kind == GuidedMotion::Kind::kAckermann;
  const bool byTorque = means.kind == GuideMeans::Kind::kWheels && means.vehicle->byTorque;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    // The servo limits how fast a wheel is steered, the wheels' inertia what a torque does.
    if (byTorque || (steers && i == 1)) {
      motor.present[i] = wanted[i];
      continue;
    }
    const double limit = i == 2 ? motion.angularAcceleration : motion.acceleration;
    motor.present[i] = towards(motor.present[i], wanted[i], limit * kStepSeconds);
  }
  return motor.present;
}

void Actuation::turnWheels(const GuidedMotion& motion, const GuideMeans& means,
                           const std::array<double, 6>& command) {
  const VehicleDescription& vehicle = *means.vehicle;
  const bool byTorque = vehicle.byTorque && means.kind == GuideMeans::Kind::kWheels;
  for (std::size_t i = 0; i < vehicle.wheels.size(); ++i) {
    const VehicleWheel& wheel = vehicle.wheels[i];
    if (wheel.steering >= 0) {
      const auto joint = static_cast<std::size_t>(wheel.steering);
      servos_[means.steering[joint]].state.target =
          vehicle.steeringSigns[joint] * steeringAngle(motion, wheel, command[1]);
    }
    if (!wheel.driven) continue;
    const double value = rimSpeed(motion, vehicle, wheel, command);
    if (!byTorque) {
      physics_.setWheel(means.firstWheel + i, value, wheel.maximumForce, true);
      continue;
    }
    const bool isLeft = motion.kind == GuidedMotion::Kind::kAckermann || wheel.center.y() > 0;
    const double force =
        std::clamp(command[isLeft ? 0 : 1] / wheel.radius, -wheel.maximumForce, wheel.maximumForce);
    physics_.setWheel(means.firstWheel + i, std::copysign(wheel.maximumSpeed, force), std::abs(force),
                      force != 0);
  }
}

void Actuation::roll(std::size_t index) {
  turnWheels(ports_.guides[index].motion, ports_.guideMeans[index], approached(index));
}

void Actuation::follow(std::size_t index, std::uint64_t step, const Randomness& random) {
  const GuidedMotion& motion = ports_.guides[index].motion;
  const GuideMeans& means = ports_.guideMeans[index];
  const std::array<double, 6> command = approached(index);
  PlaneMotion moved = motionOf(motion, means.vehicle, command);
  const double speed = std::hypot(moved.ahead, moved.sideways);
  if (speed > motion.maximumSpeed) {
    moved.ahead *= motion.maximumSpeed / speed;
    moved.sideways *= motion.maximumSpeed / speed;
  }
  moved.turning = std::clamp(moved.turning, -motion.maximumRate, motion.maximumRate);
  if (means.vehicle != nullptr) turnWheels(motion, means, command);
  if (means.walk != nullptr) {
    robotlink::Random numbers(random.seed, hashOfPath(ports_.guides[index].info.path) ^ step);
    const double way = (std::hypot(moved.ahead, moved.sideways) + std::abs(moved.turning)) * kStepSeconds;
    double* const parts[] = {&moved.ahead, &moved.sideways, &moved.turning};
    for (std::size_t i = 0; i < 3; ++i) {
      *parts[i] *= means.walk->slip[i];
      if (random.noise) *parts[i] += means.walk->noise[i] * std::sqrt(way) * numbers.normal() / kStepSeconds;
    }
  }
  physics_.follow(ports_.guideModels[index], moved.ahead, moved.sideways, moved.turning);
}

void Actuation::afterStep() {
  const std::span<const ObstacleTouch> touches = physics_.obstacleTouches();
  for (std::size_t i = 0; i < servos_.size() && !touches.empty(); ++i) {
    const bool meets = std::ranges::any_of(ports_.servoBodies[i], [&](std::size_t body) {
      return std::ranges::find(touches, body, &ObstacleTouch::body) != touches.end();
    });
    if (meets) servos_[i].unobstructed = false;
  }
  for (std::size_t i = 0; i < guides_.size(); ++i) {
    if (physics_.touchedObstacle(ports_.guideModels[i])) guides_[i].unobstructed = false;
  }
}

ActuatorState Actuation::servoState(std::size_t index) const {
  const Servo& servo = ports_.servos[index];
  const ServoMotor& motor = servos_[index];
  double present = 0;
  if (servo.control.kind == MotorControl::Kind::kPosition) present = physics_.angle(motor.state.hinge);
  if (servo.control.kind == MotorControl::Kind::kVelocity) present = physics_.rate(motor.state.hinge);
  if (servo.control.kind == MotorControl::Kind::kTorque) present = physics_.torque(motor.state.hinge);
  const double target = motor.waiting.empty() ? motor.state.target : motor.waiting.back().value;
  return {std::abs(present - target) <= kReached * (servo.maximum - servo.minimum), motor.unobstructed};
}

void Actuation::takeOverGuide(std::size_t guide, const Actuation& from, std::size_t fromGuide) {
  guides_[guide] = from.guides_[fromGuide];
}

ActuatorState Actuation::guideState(std::size_t index) const {
  const GuidedMotion& motion = ports_.guides[index].motion;
  const GuideMeans& means = ports_.guideMeans[index];
  const bool byTorque = means.kind == GuideMeans::Kind::kWheels && means.vehicle->byTorque;
  if (byTorque) return {true, guides_[index].unobstructed};
  Vector3 velocity, rate;
  wantedMotion(motion, guides_[index].wanted, velocity, rate);
  if (means.vehicle != nullptr) {
    const PlaneMotion wanted =
        motionOf(motion, means.vehicle, limitedCommand(motion, *means.vehicle, guides_[index].wanted));
    velocity = {wanted.ahead, wanted.sideways, 0};
  }
  const int model = ports_.guideModels[index];
  const Pose3 pose = physics_.modelInWorld(model);
  const Vector3 present = pose.linear().transpose() * physics_.velocityOfModel(model);
  return {(present - velocity).norm() <= kReached * 2 * motion.maximumSpeed, guides_[index].unobstructed};
}

}  // namespace simcore
