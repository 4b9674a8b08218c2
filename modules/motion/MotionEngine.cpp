// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/MotionEngine.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Duration;

MotionEngine::MotionEngine(JointLayout joints, std::shared_ptr<const robotlink::MotionNet> motions,
                           const GaitParameters& gait, Options options)
    : joints_(std::move(joints)),
      motions_(std::move(motions)),
      gait_(gait),
      player_(motions_),
      options_(options),
      positions_(joints_.stance()),
      blendFrom_(positions_) {}

void MotionEngine::start(std::span<const double> positions) {
  for (std::size_t i = 0; i < std::min(positions.size(), positions_.size()); ++i) {
    if (std::isfinite(positions[i])) positions_[i] = positions[i];
  }
  beginBlend();
  falls_.reset();
  odometry_ = {};
}

void MotionEngine::setParameters(const GaitParameters& gait, Options options) {
  gait_.setParameters(gait);
  options_ = options;
}

void MotionEngine::advance(const Frame& frame) {
  const double dt = robotlink::seconds(frame.time);
  const bool wasFallen = falls_.fallen();
  if (frame.acceleration) falls_.update(*frame.acceleration, frame.time);
  if (falls_.fallen() && !wasFallen && mode_ == Mode::kGait) beginBlend();
  const MotionCommand desired = resolved(frame.desired);

  // Key frames end in the gait's stand; between two of them there is always a stand.
  const bool wantsKeyFrames =
      desired.kind == MotionCommand::Kind::kKeyFrames || desired.kind == MotionCommand::Kind::kGetUp;
  if (mode_ == Mode::kGait && wantsKeyFrames && mayBegin(desired.motion) && blended_ >= options_.blendTime) {
    mode_ = Mode::kKeyFrames;
    player_ = robotlink::MotionPlayer(motions_);
    played_ = {};
    player_.start(positions_);
    player_.request(desired.motion, robotlink::MotionPlayer::Repeat::kOnce);
    executed_ = desired;
  }
  const bool wantsJoints = desired.kind == MotionCommand::Kind::kJoints;
  if (mode_ == Mode::kGait && wantsJoints && gait_.standing()) mode_ = Mode::kJoints;
  if (mode_ == Mode::kJoints && !wantsJoints) beginBlend();
  if (mode_ == Mode::kKeyFrames) runKeyFrames(desired, frame.time);
  if (mode_ == Mode::kJoints) runJoints(desired, frame.measured, dt);
  if (mode_ == Mode::kGait) runGait(wantsKeyFrames ? MotionCommand{} : desired, frame.time);
  setFreeJoints(dt);
  moveHead(frame.head, dt);
}

bool MotionEngine::mayBegin(const std::string& motion) const {
  const bool inWalk = motions_->begin(motion) == robotlink::MotionFile::Begin::kWalk;
  return inWalk ? gait_.betweenSteps() : gait_.standing();
}

/// The request as it can be executed: getting up after a fall takes precedence; an unknown motion becomes a
/// stand.
MotionCommand MotionEngine::resolved(const MotionCommand& desired) {
  refusal_.clear();
  // A robot that is posed by hand may lie.
  if (desired.kind == MotionCommand::Kind::kJoints) return desired;
  const bool mustGetUp = falls_.fallen() && options_.getUpByItself;
  if (mustGetUp ||
      (desired.kind == MotionCommand::Kind::kGetUp && falls_.side() != FallDetector::Side::kNone)) {
    MotionCommand result{MotionCommand::Kind::kGetUp, {}, getUpMotion()};
    if (motions_->find(result.motion) >= 0) return result;
    refusal_ = "there is no motion '" + result.motion + "'";
  } else if (desired.kind == MotionCommand::Kind::kKeyFrames && motions_->find(desired.motion) < 0) {
    refusal_ = "there is no motion '" + desired.motion + "'";
  } else if (desired.kind != MotionCommand::Kind::kGetUp) {
    return desired;
  }
  return {};
}

std::string MotionEngine::getUpMotion() const {
  switch (falls_.side()) {
    case FallDetector::Side::kBack:
      return "get-up-back";
    case FallDetector::Side::kRear:
      return "get-up-rear";
    case FallDetector::Side::kLeft:
      return "get-up-left";
    case FallDetector::Side::kRight:
      return "get-up-right";
    default:
      return "get-up-front";
  }
}

/// Moves the legs from their present angles to the stand, where the gait continues.
void MotionEngine::beginBlend() {
  mode_ = Mode::kGait;
  gait_.reset();
  stiffness_ = 1;
  blendFrom_ = positions_;
  blended_ = 0;
  executed_ = {};
}

void MotionEngine::runKeyFrames(const MotionCommand& desired, Duration time) {
  // The requested motion may change, but getting up is not interrupted.
  const bool getsUp = executed_.kind == MotionCommand::Kind::kGetUp;
  if (!getsUp && desired.kind == MotionCommand::Kind::kKeyFrames) {
    player_.request(desired.motion, robotlink::MotionPlayer::Repeat::kOnce);
    executed_ = desired;
  } else if (desired != executed_) {
    player_.clear();
  }
  player_.advance(time);
  countKeyFrames(time);
  const auto angles = player_.angles();
  bool moved = false;
  double most = 0;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (!player_.moves(i)) continue;
    moved = true;
    positions_[i] = std::clamp(angles[i], joints_.joint(i).minimum, joints_.joint(i).maximum);
    most = std::max(most, player_.shares()[i]);
  }
  stiffness_ = moved ? most : 1;
  if (player_.finished()) {
    beginBlend();
  } else if (!player_.motion().empty()) {
    executed_.motion = player_.motion();
  }
}

/// Moves the odometry by the part of the present motion that was played; by all of it at its end.
void MotionEngine::countKeyFrames(Duration time) {
  const std::string motion = player_.motion();
  if (motion != played_.motion) {
    if (!played_.motion.empty()) odometry_ = played_.begin * played_.displacement.pose;
    played_ = {motion, odometry_, player_.displacement()};
  }
  if (motion.empty()) return;
  played_.elapsed += time;
  const auto& [whole, duration] = played_.displacement;
  const double part = duration.count() > 0
                          ? std::min(1.0, robotlink::seconds(played_.elapsed) / robotlink::seconds(duration))
                          : 0;
  odometry_ = played_.begin * robotlink::Pose2{whole.x * part, whole.y * part, whole.heading * part};
}

void MotionEngine::runGait(const MotionCommand& desired, Duration time) {
  const double dt = robotlink::seconds(time);
  blended_ += dt;
  const bool blending = blended_ < options_.blendTime;
  gait_.request(desired.kind == MotionCommand::Kind::kWalk && !blending ? desired.walk : WalkSpeed{});
  gait_.advance(time, WheelModelGait::Idle::kStand);
  const double part = blending ? 0.5 - 0.5 * std::cos(robotlink::kPi * blended_ / options_.blendTime) : 1;
  std::vector<double> wanted = blendFrom_;
  for (const Leg leg : kLegs) joints_.setLeg(wanted, leg, gait_.angles(leg));
  for (const Leg leg : kLegs) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t joint = joints_.legJoint(leg, i);
      positions_[joint] = blendFrom_[joint] + (wanted[joint] - blendFrom_[joint]) * part;
    }
  }
  const WalkSpeed now = speed();
  odometry_ = odometry_ * robotlink::Pose2{now.x * dt, now.y * dt, now.rotation * dt};
  executed_.kind = gait_.standing() ? MotionCommand::Kind::kStand : MotionCommand::Kind::kWalk;
  executed_.walk = gait_.standing() ? WalkSpeed{} : gait_.requested();
  executed_.motion.clear();
}

/// Turns joints to their angles, within their limits of angle and speed. Limp joints are where they are, so
/// that they stay there when they become stiff again.
void MotionEngine::runJoints(const MotionCommand& desired, std::span<const double> measured, double seconds) {
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    if (desired.limp) {
      if (i < measured.size() && std::isfinite(measured[i])) positions_[i] = measured[i];
    } else if (i < desired.joints.size()) {
      positions_[i] = joints_.approached(i, positions_[i], desired.joints[i], seconds);
    }
  }
  stiffness_ = desired.limp ? 0 : 1;
  executed_ = desired;
}

/// Mouth, tail and ears move to their stance when nothing controls them.
void MotionEngine::setFreeJoints(double seconds) {
  if (mode_ == Mode::kJoints) return;
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    const auto& head = joints_.headJoints();
    bool others = std::ranges::find(head, i) != head.end();
    for (const Leg leg : kLegs) {
      for (std::size_t j = 0; j < 3; ++j) others = others || joints_.legJoint(leg, j) == i;
    }
    if (others || (mode_ == Mode::kKeyFrames && player_.moves(i))) continue;
    positions_[i] = joints_.approached(i, positions_[i], joints_.joint(i).stance, seconds);
  }
}

void MotionEngine::moveHead(const HeadAngles& wanted, double seconds) {
  if (mode_ == Mode::kJoints) return;
  const std::array<double, 4> angles{wanted.tilt, wanted.pan, wanted.roll, wanted.mouth};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const std::size_t joint = joints_.headJoints()[i];
    if (mode_ == Mode::kKeyFrames && player_.moves(joint)) continue;
    positions_[joint] =
        joints_.approached(joint, positions_[joint], angles[i], seconds * options_.headSpeedShare);
  }
}

bool MotionEngine::stable() const {
  return mode_ == Mode::kGait && blended_ >= options_.blendTime && !falls_.fallen();
}

WalkSpeed MotionEngine::speed() const {
  return mode_ == Mode::kGait && !gait_.standing() && !falls_.fallen() ? gait_.speed() : WalkSpeed{};
}

}  // namespace modules
