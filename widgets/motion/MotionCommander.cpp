// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionCommander.h"

#include <algorithm>
#include <cmath>

#include "robotcontrol/Motion.pb.h"

namespace widgets {
namespace {

constexpr int kResendTicks = 3;   // 10 Hz at 30 ticks a second
constexpr int kMotionTicks = 30;  // a second
using Kind = robotcontrol::MotionRequest;

}  // namespace

void MotionCommander::setAxes(const WalkAxes& axes) {
  axes_ = axes;
  velocity_.reset();
  if (!axes.zero()) releaseJoints();
}

void MotionCommander::setHead(const HeadTarget& head) {
  for (const HeadJoint& joint : kHeadJoints) {
    if (head.*joint.angle != head_.*joint.angle) joints_.erase(joint.joint);
  }
  head_ = head;
}

void MotionCommander::walk(const Speed& velocity) {
  velocity_ = velocity;
  releaseJoints();
}

void MotionCommander::setJoint(const std::string& joint, double angle) {
  joints_[joint] = angle;
  turnsJoints_ = true;
  limp_ = false;
  velocity_.reset();
  motion_.clear();
}

void MotionCommander::setLimp(bool limp) {
  if (limp == limp_) return;
  limp_ = limp;
  turnsJoints_ = true;
  joints_.clear();
  velocity_.reset();
  motion_.clear();
}

void MotionCommander::releaseJoints() {
  joints_.clear();
  turnsJoints_ = limp_ = false;
}

void MotionCommander::play(const std::string& motion) {
  releaseJoints();
  motion_ = motion;
  motionTicks_ = 0;
}

void MotionCommander::halt() {
  axes_ = {};
  velocity_.reset();
  motion_.clear();
  releaseJoints();
}

void MotionCommander::setActive(bool active) {
  if (active == active_) return;
  active_ = active;
  sinceSent_ = kResendTicks;
  sent_.clear();
  if (!active) halt();
}

void MotionCommander::settleMotion(const robotcontrol::MotionStatus* status) {
  if (motion_.empty()) return;
  const auto kind = motion_ == kGetUp ? Kind::GET_UP : Kind::KEY_FRAMES;
  const bool begun = status != nullptr && status->executed().kind() == kind &&
                     (kind == Kind::GET_UP || status->executed().motion() == motion_);
  if (begun || ++motionTicks_ > kMotionTicks) motion_.clear();
}

bool MotionCommander::tick(const robotcontrol::MotionStatus* status) {
  if (!active_) return false;
  settleMotion(status);
  std::string next = command().SerializeAsString();
  if (++sinceSent_ < kResendTicks && next == sent_) return false;
  sinceSent_ = 0;
  sent_ = std::move(next);
  return true;
}

void MotionCommander::fillJoints(robotcontrol::RemoteMotion& command) const {
  auto& motion = *command.mutable_motion();
  motion.set_kind(Kind::JOINTS);
  motion.set_limp(limp_);
  std::map<std::string, double> targets = joints_;
  if (head_.kind == HeadTarget::Kind::kAngles) {
    for (const HeadJoint& joint : kHeadJoints) targets.emplace(joint.joint, head_.*joint.angle);
  }
  for (const auto& [name, position] : targets) {
    auto& target = *motion.add_joints();
    target.set_name(name);
    target.set_position(position);
  }
}

robotcontrol::RemoteMotion MotionCommander::command() const {
  robotcontrol::RemoteMotion result;
  auto& motion = *result.mutable_motion();
  if (!motion_.empty()) {
    motion.set_kind(motion_ == kGetUp ? Kind::GET_UP : Kind::KEY_FRAMES);
    motion.set_motion(motion_);
  } else if (turnsJoints_) {
    fillJoints(result);
  } else if (velocity_) {
    motion.set_kind(Kind::WALK);
    motion.mutable_walk()->set_x(velocity_->x);
    motion.mutable_walk()->set_y(velocity_->y);
    motion.mutable_walk()->set_rotation(velocity_->rotation);
  } else if (!axes_.zero()) {
    // Limits the square of the axes to a disc of speeds: full deflection is the limit in every direction.
    const double length = std::max(1.0, std::hypot(axes_.forward, axes_.left));
    motion.set_kind(Kind::WALK);
    motion.mutable_walk()->set_x(axes_.forward / length * limits_.speed);
    motion.mutable_walk()->set_y(axes_.left / length * limits_.speed);
    motion.mutable_walk()->set_rotation(axes_.turn * limits_.rotation);
  }
  auto& head = *result.mutable_head();
  head.set_kind(static_cast<robotcontrol::HeadMode::Kind>(head_.kind));
  if (head_.kind == HeadTarget::Kind::kAngles) {
    head.set_tilt(head_.tilt);
    head.set_pan(head_.pan);
    head.set_roll(head_.roll);
    head.set_mouth(head_.mouth);
  }
  return result;
}

}  // namespace widgets
