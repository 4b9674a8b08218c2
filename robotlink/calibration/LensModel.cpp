// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/calibration/LensModel.h"

#include <cmath>

namespace robotlink {

bool Chessboard::isUsable() const {
  constexpr int kMinCorners = 3, kMaxCorners = 50;
  const auto isUsual = [](int corners) { return corners >= kMinCorners && corners <= kMaxCorners; };
  return isUsual(columns) && isUsual(rows) && columns != rows && std::isfinite(square) && square > 0;
}

std::vector<Vector3> Chessboard::corners() const {
  std::vector<Vector3> all;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) all.emplace_back(column * square, row * square, 0);
  return all;
}

LensModel LensModel::fromAngle(int width, int height, double horizontalAngle) {
  const double focal = 0.5 * width / std::tan(0.5 * horizontalAngle);
  return {width, height, focal, focal, 0.5 * width, 0.5 * height};
}

double LensModel::horizontalAngle() const {
  return 2 * std::atan(0.5 * width / focalX);
}

double LensModel::verticalAngle() const {
  return 2 * std::atan(0.5 * height / focalY);
}

double PlaceFit::height() const {
  return cameraInWorld.translation().z();
}

double PlaceFit::tilt() const {
  return std::asin(std::clamp(-cameraInWorld.rotation()(2, 0), -1.0, 1.0));
}

double PlaceFit::roll() const {
  const Eigen::Matrix3d rotation = cameraInWorld.rotation();
  return std::atan2(rotation(2, 1), rotation(2, 2));
}

double PlaceFit::pan() const {
  const Eigen::Matrix3d rotation = cameraInWorld.rotation();
  return std::atan2(rotation(1, 0), rotation(0, 0));
}

}  // namespace robotlink
