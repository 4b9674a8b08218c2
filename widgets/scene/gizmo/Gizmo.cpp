// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/gizmo/Gizmo.h"

#include <QCoreApplication>
#include <QLineF>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

constexpr double kGizmoPixels = 90;  // length of an axis
constexpr double kGizmoReach = 7;    // pixels
/// Inner and outer edge of the squares of the planes, and the radius of the rings, in lengths of an axis.
constexpr double kPlaneInner = 0.22, kPlaneOuter = 0.48, kRingRadius = 0.8;
/// The beginning of axes, in lengths of an axis, so that the object itself can be grabbed in the middle.
constexpr double kAxisBegin = 0.2;
constexpr int kRingCorners = 48;
/// The sine of the angle below which a plane is seen from its edge.
constexpr double kGizmoEdgeOn = 0.12;
constexpr double kMinAxisPixels = 14;
/// Farther than this from where it was, m, nothing is moved by one drag.
constexpr double kMaxGizmoShift = 200;

double distanceToSegment(const QPointF& at, const QPointF& a, const QPointF& b) {
  const QPointF along = b - a;
  const double square = QPointF::dotProduct(along, along);
  const double share = square > 0 ? std::clamp(QPointF::dotProduct(at - a, along) / square, 0.0, 1.0) : 0.0;
  return QLineF(at, a + share * along).length();
}

double distanceToLine(const QPointF& at, const QPolygonF& line) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 1; i < line.size(); ++i)
    nearest = std::min(nearest, distanceToSegment(at, line[i - 1], line[i]));
  return nearest;
}

double snapped(double value, double step) {
  return std::round(value / step) * step;
}

QString signedText(double value, int decimals) {
  return (value < 0 ? QString() : QStringLiteral("+")) + QString::number(value, 'f', decimals);
}

}  // namespace

GizmoAxes axesOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::kX:
      return {0, -1, false};
    case GizmoHandle::kY:
      return {1, -1, false};
    case GizmoHandle::kZ:
      return {2, -1, false};
    case GizmoHandle::kXY:
      return {0, 1, false};
    case GizmoHandle::kYZ:
      return {1, 2, false};
    case GizmoHandle::kXZ:
      return {0, 2, false};
    case GizmoHandle::kTurnX:
      return {0, -1, true};
    case GizmoHandle::kTurnY:
      return {1, -1, true};
    case GizmoHandle::kTurnZ:
      return {2, -1, true};
    case GizmoHandle::kNone:
      break;
  }
  return {};
}

double Gizmo::length(const SceneCamera& camera, const QSizeF& widget) const {
  const Vector3 toObject = pose.translation() - camera.position();
  const double depth = std::max(0.05, -(camera.view().block<3, 3>(0, 0) * toObject).z());
  return depth * 2 * std::tan(SceneCamera::kVerticalAngle / 2) * kGizmoPixels /
         std::max(1.0, widget.height());
}

QPolygonF gizmoOutline(const Gizmo& gizmo, GizmoHandle handle, const SceneCamera& camera,
                       const QSizeF& widget) {
  const GizmoAxes of = axesOf(handle);
  if (of.first < 0) return {};
  const double length = gizmo.length(camera, widget);
  const Vector3 middle = gizmo.pose.translation(), a = gizmo.axes.col(of.first);
  std::vector<Vector3> corners;
  if (of.isTurn) {
    const Vector3 b = gizmo.axes.col((of.first + 1) % 3), c = gizmo.axes.col((of.first + 2) % 3);
    for (int i = 0; i <= kRingCorners; ++i) {
      const double angle = 2 * robotlink::kPi * i / kRingCorners;
      corners.push_back(middle + kRingRadius * length * (std::cos(angle) * b + std::sin(angle) * c));
    }
  } else if (of.second >= 0) {
    const Vector3 sight = (middle - camera.position()).normalized();
    if (std::abs(sight.dot(gizmo.axes.col(of.normal()))) < kGizmoEdgeOn) return {};
    const Vector3 b = gizmo.axes.col(of.second);
    for (const auto& [u, v] : {std::pair{kPlaneInner, kPlaneInner},
                               {kPlaneOuter, kPlaneInner},
                               {kPlaneOuter, kPlaneOuter},
                               {kPlaneInner, kPlaneOuter}})
      corners.push_back(middle + length * (u * a + v * b));
  } else {
    corners = {middle + kAxisBegin * length * a, middle + length * a};
  }
  QPolygonF outline;
  for (const Vector3& corner : corners) {
    const auto at = camera.project(widget, corner);
    if (!at) return {};
    outline << *at;
  }
  const bool isAxis = !of.isTurn && of.second < 0;
  // An axis that points at the viewer would be hit wherever the middle is.
  if (isAxis && QLineF(outline[0], outline[1]).length() < kMinAxisPixels) return {};
  return outline;
}

GizmoHandle Gizmo::handleAt(const SceneCamera& camera, const QSizeF& widget, const QPointF& at) const {
  GizmoHandle found = GizmoHandle::kNone;
  double nearest = kGizmoReach;
  for (const GizmoHandle handle : kGizmoHandles) {
    const QPolygonF outline = gizmoOutline(*this, handle, camera, widget);
    if (outline.isEmpty()) continue;
    const bool isPlane = axesOf(handle).second >= 0;
    if (isPlane && outline.containsPoint(at, Qt::OddEvenFill)) return handle;
    const double distance = isPlane ? nearest : distanceToLine(at, outline);
    if (distance >= nearest) continue;
    nearest = distance;
    found = handle;
  }
  return found;
}

GizmoDrag::GizmoDrag(GizmoHandle handle, const Gizmo& gizmo, const SceneCamera& camera, const QSizeF& widget,
                     const QPointF& at)
    : handle_(handle), gizmo_(gizmo), camera_(camera), widget_(widget), pressed_(at) {
  grabbed_ = onHandle(at);
}

std::optional<Vector3> GizmoDrag::onHandle(const QPointF& at) const {
  const GizmoAxes of = axesOf(handle_);
  if (of.first < 0) return std::nullopt;
  const Ray ray = camera_.ray(widget_, at);
  const Vector3 middle = gizmo_.pose.translation(), axis = gizmo_.axes.col(of.first);
  if (of.isTurn || of.second >= 0) {
    const Vector3 normal = of.isTurn ? axis : Vector3(gizmo_.axes.col(of.normal()));
    const double slope = ray.direction.dot(normal);
    if (std::abs(slope) < 1e-3) return std::nullopt;
    const double distance = (middle - ray.origin).dot(normal) / slope;
    if (!(distance > 0)) return std::nullopt;
    return ray.at(distance);
  }
  // The point of the axis that is nearest to the ray.
  const double along = axis.dot(ray.direction), across = 1 - along * along;
  if (across < 1e-6) return std::nullopt;
  const Vector3 from = middle - ray.origin;
  const double t = (along * ray.direction.dot(from) - axis.dot(from)) / across;
  return middle + t * axis;
}

Vector3 GizmoDrag::shift(const QPointF& at, bool isSnapping) const {
  const GizmoAxes of = axesOf(handle_);
  const auto now = onHandle(at);
  Vector3 shift = Vector3::Zero();
  if (of.isTurn || !now || !grabbed_) return shift;
  const Vector3 moved = gizmo_.axes.transpose() * (*now - *grabbed_);
  const Vector3 start = gizmo_.axes.transpose() * gizmo_.pose.translation();
  for (const int axis : {of.first, of.second}) {
    if (axis < 0) continue;
    double by = std::clamp(moved[axis], -kMaxGizmoShift, kMaxGizmoShift);
    if (isSnapping) by = snapped(start[axis] + by, kSnapLength) - start[axis];
    shift[axis] = by;
  }
  return shift;
}

double GizmoDrag::angle(const QPointF& at, bool isSnapping) const {
  const GizmoAxes of = axesOf(handle_);
  if (!of.isTurn) return 0;
  const Vector3 axis = gizmo_.axes.col(of.first), middle = gizmo_.pose.translation();
  const Vector3 sight = (middle - camera_.position()).normalized();
  double turned = 0;
  const auto now = onHandle(at);
  if (std::abs(sight.dot(axis)) < kGizmoEdgeOn || !now || !grabbed_) {
    // Seen from its edge a ring is rolled by moving along it.
    const auto from = camera_.project(widget_, middle);
    const auto to = camera_.project(
        widget_, middle + gizmo_.length(camera_, widget_) * kRingRadius * axis.cross(sight).normalized());
    if (!from || !to) return 0;
    const QPointF along = *to - *from;
    const double square = QPointF::dotProduct(along, along);
    if (square > 0) turned = -QPointF::dotProduct(at - pressed_, along) / square;
  } else {
    const Vector3 before = *grabbed_ - middle, after = *now - middle;
    turned = std::atan2(axis.dot(before.cross(after)), before.dot(after));
  }
  return isSnapping ? snapped(turned, kSnapAngle) : turned;
}

Pose3 GizmoDrag::poseAt(const QPointF& at, bool isSnapping) const {
  Pose3 pose = gizmo_.pose;
  const GizmoAxes of = axesOf(handle_);
  if (of.first < 0) return pose;
  if (of.isTurn) {
    const Vector3 axis = gizmo_.axes.col(of.first);
    pose.linear() = Eigen::AngleAxisd(angle(at, isSnapping), axis).toRotationMatrix() * pose.linear();
  } else {
    pose.translation() += gizmo_.axes * shift(at, isSnapping);
  }
  return pose;
}

QString GizmoDrag::readout(const QPointF& at, bool isSnapping) const {
  const GizmoAxes of = axesOf(handle_);
  if (of.first < 0) return {};
  const auto name = [](int axis) { return QString(QLatin1Char("xyz"[axis])); };
  if (of.isTurn)
    return QCoreApplication::translate("Gizmo", "%1: %2°")
        .arg(name(of.first), signedText(robotlink::degrees(angle(at, isSnapping)), 1));
  const Vector3 by = shift(at, isSnapping);
  const Vector3 to = gizmo_.axes.transpose() * gizmo_.pose.translation() + by;
  QStringList parts;
  for (const int axis : {of.first, of.second}) {
    if (axis < 0) continue;
    parts << QCoreApplication::translate("Gizmo", "%1: %2 m (%3)")
                 .arg(name(axis), QString::number(to[axis], 'f', 3), signedText(by[axis], 3));
  }
  return parts.join(QStringLiteral("  "));
}

}  // namespace widgets
