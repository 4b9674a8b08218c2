// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/space/ColorSpaceCamera.h"

#include <Eigen/Geometry>
#include <QJsonArray>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace widgets {
namespace {

constexpr double kPerPixel = 0.0085;  // rad
constexpr double kFit = 0.57;         // of the shorter side: the cube's side
constexpr double kSteepest = std::numbers::pi / 2;
constexpr double kFarthestPan = 20;

double shorterSide(const QSizeF& widget) {
  return std::max(1.0, std::min(widget.width(), widget.height()));
}

QPointF clampedPan(const QPointF& pan) {
  return {std::clamp(pan.x(), -kFarthestPan, kFarthestPan), std::clamp(pan.y(), -kFarthestPan, kFarthestPan)};
}

}  // namespace

Eigen::Matrix3f ColorSpaceCamera::rotation() const {
  const Eigen::Vector3d toViewer(std::cos(elevation) * std::cos(azimuth),
                                 std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Eigen::Vector3d right(-std::sin(azimuth), std::cos(azimuth), 0);
  Eigen::Matrix3d rotation;
  rotation << right.transpose(), toViewer.cross(right).transpose(), toViewer.transpose();
  return rotation.cast<float>();
}

void ColorSpaceCamera::turn(const QPointF& by) {
  azimuth = std::remainder(azimuth - by.x() * kPerPixel, 2 * std::numbers::pi);
  elevation = std::clamp(elevation + by.y() * kPerPixel, -kSteepest, kSteepest);
}

void ColorSpaceCamera::move(const QSizeF& widget, const QPointF& by) {
  pan = clampedPan(pan + by / shorterSide(widget));
}

void ColorSpaceCamera::zoomBy(const QSizeF& widget, double factor, const QPointF& at) {
  const double before = zoom;
  zoom = std::clamp(zoom * factor, kMinZoom, kMaxZoom);
  const QPointF cursor = (at - QPointF(widget.width(), widget.height()) / 2) / shorterSide(widget);
  pan = clampedPan(cursor + (pan - cursor) * (zoom / before));
}

QJsonObject stateOf(const ColorSpaceCamera& camera) {
  return {{QStringLiteral("azimuth"), camera.azimuth},
          {QStringLiteral("elevation"), camera.elevation},
          {QStringLiteral("zoom"), camera.zoom},
          {QStringLiteral("pan"), QJsonArray{camera.pan.x(), camera.pan.y()}}};
}

ColorSpaceCamera colorSpaceCameraOf(const QJsonObject& state) {
  ColorSpaceCamera camera;
  camera.azimuth =
      std::remainder(state[QStringLiteral("azimuth")].toDouble(camera.azimuth), 2 * std::numbers::pi);
  camera.elevation =
      std::clamp(state[QStringLiteral("elevation")].toDouble(camera.elevation), -kSteepest, kSteepest);
  camera.zoom = std::clamp(state[QStringLiteral("zoom")].toDouble(1), ColorSpaceCamera::kMinZoom,
                           ColorSpaceCamera::kMaxZoom);
  const QJsonArray pan = state[QStringLiteral("pan")].toArray();
  camera.pan = clampedPan({pan.at(0).toDouble(), pan.at(1).toDouble()});
  return camera;
}

ColorSpaceProjection::ColorSpaceProjection(const ColorSpaceCamera& camera, const QSizeF& picture)
    : rotation_(camera.rotation()),
      scale_(static_cast<float>(kFit * shorterSide(picture) * camera.zoom)),
      centerX_(static_cast<float>(picture.width() / 2 + camera.pan.x() * shorterSide(picture))),
      centerY_(static_cast<float>(picture.height() / 2 + camera.pan.y() * shorterSide(picture))) {}

}  // namespace widgets
