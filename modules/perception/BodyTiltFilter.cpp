// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BodyTiltFilter.h"

#include <algorithm>
#include <cmath>

namespace modules {

namespace {

constexpr double kStandardGravity = 9.81;

}  // namespace

BodyTilt BodyTiltFilter::tiltOf(const robotlink::Vector3& acceleration) {
  return {0, std::atan2(-acceleration.x(), std::hypot(acceleration.y(), acceleration.z())),
          std::atan2(acceleration.y(), acceleration.z())};
}

BodyTilt BodyTiltFilter::update(const BodyTilt& legs, const std::optional<robotlink::Vector3>& acceleration,
                                double seconds, const Options& options) {
  if (!legs_) {
    tilt_ = legs;
  } else {
    tilt_.pitch += legs.pitch - legs_->pitch;
    tilt_.roll += legs.roll - legs_->roll;
  }
  legs_ = legs;
  tilt_.height = legs.height;
  if (!acceleration || !acceleration->allFinite()) return tilt_;
  const double jolt = std::abs(acceleration->norm() / kStandardGravity - 1);
  if (jolt > options.maximumJolt) return tilt_;
  const double share = std::clamp(seconds / (options.timeConstant + seconds), 0.0, 1.0);
  const BodyTilt gravity = tiltOf(*acceleration);
  tilt_.pitch += share * (gravity.pitch - tilt_.pitch);
  tilt_.roll += share * (gravity.roll - tilt_.roll);
  return tilt_;
}

}  // namespace modules
