// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/FloorPoint.h"

#include <cmath>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {

std::optional<robotlink::Vector2> floorPoint(const robotcontrol::CameraPose& camera, const QSizeF& image,
                                             const QPointF& pixel) {
  constexpr double kFar = 1e3;  // m; farther away is as good as at the horizon
  if (image.isEmpty() || camera.horizontal_angle() <= 0 || camera.vertical_angle() <= 0) return std::nullopt;
  // The position of the ray at a distance of 1 along the optical axis.
  const double left = (1 - 2 * pixel.x() / image.width()) * std::tan(camera.horizontal_angle() / 2);
  const double up = (1 - 2 * pixel.y() / image.height()) * std::tan(camera.vertical_angle() / 2);
  const robotlink::Pose3 pose = robotlink::pose3(camera.camera_in_robot());
  const robotlink::Vector3 ray = pose.linear() * robotlink::Vector3(1, left, up);
  if (!(ray.z() < 0) || pose.translation().z() <= 0) return std::nullopt;
  const robotlink::Vector3 floor = pose.translation() - ray * (pose.translation().z() / ray.z());
  if (!(floor.head<2>().norm() < kFar)) return std::nullopt;
  return robotlink::Vector2(floor.head<2>());
}

}  // namespace widgets
