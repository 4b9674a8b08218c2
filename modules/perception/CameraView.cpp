// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/CameraView.h"

#include <cmath>

namespace modules {

using robotlink::Pose3;
using robotlink::Vector2;
using robotlink::Vector3;

CameraView CameraView::fromAngles(const Pose3& cameraInRobot, double horizontalAngle, double verticalAngle,
                                  int width, int height) {
  return {cameraInRobot, width, height, 0.5 * width / std::tan(0.5 * horizontalAngle),
          0.5 * height / std::tan(0.5 * verticalAngle)};
}

Vector3 CameraView::ray(const Vector2& pixel) const {
  const Vector2 offset = center() - pixel;
  return cameraInRobot.linear() * Vector3(1, offset.x() / focalX, offset.y() / focalY);
}

std::optional<Vector2> CameraView::onPlane(const Vector2& pixel, double planeHeight) const {
  const Vector3 direction = ray(pixel);
  const double drop = planeHeight - cameraInRobot.translation().z();
  if (direction.z() == 0 || drop / direction.z() <= 0) return std::nullopt;
  return Vector2((cameraInRobot.translation() + direction * (drop / direction.z())).head<2>());
}

std::optional<Vector2> CameraView::pixelOf(const Vector3& point) const {
  const Vector3 inCamera = cameraInRobot.linear().transpose() * (point - cameraInRobot.translation());
  if (inCamera.x() <= 1e-6) return std::nullopt;
  return Vector2(center() -
                 Vector2(focalX * inCamera.y() / inCamera.x(), focalY * inCamera.z() / inCamera.x()));
}

double CameraView::elevation(const Vector2& pixel) const {
  const Vector3 direction = ray(pixel);
  return std::atan2(direction.z(), direction.head<2>().norm());
}

double CameraView::bearing(const Vector2& pixel) const {
  const Vector3 direction = ray(pixel);
  return std::atan2(direction.y(), direction.x());
}

std::optional<double> CameraView::horizonRow(double column) const {
  // The vertical component of a ray is linear in the row.
  const Vector3 up = cameraInRobot.linear().transpose() * Vector3::UnitZ();
  if (std::abs(up.z()) < 1e-6) return std::nullopt;
  const double across = (center().x() - column) / focalX;
  return center().y() + focalY * (up.x() + up.y() * across) / up.z();
}

}  // namespace modules
