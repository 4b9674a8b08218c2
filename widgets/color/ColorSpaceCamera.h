// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QJsonObject>
#include <QPointF>
#include <QSizeF>

namespace widgets {

/// From where a colour space is looked at: a cube of side 1 around the origin, z up, turned around its
/// middle. A plain value; angles in radians.
struct ColorSpaceCamera {
  static constexpr double kMinZoom = 0.4, kMaxZoom = 30;

  double azimuth = 0.75;    ///< of the viewer, from x to y
  double elevation = 0.35;  ///< of the viewer, from straight below to straight above
  double zoom = 1;          ///< 1: the cube fits
  QPointF pan;              ///< where the middle is, from the widget's, as shares of its shorter side

  bool operator==(const ColorSpaceCamera&) const = default;

  /// Rows: what is right, up, and towards the viewer.
  Eigen::Matrix3f rotation() const;
  /// What a drag by so many pixels does.
  void turn(const QPointF& by);
  void move(const QSizeF& widget, const QPointF& by);
  /// What is at `at`, in pixels, stays there.
  void zoomBy(const QSizeF& widget, double factor, const QPointF& at);
};

QJsonObject stateOf(const ColorSpaceCamera& camera);
/// What is missing or out of bounds is replaced.
ColorSpaceCamera colorSpaceCameraOf(const QJsonObject& state);

/// Where a camera sees places in a picture of a certain size.
class ColorSpaceProjection {
 public:
  ColorSpaceProjection(const ColorSpaceCamera& camera, const QSizeF& picture);

  /// x and y in pixels from the upper left, z the distance from the viewer.
  Eigen::Vector3f operator()(const Eigen::Vector3f& place) const {
    const Eigen::Vector3f seen = rotation_ * place;
    const float distance = kViewer - seen.z();
    const float pixels = scale_ * kViewer / distance;
    return {centerX_ + pixels * seen.x(), centerY_ - pixels * seen.y(), distance};
  }
  QPointF point(const Eigen::Vector3f& place) const {
    const Eigen::Vector3f seen = (*this)(place);
    return {static_cast<double>(seen.x()), static_cast<double>(seen.y())};
  }
  const Eigen::Matrix3f& rotation() const { return rotation_; }
  /// Returns how many pixels a length of 1 in the middle has.
  float pixels() const { return scale_; }
  /// Whether a plane through `place` shows that side to the viewer to which `normal` points.
  bool facesViewer(const Eigen::Vector3f& place, const Eigen::Vector3f& normal) const {
    return (kViewer * toViewer() - place).dot(normal) > 0;
  }
  Eigen::Vector3f toViewer() const { return rotation_.row(2).transpose(); }

 private:
  static constexpr float kViewer = 3.2F;  ///< how far away the viewer is: a little perspective

  Eigen::Matrix3f rotation_;
  float scale_, centerX_, centerY_;
};

}  // namespace widgets
