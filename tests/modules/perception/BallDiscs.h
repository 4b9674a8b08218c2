// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "modules/perception/BallGeometry.h"

namespace modules {

/// The disc in the image of a ball that lies on the ground in front of the camera, by the perspective of
/// spheres.
inline BallDisc discAt(const robotlink::Vector2& positionInRobot, const CameraView& view) {
  const double ballRadius = BallGeometry::Options().ballRadius;
  const robotlink::Vector3 middle(positionInRobot.x(), positionInRobot.y(), ballRadius);
  const double distance = (middle - view.cameraInRobot.translation()).norm();
  const robotlink::Vector2 center = view.pixelOf(middle).value();
  const double fromLens = std::hypot(std::sqrt(view.focalX * view.focalY), (center - view.center()).norm());
  return {center, fromLens * std::tan(std::asin(ballRadius / distance)), 0.6};
}

}  // namespace modules
