// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/ViewFrustum.h"

#include <cmath>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

/// The smallest visible distance from the camera, m.
constexpr double kNearest = 0.05;

}  // namespace

ViewFrustum::ViewFrustum(const robotcontrol::CameraPose& camera) {
  if (!(camera.horizontal_angle() > 0) || !(camera.vertical_angle() > 0)) return;
  cameraInverse_ = pose3(camera.camera_in_robot()).inverse();
  across_ = std::tan(camera.horizontal_angle() / 2);
  along_ = std::tan(camera.vertical_angle() / 2);
}

bool ViewFrustum::shows(const Vector3& point, double part) const {
  if (!cameraInverse_) return false;
  // The camera's x-axis points into the image.
  const Vector3 seen = *cameraInverse_ * point;
  const double edge = part * seen.x();
  return seen.x() > kNearest && std::abs(seen.y()) < across_ * edge && std::abs(seen.z()) < along_ * edge;
}

}  // namespace robotlink
