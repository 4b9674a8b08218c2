// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/FallDetector.h"

#include <cmath>

namespace modules {
namespace {

constexpr double kSmoothing = 0.2;     // s
constexpr double kFallenCosine = 0.5;  // 60 degrees
constexpr double kSitsCosine = 0.7;    // 46 degrees, more than a kick leans for long
constexpr double kUprightCosine = 0.8;
constexpr double kConfirmation = 0.3;  // s
constexpr double kSitsAfter = 1;       // s
constexpr double kGravity = 9.81;

}  // namespace

void FallDetector::update(const robotlink::Vector3& acceleration, robotlink::Duration frame) {
  if (!acceleration.allFinite()) return;
  const double dt = robotlink::seconds(frame);
  const double part = dt / (kSmoothing + dt);
  up_ += (acceleration / kGravity - up_) * part;
  if (up_.norm() < 1e-6) up_ = {0, 0, 1e-6};
  const double cosine = up().z();
  tiltedFor_ = cosine < kFallenCosine ? tiltedFor_ + dt : 0;
  sitsFor_ = cosine < kSitsCosine ? sitsFor_ + dt : 0;
  if (tiltedFor_ > kConfirmation || sitsFor_ > kSitsAfter) fallen_ = true;
  if (cosine > kUprightCosine) fallen_ = false;
}

FallDetector::Side FallDetector::side() const {
  const robotlink::Vector3 direction = up();
  if (direction.z() > kUprightCosine) return Side::kNone;
  // The axis that points upward most determines the side that is down.
  if (-direction.z() > std::abs(direction.x()) && -direction.z() > std::abs(direction.y()))
    return Side::kBack;
  if (std::abs(direction.x()) > std::abs(direction.y()))
    return direction.x() > 0 ? Side::kRear : Side::kFront;
  return direction.y() > 0 ? Side::kRight : Side::kLeft;
}

}  // namespace modules
