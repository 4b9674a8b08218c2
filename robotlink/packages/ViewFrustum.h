// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Geometry.h"

namespace robotcontrol {
class CameraPose;
}

namespace robotlink {

/// The space that a camera shows: the points within its fields of view. A plain value.
class ViewFrustum {
 public:
  /// Shows nothing if the camera's angles are not known.
  explicit ViewFrustum(const robotcontrol::CameraPose& camera);
  /// Whether a point of the robot's frame, m, is seen. With `part` below 1 only in the middle of the image:
  /// in that part of its width and height.
  bool shows(const Vector3& point, double part = 1) const;

 private:
  std::optional<Pose3> cameraInverse_;
  /// The tangents of half the fields of view, horizontal and vertical.
  double across_ = 0, along_ = 0;
};

}  // namespace robotlink
