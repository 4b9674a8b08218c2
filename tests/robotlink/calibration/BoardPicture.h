// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "robotlink/base/Image.h"
#include "robotlink/calibration/LensModel.h"

namespace robotlink::test {

/// A pose that looks down: Rz(pan) Ry(tilt) Rx(roll), angles in rad.
inline Pose3 cameraAt(const Vector3& place, double pan, double tilt, double roll) {
  return Eigen::Translation3d(place) * Eigen::AngleAxisd(pan, Vector3::UnitZ()) *
         Eigen::AngleAxisd(tilt, Vector3::UnitY()) * Eigen::AngleAxisd(roll, Vector3::UnitX());
}

/// Where a camera without distortion sees a point.
inline Vector2 pixelOf(const Vector3& point, const Pose3& camera, const LensModel& lens) {
  const Vector3 seen = camera.inverse() * point;
  return {lens.centerX - lens.focalX * seen.y() / seen.x(), lens.centerY - lens.focalY * seen.z() / seen.x()};
}

/// What a camera sees of a chessboard in the plane z = 0 of its frame, with a white rim on gray ground. Each
/// pixel is the mean of 3 x 3 rays.
inline Image boardPicture(const Chessboard& board, const Pose3& camera, const LensModel& lens) {
  const Eigen::Matrix3d axes = camera.rotation();
  const Vector3 from = camera.translation();
  const auto brightness = [&](double column, double row) {
    const double left = -(column - lens.centerX) / lens.focalX, up = -(row - lens.centerY) / lens.focalY;
    const auto ray = [&](int axis) { return axes(axis, 0) + axes(axis, 1) * left + axes(axis, 2) * up; };
    const double way = -from.z() / ray(2);
    if (!(way > 0)) return 110.0;
    // The first inner corner is the origin, so that squares reach from -1 on.
    const double x = (from.x() + way * ray(0)) / board.square, y = (from.y() + way * ray(1)) / board.square;
    if (x < -2 || y < -2 || x > board.columns + 1 || y > board.rows + 1) return 110.0;
    if (x < -1 || y < -1 || x > board.columns || y > board.rows) return 235.0;
    return (static_cast<int>(std::floor(x)) + static_cast<int>(std::floor(y))) % 2 == 0 ? 25.0 : 235.0;
  };
  Image image(lens.width, lens.height, PixelFormat::kRgb8);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      double sum = 0;
      for (const double dy : {1.0 / 6, 0.5, 5.0 / 6})
        for (const double dx : {1.0 / 6, 0.5, 5.0 / 6}) sum += brightness(x + dx, y + dy);
      for (int channel = 0; channel < 3; ++channel)
        image.row(y)[3 * x + channel] = static_cast<std::uint8_t>(sum / 9 + 0.5);
    }
  return image;
}

/// Poses in which the whole of the usual board fills much of an image of 320 x 240 pixels.
inline std::vector<Pose3> boardPoses() {
  const Vector3 middle(0.1, 0.0625, 0);
  std::vector<Pose3> poses;
  for (const auto& [pan, tilt, roll, distance] : {std::array{0.0, 1.5, 0.1, 0.36},
                                                  {0.5, 1.1, 0.0, 0.38},
                                                  {-0.6, 1.0, 0.2, 0.40},
                                                  {1.2, 1.2, -0.3, 0.37},
                                                  {2.0, 1.0, 0.1, 0.42},
                                                  {-1.4, 1.3, 0.4, 0.45}}) {
    const Pose3 turned = cameraAt(Vector3::Zero(), pan, tilt, roll);
    poses.push_back(cameraAt(middle - distance * turned.rotation().col(0), pan, tilt, roll));
  }
  return poses;
}

}  // namespace robotlink::test
