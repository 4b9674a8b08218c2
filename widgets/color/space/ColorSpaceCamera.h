// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QJsonObject>
#include <QPointF>
#include <QSizeF>

namespace widgets {

/// The camera that looks at a color space: a cube of side 1 around the origin, z up, which is turned around
/// its center. A plain value; angles in radians.
struct ColorSpaceCamera {
  static constexpr double kMinZoom = 0.4, kMaxZoom = 30;

  /// Direction of the viewer around z, from x toward y.
  double azimuth = 0.75;
  /// Elevation of the viewer, from -pi/2 (straight below) to pi/2 (straight above).
  double elevation = 0.35;
  /// 1: the cube fits into the widget.
  double zoom = 1;
  /// Offset of the cube's center from the widget's center, as a share of the widget's shorter side.
  QPointF pan;

  bool operator==(const ColorSpaceCamera&) const = default;

  /// From the space to the viewer. Rows: right, up, and toward the viewer.
  Eigen::Matrix3f rotation() const;
  /// Turns as for a drag by `by` widget pixels.
  void turn(const QPointF& by);
  /// Pans by `by` widget pixels.
  void move(const QSizeF& widget, const QPointF& by);
  /// Zooms; what is at `at` (widget pixels) stays there.
  void zoomBy(const QSizeF& widget, double factor, const QPointF& at);
};

/// For saved window layouts.
QJsonObject stateOf(const ColorSpaceCamera& camera);
/// The inverse of stateOf(). Missing values get their defaults, values out of bounds are clamped.
ColorSpaceCamera colorSpaceCameraOf(const QJsonObject& state);

/// The perspective projection of a camera to a picture of a certain size. A plain value.
class ColorSpaceProjection {
 public:
  /// `picture`: size in pixels, those of the widget or of the device.
  ColorSpaceProjection(const ColorSpaceCamera& camera, const QSizeF& picture);

  /// Projects a place; x and y in pixels from the upper left, z the distance from the viewer.
  Eigen::Vector3f operator()(const Eigen::Vector3f& place) const {
    const Eigen::Vector3f seen = rotation_ * place;
    const float distance = kViewer - seen.z();
    const float pixels = scale_ * kViewer / distance;
    return {centerX_ + pixels * seen.x(), centerY_ - pixels * seen.y(), distance};
  }
  /// Projects a place to pixels from the upper left.
  QPointF point(const Eigen::Vector3f& place) const {
    const Eigen::Vector3f seen = (*this)(place);
    return {static_cast<double>(seen.x()), static_cast<double>(seen.y())};
  }
  const Eigen::Matrix3f& rotation() const { return rotation_; }
  /// Returns how many pixels a length of 1 in the middle has.
  float pixels() const { return scale_; }
  /// Whether the viewer sees that side of a plane through `place` to which `normal` points.
  bool facesViewer(const Eigen::Vector3f& place, const Eigen::Vector3f& normal) const {
    return (kViewer * toViewer() - place).dot(normal) > 0;
  }
  /// Direction from the center to the viewer, of length 1.
  Eigen::Vector3f toViewer() const { return rotation_.row(2).transpose(); }

 private:
  /// Distance of the viewer from the center: a weak perspective.
  static constexpr float kViewer = 3.2F;

  Eigen::Matrix3f rotation_;
  float scale_, centerX_, centerY_;
};

}  // namespace widgets
