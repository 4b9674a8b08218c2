// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "robotlink/base/Geometry.h"

namespace modules {

/// A pinhole camera at a known place: from pixels to directions and to the ground, and back. A plain value.
///
/// Camera frame: x along the optical axis, which pierces the image's centre, y to the left, z up. Robot
/// frame: on the ground, x to the front. Image coordinates in pixels, (0, 0) the upper left corner, y down.
struct CameraView {
  robotlink::Pose3 cameraInRobot = robotlink::Pose3::Identity();
  int width = 176;  ///< pixels
  int height = 144;
  double focalX = 160.07;  ///< pixels
  double focalY = 162.48;

  static CameraView fromAngles(const robotlink::Pose3& cameraInRobot, double horizontalAngle,
                               double verticalAngle, int width, int height);

  robotlink::Vector2 center() const { return {0.5 * width, 0.5 * height}; }
  bool contains(const robotlink::Vector2& pixel) const {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < width && pixel.y() < height;
  }
  /// Direction of a pixel in the robot's axes; its component along the optical axis is 1.
  robotlink::Vector3 ray(const robotlink::Vector2& pixel) const;
  /// Where the ray of a pixel meets the level plane of this height before the camera.
  std::optional<robotlink::Vector2> onPlane(const robotlink::Vector2& pixel, double planeHeight) const;
  /// The pixel of a point in the robot's frame, also outside the image; none if it is not before the camera.
  std::optional<robotlink::Vector2> pixelOf(const robotlink::Vector3& point) const;
  /// Angle of a pixel's ray above the level plane, rad.
  double elevation(const robotlink::Vector2& pixel) const;
  /// Angle of a pixel's ray about the robot's z-axis, rad, counter-clockwise from its x-axis.
  double bearing(const robotlink::Vector2& pixel) const;
  /// Row of the horizon in a column; a level camera has it at height / 2. None where the camera looks
  /// straight up or down.
  std::optional<double> horizonRow(double column) const;
};

}  // namespace modules
