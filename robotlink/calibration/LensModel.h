// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"

// The intrinsics and the pose of a camera, and the points by which it is calibrated. Plain values. Pixels:
// (0, 0) is the upper left corner of the image, y points down.
namespace robotlink {

/// A chessboard, by its inner corners, where four squares meet.
struct Chessboard {
  int columns = 9, rows = 6;
  /// The side of a square, m.
  double square = 0.025;

  /// Whether it can be found: 3 to 50 corners each way, and not as many rows as columns, since such a board
  /// looks the same from all sides.
  bool isUsable() const;
  /// Row by row in the board's frame, m: x along the rows, y along the columns, z = 0.
  std::vector<Vector3> corners() const;
  bool operator==(const Chessboard&) const = default;
};

/// A pinhole with the distortion of its lens.
struct LensModel {
  int width = 0, height = 0;
  /// Pixels.
  double focalX = 0, focalY = 0, centerX = 0, centerY = 0;
  /// k1, k2, p1, p2, k3 of Brown's model, as OpenCV orders them.
  std::array<double, 5> distortion{};

  /// Makes the lens of a camera that is known by its field of view only, rad: its pixels are squares, its
  /// axis is in the middle.
  static LensModel fromAngle(int width, int height, double horizontalAngle);
  /// Whole fields of view through the middle of the image, without distortion, rad.
  double horizontalAngle() const;
  double verticalAngle() const;
  bool operator==(const LensModel&) const = default;
};

/// A lens that was computed from several views of a chessboard.
struct LensFit {
  LensModel lens;
  /// The root mean squares of the corners' distances from where the model has them, in pixels: of all views,
  /// and of each.
  double error = 0;
  std::vector<double> viewErrors = {};
};

/// The place of a camera that was computed from points that it sees.
struct PlaceFit {
  /// Camera frame: x along the optical axis, y to the left, z up.
  Pose3 cameraInWorld = Pose3::Identity();
  /// The root mean square of the points' distances from where the camera would see them, and each, in pixels.
  double error = 0;
  std::vector<double> errors = {};

  /// The camera's height above z = 0, m; its axis below the horizontal, its roll clockwise as seen from
  /// behind, and where it looks about z, rad. The rotation is Rz(pan) Ry(tilt) Rx(roll).
  double height() const;
  double tilt() const;
  double roll() const;
  double pan() const;
};

}  // namespace robotlink
