// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QPointF>
#include <QSizeF>
#include <optional>

#include "robotlink/base/Geometry.h"

namespace widgets {

/// A half line in the field's frame; the direction has length 1.
struct Ray {
  robotlink::Vector3 origin = robotlink::Vector3::Zero();
  robotlink::Vector3 direction = robotlink::Vector3::UnitX();

  /// The point at a distance (m) from the origin.
  robotlink::Vector3 at(double distance) const { return origin + distance * direction; }
  /// The intersection with the plane z = height in front of the origin; unset if there is none within 500 m.
  std::optional<robotlink::Vector3> onPlane(double height) const;
};

/// A box on the ground that should be visible.
struct SceneBox {
  robotlink::Vector2 center = robotlink::Vector2::Zero();
  /// Length, width and height, m.
  robotlink::Vector3 size{4.6, 3.1, 0.4};
  bool operator==(const SceneBox&) const = default;
};

/// A camera that orbits a point of the field at a distance, or looks out of a place. A plain value; meters
/// and radians in the field's frame, widget coordinates in Qt's logical pixels.
struct SceneCamera {
  /// Limits of the distance.
  static constexpr double kMinDistance = 0.15, kMaxDistance = 200;
  /// The whole vertical field of view of a camera that orbits.
  static constexpr double kVerticalAngle = robotlink::radians(36);

  /// The point that the camera looks at.
  robotlink::Vector3 target{0, 0, 0};
  double distance = 6.4;
  /// Direction from the target to the camera around z, counterclockwise from +x.
  double azimuth = robotlink::radians(-90);
  /// Elevation of the camera above the target's horizon, rad.
  double elevation = robotlink::radians(38);
  /// The pose out of which it looks along x, with z up in the picture, as a homogeneous matrix; unset: it
  /// orbits. Then orbit(), pan(), zoom() and fit() change nothing.
  std::optional<Eigen::Matrix4d> eyeInField = {};
  /// The whole vertical field of view.
  double verticalAngle = kVerticalAngle;

  bool operator==(const SceneCamera&) const = default;

  /// Position of the camera.
  robotlink::Vector3 position() const;
  /// From the field's frame to the camera's: x right, y up, -z in the direction of view, as OpenGL has it.
  Eigen::Matrix4d view() const;
  /// OpenGL's perspective projection for a widget of this size.
  Eigen::Matrix4d projection(const QSizeF& widget) const;
  /// The ray through a widget position.
  Ray ray(const QSizeF& widget, const QPointF& at) const;
  /// Widget position of a point; unset behind the camera.
  std::optional<QPointF> project(const QSizeF& widget, const robotlink::Vector3& point) const;

  /// Turns around the target as for a drag by `by` widget pixels.
  void orbit(const QPointF& by);
  /// Moves the target as for a drag by `by` widget pixels.
  void pan(const QSizeF& widget, const QPointF& by);
  /// Comes nearer by a factor above 1; the ground under `at` (widget) stays there.
  void zoom(const QSizeF& widget, double factor, const QPointF& at);
  /// Sets the smallest distance from which the whole box is visible; target and direction are kept.
  void fit(const QSizeF& widget, const SceneBox& box);

  /// A camera that shows the whole box from an oblique direction.
  static SceneCamera overview(const QSizeF& widget, const SceneBox& box);
  /// A camera that shows the whole box from straight above.
  static SceneCamera fromAbove(const QSizeF& widget, const SceneBox& box);
  /// A camera over the shoulder of a robot at a pose.
  static SceneCamera behind(const robotlink::Pose2& pose, double distance = 2.4);
  /// A camera that looks at the field's center from the side, at a distance.
  static SceneCamera beside(double distance);
};

/// For saved window layouts; without the eye, which follows something.
QJsonObject stateOf(const SceneCamera& camera);
/// The inverse of stateOf(). Missing values get their defaults, values out of range are clamped.
SceneCamera cameraOf(const QJsonObject& state);

}  // namespace widgets
