// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneCamera.h"

#include <QJsonArray>
#include <QRectF>
#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

using robotlink::radians;
using robotlink::Vector2;
using robotlink::Vector3;

constexpr double kHighest = robotlink::radians(89.9), kLowest = robotlink::radians(-5);
constexpr double kFarthestTarget = 200;  // m
constexpr double kFarthestPlane = 500;   // m

}  // namespace

std::optional<Vector3> Ray::onPlane(double height) const {
  if (std::abs(direction.z()) < 1e-9) return std::nullopt;
  const double distance = (height - origin.z()) / direction.z();
  if (distance <= 0 || distance > kFarthestPlane) return std::nullopt;
  return at(distance);
}

Vector3 SceneCamera::position() const {
  if (eyeInField) return eyeInField->block<3, 1>(0, 3);
  const double level = distance * std::cos(elevation);
  return target +
         Vector3(level * std::cos(azimuth), level * std::sin(azimuth), distance * std::sin(elevation));
}

Eigen::Matrix4d SceneCamera::view() const {
  const Vector3 eye = position();
  Vector3 forward = (target - eye).normalized();
  Vector3 right(-std::sin(azimuth), std::cos(azimuth), 0);
  if (eyeInField) {
    forward = eyeInField->block<3, 1>(0, 0);
    right = -eyeInField->block<3, 1>(0, 1);
  }
  const Vector3 up = right.cross(forward);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.block<1, 3>(0, 0) = right.transpose();
  matrix.block<1, 3>(1, 0) = up.transpose();
  matrix.block<1, 3>(2, 0) = -forward.transpose();
  matrix.block<3, 1>(0, 3) = -(matrix.block<3, 3>(0, 0) * eye);
  return matrix;
}

Eigen::Matrix4d SceneCamera::projection(const QSizeF& widget) const {
  const double away = eyeInField ? 0 : distance;
  const double near = std::max(0.02, 0.02 * away), far = std::max(60.0, 4 * away);
  const double f = 1 / std::tan(verticalAngle / 2);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix(0, 0) = f * widget.height() / widget.width();
  matrix(1, 1) = f;
  matrix(2, 2) = (far + near) / (near - far);
  matrix(2, 3) = 2 * far * near / (near - far);
  matrix(3, 2) = -1;
  return matrix;
}

Ray SceneCamera::ray(const QSizeF& widget, const QPointF& at) const {
  const double f = std::tan(verticalAngle / 2);
  const Vector3 inCamera((2 * at.x() / widget.width() - 1) * f * widget.width() / widget.height(),
                         (1 - 2 * at.y() / widget.height()) * f, -1);
  return {position(), (view().block<3, 3>(0, 0).transpose() * inCamera).normalized()};
}

std::optional<QPointF> SceneCamera::project(const QSizeF& widget, const Vector3& point) const {
  const Eigen::Vector4d clip = projection(widget) * view() * point.homogeneous();
  if (clip.w() < 1e-6) return std::nullopt;
  return QPointF((clip.x() / clip.w() + 1) / 2 * widget.width(),
                 (1 - clip.y() / clip.w()) / 2 * widget.height());
}

void SceneCamera::orbit(const QPointF& by) {
  constexpr double kPerPixel = robotlink::radians(0.4);
  if (eyeInField) return;
  azimuth = robotlink::normalizedAngle(azimuth - by.x() * kPerPixel);
  elevation = std::clamp(elevation + by.y() * kPerPixel, kLowest, kHighest);
}

void SceneCamera::pan(const QSizeF& widget, const QPointF& by) {
  if (eyeInField) return;
  const double perPixel = 2 * distance * std::tan(kVerticalAngle / 2) / widget.height();
  const Vector3 right(-std::sin(azimuth), std::cos(azimuth), 0);
  const Vector3 ahead(-std::cos(azimuth), -std::sin(azimuth), 0);
  // The target moves on the ground, which is foreshortened vertically, so it moves further in that direction.
  const double foreshortened = std::max(0.25, std::sin(elevation));
  target += -by.x() * perPixel * right + by.y() * perPixel / foreshortened * ahead;
  target = target.cwiseMax(-kFarthestTarget).cwiseMin(kFarthestTarget);
}

void SceneCamera::zoom(const QSizeF& widget, double factor, const QPointF& at) {
  if (eyeInField) return;
  const auto fixed = ray(widget, at).onPlane(target.z());
  const double before = distance;
  distance = std::clamp(distance / factor, kMinDistance, kMaxDistance);
  if (!fixed) return;
  const double share = 1 - distance / before;
  target += share * (*fixed - target);
  target = target.cwiseMax(-kFarthestTarget).cwiseMin(kFarthestTarget);
}

void SceneCamera::fit(const QSizeF& widget, const SceneBox& box) {
  constexpr double kMargin = 0.03;  // share of the widget
  if (eyeInField) return;
  const QRectF room(kMargin * widget.width(), kMargin * widget.height(), (1 - 2 * kMargin) * widget.width(),
                    (1 - 2 * kMargin) * widget.height());
  const auto allSeen = [&] {
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3 place(box.center.x() + (corner & 1 ? 0.5 : -0.5) * box.size.x(),
                          box.center.y() + (corner & 2 ? 0.5 : -0.5) * box.size.y(),
                          corner & 4 ? box.size.z() : 0);
      const auto at = project(widget, place);
      if (!at || !room.contains(*at)) return false;
    }
    return true;
  };
  double nearest = kMinDistance, farthest = kMaxDistance;
  for (int i = 0; i < 24; ++i) {
    distance = (nearest + farthest) / 2;
    (allSeen() ? farthest : nearest) = distance;
  }
  distance = farthest;
}

SceneCamera SceneCamera::overview(const QSizeF& widget, const SceneBox& box) {
  SceneCamera camera;
  // A tall picture is filled better by a view from higher up.
  const double aspect = widget.width() / std::max(1.0, widget.height());
  camera.elevation = std::clamp(radians(80 - 20 * aspect), radians(30), radians(62));
  // The target is a little nearer to the viewer than the center, since near things look larger.
  camera.target = {box.center.x(), box.center.y() - 0.06 * box.size.y(), 0};
  camera.fit(widget, box);
  return camera;
}

SceneCamera SceneCamera::fromAbove(const QSizeF& widget, const SceneBox& box) {
  SceneCamera camera;
  camera.elevation = kHighest;
  camera.target = {box.center.x(), box.center.y(), 0};
  camera.fit(widget, box);
  return camera;
}

SceneCamera SceneCamera::beside(double distance) {
  SceneCamera camera;
  camera.target.z() = 0.05;
  camera.azimuth = robotlink::radians(-115);  // shows the goal at which the first team plays behind the field
  camera.elevation = robotlink::radians(30);
  camera.distance = distance;
  return camera;
}

SceneCamera SceneCamera::behind(const robotlink::Pose2& pose, double distance) {
  SceneCamera camera;
  const Vector2 ahead = pose * Vector2(0.25, 0);
  camera.target = {ahead.x(), ahead.y(), 0.1};
  camera.azimuth = robotlink::normalizedAngle(pose.heading + robotlink::kPi);
  camera.elevation = robotlink::radians(24);
  camera.distance = 0.55 * distance;
  return camera;
}

QJsonObject stateOf(const SceneCamera& camera) {
  return {{QStringLiteral("target"), QJsonArray{camera.target.x(), camera.target.y(), camera.target.z()}},
          {QStringLiteral("distance"), camera.distance},
          {QStringLiteral("azimuth"), camera.azimuth},
          {QStringLiteral("elevation"), camera.elevation}};
}

SceneCamera cameraOf(const QJsonObject& state) {
  SceneCamera camera;
  const QJsonArray target = state[QStringLiteral("target")].toArray();
  for (int i = 0; i < 3; ++i) camera.target[i] = std::clamp(target.at(i).toDouble(), -10.0, 10.0);
  camera.distance = std::clamp(state[QStringLiteral("distance")].toDouble(camera.distance),
                               SceneCamera::kMinDistance, SceneCamera::kMaxDistance);
  camera.azimuth = state[QStringLiteral("azimuth")].toDouble(camera.azimuth);
  camera.elevation =
      std::clamp(state[QStringLiteral("elevation")].toDouble(camera.elevation), kLowest, kHighest);
  return camera;
}

}  // namespace widgets
