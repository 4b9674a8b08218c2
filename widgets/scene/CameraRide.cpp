// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/CameraRide.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

constexpr double kShare = 0.1;      // share of the remaining distance per step
constexpr double kJump = 1.0;       // m; the way of a robot that is carried this far is not followed
constexpr double kStill = 2e-4;     // m and rad; smaller changes are not worth a new picture
constexpr double kLead = 0.5;       // m; largest lead toward the ball
constexpr double kNearBall = 2.0;   // m
constexpr double kShoulder = 0.25;  // m; a camera behind the robot looks at a point this far in front of it

}  // namespace

void CameraRide::setMode(Mode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  at_.reset();
}

Pose2 CameraRide::wanted(const Subject& subject) const {
  if (mode_ == Mode::kBehind) return subject.robot * Pose2{subject.isObject ? 0 : kShoulder, 0, 0};
  Pose2 place = subject.robot;
  place.heading = 0;
  if (!subject.ball) return place;
  const Vector2 toBall = *subject.ball - subject.robot.translation();
  const double distance = toBall.norm();
  if (distance < 1e-6 || distance > kNearBall) return place;
  const Vector2 lead = toBall * std::min(0.5, kLead / distance);
  return {place.x + lead.x(), place.y + lead.y(), 0};
}

SceneCamera CameraRide::boarded(const SceneCamera& camera, const Subject& subject, bool far) const {
  if (mode_ == Mode::kBehind) {
    SceneCamera behind = SceneCamera::behind(subject.robot, subject.distance);
    if (!subject.isObject) return behind;
    behind.target.head<2>() = subject.robot.translation();
    behind.distance = subject.distance;
    return behind;
  }
  const Pose2 place = wanted(subject);
  SceneCamera near = camera;
  if (far) near = SceneCamera::beside(subject.distance);
  near.target.head<2>() = place.translation();
  near.distance = std::min(near.distance, subject.distance);
  return near;
}

SceneCamera CameraRide::step(const SceneCamera& camera, const Subject& subject, bool far) {
  if (mode_ == Mode::kOff) return camera;
  const Pose2 place = wanted(subject);
  if (!at_) {
    at_ = place;
    height_ = subject.height.value_or(0);
    SceneCamera near = boarded(camera, subject, far);
    if (subject.height) near.target.z() = *subject.height;
    return near;
  }
  const Vector2 missing = place.translation() - at_->translation();
  const double turn = normalizedAngle(place.heading - at_->heading);
  const double rise = subject.height ? *subject.height - height_ : 0;
  const bool jumped = missing.norm() > kJump || std::abs(rise) > kJump;
  if (missing.norm() < kStill && std::abs(turn) < kStill && std::abs(rise) < kStill) return camera;
  const double share = jumped ? 1 : kShare;
  const Pose2 next{at_->x + share * missing.x(), at_->y + share * missing.y(),
                   normalizedAngle(at_->heading + share * turn)};
  // Keeps the camera's pose relative to the place that it follows, including what the user has changed.
  SceneCamera moved = camera;
  moved.target.head<2>() = next * (at_->inverse() * Vector2(camera.target.head<2>()));
  moved.target.z() += share * rise;
  height_ += share * rise;
  moved.azimuth = normalizedAngle(camera.azimuth + normalizedAngle(next.heading - at_->heading));
  at_ = next;
  return moved;
}

}  // namespace widgets
