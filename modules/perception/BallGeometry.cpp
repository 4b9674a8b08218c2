// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BallGeometry.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Vector2;
using robotlink::Vector3;

Vector3 BallGeometry::middleBySize(const BallDisc& disc, const CameraView& view) const {
  // A sphere with radius R at distance D appears under the angle asin(R / D).
  const Vector2 offset = disc.center - view.center();
  const double focal = std::sqrt(view.focalX * view.focalY);
  const double fromLens = std::hypot(focal, offset.norm());
  // The radius is measured perpendicular to the direction of the center, where the scale is that of the
  // sphere, not of the plane.
  const double angle = std::atan(disc.radius / fromLens);
  const double distance = options_.ballRadius / std::sin(std::max(angle, 1e-4));
  return view.cameraInRobot.translation() + view.ray(disc.center).normalized() * distance;
}

std::optional<BallObservation> BallGeometry::locate(const BallDisc& disc, const CameraView& view) const {
  if (disc.radius <= 0) return std::nullopt;
  const Vector3 camera = view.cameraInRobot.translation();
  const double above = std::max(0.05, camera.z() - options_.ballRadius);
  const Vector3 bySize = middleBySize(disc, view);
  const double distanceBySize = (bySize - camera).norm();
  const double sizeDeviation = distanceBySize * std::min(1.0, disc.radiusDeviation / disc.radius) + 0.005;

  // The center of a ball on the ground is at the height of its radius; how far off is this one?
  const double slope = std::abs(view.ray(disc.center).normalized().z());
  const double heightDeviation =
      std::hypot(slope * sizeDeviation, options_.tiltDeviation * distanceBySize) + 0.005;
  const double off = (bySize.z() - options_.ballRadius) / heightDeviation;
  if (std::abs(off) > options_.gate) return std::nullopt;

  BallObservation ball{true, disc.center, disc.radius, bySize.head<2>(), std::exp(-0.25 * off * off)};
  if (const auto onGround = view.onPlane(disc.center, options_.ballRadius)) {
    const double distance = (*onGround - camera.head<2>()).norm();
    const double deviation = options_.tiltDeviation * (distance * distance / above + above) + 0.002;
    const double weight =
        sizeDeviation * sizeDeviation / (sizeDeviation * sizeDeviation + deviation * deviation);
    ball.positionInRobot = weight * *onGround + (1 - weight) * ball.positionInRobot;
  }
  if (ball.positionInRobot.norm() > options_.maximumDistance) return std::nullopt;
  return ball;
}

}  // namespace modules
