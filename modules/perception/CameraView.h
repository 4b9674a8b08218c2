// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Geometry.h"

namespace modules {

/// A pinhole camera at a known pose: converts between pixels, directions and positions on the ground. A plain
/// value.
///
/// Camera frame: x along the optical axis, which meets the image at its center, y to the left, z up. Robot
/// frame: on the ground, x to the front. Image coordinates are in pixels, (0, 0) is the upper left corner, y
/// points down.
struct CameraView {
  robotlink::Pose3 cameraInRobot = robotlink::Pose3::Identity();
  /// Pixels.
  int width = 176;
  int height = 144;
  /// Pixels.
  double focalX = 160.07;
  double focalY = 162.48;

  /// Computes the focal lengths from full fields of view, rad.
  static CameraView fromAngles(const robotlink::Pose3& cameraInRobot, double horizontalAngle,
                               double verticalAngle, int width, int height);

  robotlink::Vector2 center() const { return {0.5 * width, 0.5 * height}; }
  bool contains(const robotlink::Vector2& pixel) const {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < width && pixel.y() < height;
  }
  /// The direction of a pixel in the axes of the robot; its component along the optical axis is 1.
  robotlink::Vector3 ray(const robotlink::Vector2& pixel) const;
  /// The intersection of a pixel's ray with the horizontal plane at this height; empty if it is not in front
  /// of the camera.
  std::optional<robotlink::Vector2> onPlane(const robotlink::Vector2& pixel, double planeHeight) const;
  /// The pixel of a point in the robot's frame, which may be outside the image; empty if the point is not in
  /// front of the camera.
  std::optional<robotlink::Vector2> pixelOf(const robotlink::Vector3& point) const;
  /// The angle of a pixel's ray above the horizontal plane, rad.
  double elevation(const robotlink::Vector2& pixel) const;
  /// The angle of a pixel's ray about the robot's z-axis, counterclockwise from its x-axis, rad.
  double bearing(const robotlink::Vector2& pixel) const;
  /// The row of the horizon in a column; height / 2 for a level camera. Empty if the camera looks straight up
  /// or down.
  std::optional<double> horizonRow(double column) const;
};

}  // namespace modules
