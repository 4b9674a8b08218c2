// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace robotlink {

/// Points and directions in a plane, in meters unless said otherwise.
using Vector2 = Eigen::Vector2d;
/// Points and directions in space, in meters unless said otherwise.
using Vector3 = Eigen::Vector3d;
/// A rigid transform in space. Poses are named target-in-frame: cameraInField = robotInField * cameraInRobot.
using Pose3 = Eigen::Isometry3d;

inline constexpr double kPi = std::numbers::pi;
constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / kPi);
}

/// Returns the same angle in (-pi, pi].
inline double normalizedAngle(double angle) {
  angle = std::remainder(angle, 2 * kPi);
  return angle <= -kPi ? angle + 2 * kPi : angle;
}

/// A pose on the ground, in meters and radians: x points to the front, y to the left, and the heading counts
/// counterclockwise. A plain value; it may also be read as the transform from its own frame to the parent
/// frame.
struct Pose2 {
  double x = 0;
  double y = 0;
  /// Not necessarily normalized; the operators below normalize their results.
  double heading = 0;

  Vector2 translation() const { return {x, y}; }
  /// Composes two transforms: `*this` is a frame and `inner` a pose in it; the result is that pose in the
  /// parent of the frame. The heading of the result is in (-pi, pi].
  Pose2 operator*(const Pose2& inner) const {
    const double c = std::cos(heading), s = std::sin(heading);
    return {x + c * inner.x - s * inner.y, y + s * inner.x + c * inner.y,
            normalizedAngle(heading + inner.heading)};
  }
  /// Transforms a point of this frame into the parent frame.
  Vector2 operator*(const Vector2& point) const {
    const double c = std::cos(heading), s = std::sin(heading);
    return {x + c * point.x() - s * point.y(), y + s * point.x() + c * point.y()};
  }
  /// The parent frame's pose in this frame.
  Pose2 inverse() const {
    const double c = std::cos(heading), s = std::sin(heading);
    return {-c * x - s * y, s * x - c * y, normalizedAngle(-heading)};
  }
  bool operator==(const Pose2&) const = default;
};

/// The shortest rotation that turns the z axis to a direction, which has any length but 0; about the x axis
/// if they are opposite.
inline Eigen::Matrix3d rotationFromZAxis(const Vector3& direction) {
  const Vector3 unit = direction.normalized();
  const double aside = unit.x() * unit.x() + unit.y() * unit.y();
  if (aside == 0 && unit.z() < 0) return Vector3(1, -1, -1).asDiagonal();
  // 1 + z without loss of digits where z is nearly -1.
  const double sum = unit.z() < 0 ? aside / (1 - unit.z()) : 1 + unit.z();
  const double scale = std::sqrt(2 * sum);
  return Eigen::Quaterniond(scale / 2, -unit.y() / scale, unit.x() / scale, 0).toRotationMatrix();
}

/// The pose of a body projected onto the ground; its heading is the direction of the body's x-axis.
/// Meaningless if that axis is vertical.
inline Pose2 groundPose(const Pose3& pose) {
  return {pose.translation().x(), pose.translation().y(),
          std::atan2(pose.linear()(1, 0), pose.linear()(0, 0))};
}

}  // namespace robotlink
