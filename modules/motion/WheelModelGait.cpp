// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/WheelModelGait.h"

#include <algorithm>
#include <cmath>

#include "modules/motion/Approach.h"
#include "modules/motion/FootCurve.h"

namespace modules {

using robotlink::Vector3;

namespace {

/// Whether phases from `from` to `to` (a little later) pass a multiple of a half: there all paws of a trot
/// are down.
bool passesHalf(double from, double to) {
  return std::floor(from * 2) != std::floor(to * 2);
}

}  // namespace

WheelModelGait::WheelModelGait(const GaitParameters& parameters, const RobotDimensions& dimensions)
    : parameters_(parameters), kinematics_(dimensions) {}

void WheelModelGait::reset() {
  requested_ = speed_ = {};
  phase_ = 0;
  standing_ = true;
}

WalkSpeed WheelModelGait::limited(const WalkSpeed& speed) const {
  const GaitParameters& p = parameters_;
  const double norm = std::hypot(speed.x / (speed.x < 0 ? p.maximumBackward : p.maximumX),
                                 speed.y / p.maximumY, speed.rotation / p.maximumRotation);
  if (!std::isfinite(norm)) return {};
  const double scale = norm > 1 ? 1 / norm : 1;
  return {speed.x * scale, speed.y * scale, speed.rotation * scale};
}

void WheelModelGait::advance(robotlink::Duration frame, Idle idle) {
  const double dt = robotlink::seconds(frame);
  const GaitParameters& p = parameters_;
  speed_.x = approached(speed_.x, requested_.x, p.maximumChangeX * dt);
  speed_.y = approached(speed_.y, requested_.y, p.maximumChangeY * dt);
  speed_.rotation = approached(speed_.rotation, requested_.rotation, p.maximumChangeRotation * dt);

  const bool stop = idle == Idle::kStand && speed_ == WalkSpeed{} && requested_ == WalkSpeed{};
  if (standing_ && stop) return;
  standing_ = false;
  const double next = phase_ + dt / (p.stepFrames * 0.008);
  betweenSteps_ = passesHalf(phase_, next);
  if (stop && betweenSteps_) {
    standing_ = true;
    phase_ = std::floor(next * 2) / 2;
  } else {
    phase_ = next;
  }
  phase_ -= std::floor(phase_);
}

double WheelModelGait::legPhase(Leg leg) const {
  const double phase = phase_ + parameters_.legPhase[index(leg)];
  return phase - std::floor(phase);
}

bool WheelModelGait::onGround(Leg leg) const {
  return standing_ || legPhase(leg) < parameters_.groundPhase[isFore(leg) ? 0 : 1];
}

Vector3 WheelModelGait::standInHip(Leg leg) const {
  const GaitParameters& p = parameters_;
  const double side = (isFore(leg) ? p.foreWidth : p.hindWidth) - kinematics_.dimensions().hipY;
  const double x =
      isFore(leg) ? p.foreCenterX : p.hindCenterX + p.hindShiftBackward * std::max(0.0, -speed_.x);
  return {x, isLeft(leg) ? side : -side, -(isFore(leg) ? p.foreHeight : p.hindHeight)};
}

Vector3 WheelModelGait::stepVector(Leg leg) const {
  const GaitParameters& p = parameters_;
  const double until = p.counterForwardUntil;
  const double still = until > 0 ? std::max(0.0, 1 - std::abs(speed_.x) / until) : 0;
  const double drift = p.counterForwardRotation * speed_.rotation * speed_.rotation +
                       p.counterForwardSideways * speed_.y * speed_.y;
  const double forward = speed_.x * (speed_.x < 0 ? p.factorBackward : p.factorX) - still * drift;
  const double sideways = speed_.y * p.factorY;
  const double turn =
      speed_.rotation * p.factorRotation + speed_.x * p.counterRotationX + speed_.y * p.counterRotationY;
  const Vector3 paw = kinematics_.hipInBody(leg) + standInHip(leg);
  const double time = p.stepFrames * 0.008 * p.groundPhase[isFore(leg) ? 0 : 1];
  return {std::clamp((forward - turn * paw.y()) * time, -p.maximumStepX, p.maximumStepX),
          std::clamp((sideways + turn * paw.x()) * time, -p.maximumStepY, p.maximumStepY), 0};
}

double WheelModelGait::pitch() const {
  const double slope =
      (parameters_.hindHeight - parameters_.foreHeight) / (2 * kinematics_.dimensions().hipX);
  return std::asin(std::clamp(slope, -1.0, 1.0));
}

Vector3 WheelModelGait::pawInHip(Leg leg) const {
  const GaitParameters& p = parameters_;
  const std::size_t pair = isFore(leg) ? 0 : 1;
  Vector3 paw = standInHip(leg);
  if (!standing_) {
    const FootCurve curve{p.footMode, p.groundPhase[pair], p.liftPhase[pair], p.loweringPhase[pair]};
    const FootPoint point = curve.at(legPhase(leg));
    const double lift = point.up * (pair == 0 ? p.foreLift : p.hindLift);
    paw += stepVector(leg) * point.along;
    paw += Vector3(lift * (pair == 0 ? p.foreTilt : p.hindTilt), 0, lift);
    const double sway = 2 * robotlink::kPi * (phase_ + p.bodyShiftOffset);
    paw -= Vector3(p.bodyShiftX * std::sin(2 * sway), p.bodyShiftY * std::sin(sway), 0);
  }
  // From the level frame to that of the body, whose nose points down if the hind legs are longer.
  return Eigen::AngleAxisd(-pitch(), Vector3::UnitY()) * paw;
}

Vector3 WheelModelGait::pawInBody(Leg leg) const {
  return kinematics_.hipInBody(leg) + pawInHip(leg);
}

LegAngles WheelModelGait::angles(Leg leg) const {
  return kinematics_.anglesFor(leg, pawInHip(leg)).angles;
}

}  // namespace modules
