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

  robotlink::Vector3 at(double distance) const { return origin + distance * direction; }
  /// Where it meets the plane z = height, in front of its origin; not if that is more than 500 m away.
  std::optional<robotlink::Vector3> onPlane(double height) const;
};

/// What shall be seen: a box that stands on the ground.
struct SceneBox {
  robotlink::Vector2 center = robotlink::Vector2::Zero();
  robotlink::Vector3 size{4.6, 3.1, 0.4};  ///< length, width and height, m
  bool operator==(const SceneBox&) const = default;
};

/// A camera that looks at a point of the field from a distance and can be moved around it. A plain value;
/// metres, radians, the field's frame; widget coordinates in Qt's logical pixels.
struct SceneCamera {
  static constexpr double kMinimumDistance = 0.15, kMaximumDistance = 200;
  static constexpr double kVerticalAngle = robotlink::radians(36);  ///< whole opening angle

  robotlink::Vector3 target{0, 0, 0};
  double distance = 6.4;
  double azimuth =
      robotlink::radians(-90);  ///< of the camera, as seen from the target, from +x counter-clockwise
  double elevation = robotlink::radians(38);

  bool operator==(const SceneCamera&) const = default;

  robotlink::Vector3 position() const;
  Eigen::Matrix4d view() const;
  Eigen::Matrix4d projection(const QSizeF& widget) const;
  Ray ray(const QSizeF& widget, const QPointF& at) const;
  /// Nothing behind the camera.
  std::optional<QPointF> project(const QSizeF& widget, const robotlink::Vector3& point) const;

  /// Moved with the mouse, by widget pixels.
  void orbit(const QPointF& by);
  void pan(const QSizeF& widget, const QPointF& by);
  /// Nearer by `factor` above 1; what lies on the ground under `at` stays there.
  void zoom(const QSizeF& widget, double factor, const QPointF& at);
  /// As near as possible while all of the box is seen.
  void fit(const QSizeF& widget, const SceneBox& box);

  /// So that all of a box is seen.
  static SceneCamera overview(const QSizeF& widget, const SceneBox& box);
  static SceneCamera fromAbove(const QSizeF& widget, const SceneBox& box);
  /// Over the shoulder of what stands at a pose and is seen well from a distance.
  static SceneCamera behind(const robotlink::Pose2& pose, double distance = 2.4);
  /// From the side, at a distance from the field's middle.
  static SceneCamera beside(double distance);
};

/// For saved window layouts. What is missing is as in a new camera, what is out of range is brought back.
QJsonObject stateOf(const SceneCamera& camera);
SceneCamera cameraOf(const QJsonObject& state);

}  // namespace widgets
