// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/VehicleMotion.h"

#include <algorithm>
#include <cmath>

namespace simcore {

using robotlink::Vector2;

namespace {

using GuideKind = GuidedMotion::Kind;

double clampedTo(double value, double limit) {
  return std::clamp(value, -limit, limit);
}

/// The velocity of a point of the model along its axes.
Vector2 velocityOfPoint(const PlaneMotion& motion, const robotlink::Vector3& point) {
  return {motion.ahead - motion.turning * point.y(), motion.sideways + motion.turning * point.x()};
}

}  // namespace

std::array<double, 6> limitedCommand(const GuidedMotion& motion, const VehicleDescription& vehicle,
                                     std::array<double, 6> command) {
  if (motion.kind == GuideKind::kAckermann) command[1] = clampedTo(command[1], motion.maximumSteering);
  if (vehicle.byTorque) return command;
  if (motion.kind == GuideKind::kOmni) {
    // No wheel turns faster than it can; the direction stays.
    double fastest = 0;
    for (const VehicleWheel& wheel : vehicle.wheels)
      fastest = std::max(fastest, std::abs(rimSpeed(motion, vehicle, wheel, command)));
    if (fastest <= motion.maximumSpeed) return command;
    for (std::size_t i = 0; i < 3; ++i) command[i] *= motion.maximumSpeed / fastest;
    return command;
  }
  command[0] = clampedTo(command[0], motion.maximumSpeed);
  if (motion.kind != GuideKind::kAckermann) command[1] = clampedTo(command[1], motion.maximumSpeed);
  return command;
}

PlaneMotion motionOf(const GuidedMotion& motion, const VehicleDescription* vehicle,
                     const std::array<double, 6>& command) {
  switch (motion.kind) {
    case GuideKind::kDifferential:
    case GuideKind::kSkid: {
      // The track of a vehicle is what it turns about; that of a pushed model is the distance of its wheels.
      const double share = motion.kind == GuideKind::kSkid && vehicle == nullptr ? motion.skid : 1;
      return {(command[0] + command[1]) / 2, 0, share * (command[1] - command[0]) / motion.track};
    }
    case GuideKind::kAckermann:
      return {command[0], 0, command[0] * std::tan(command[1]) / motion.wheelbase};
    case GuideKind::kOmni:
    case GuideKind::kWalk:
    case GuideKind::kFree:
      break;
  }
  return {command[0], command[1], command[2]};
}

double steeringAngle(const GuidedMotion& motion, const VehicleWheel& wheel, double commanded) {
  const double curvature = std::tan(commanded) / motion.wheelbase;
  return std::atan(curvature * wheel.center.x() / (1 - curvature * wheel.center.y()));
}

double rimSpeed(const GuidedMotion& motion, const VehicleDescription& vehicle, const VehicleWheel& wheel,
                const std::array<double, 6>& command) {
  if (!wheel.driven) return 0;
  if (motion.kind == GuideKind::kDifferential || motion.kind == GuideKind::kSkid)
    return command[wheel.center.y() > 0 ? 0 : 1];
  const Vector2 velocity = velocityOfPoint(motionOf(motion, &vehicle, command), wheel.center);
  const double angle =
      wheel.steering >= 0 ? steeringAngle(motion, wheel, command[1]) : wheel.rollers.value_or(0);
  const Vector2 push = Eigen::Rotation2Dd(angle) * Vector2(wheel.forward.head<2>());
  // Rollers carry the rim along where they do not push.
  return velocity.dot(push) / (wheel.rollers ? std::cos(*wheel.rollers) : 1);
}

}  // namespace simcore
