// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BodyPosture.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace modules {

using robotlink::Pose3;
using robotlink::Vector3;

Pose3 BodyTilt::bodyInRobot() const {
  return Pose3(Eigen::Translation3d(0, 0, height)) *
         Pose3(Eigen::AngleAxisd(pitch, Vector3::UnitY()) * Eigen::AngleAxisd(roll, Vector3::UnitX()));
}

Pose3 cameraInBody(const RobotDimensions& dimensions, const NeckAngles& neck) {
  const auto turn = [](double angle, const Vector3& axis) { return Pose3(Eigen::AngleAxisd(angle, axis)); };
  const auto shift = [](double x, double z) { return Pose3(Eigen::Translation3d(x, 0, z)); };
  return shift(dimensions.neckX, dimensions.neckZ) * turn(-neck.tilt, Vector3::UnitY()) *
         shift(0, dimensions.neckLength) * turn(neck.pan, Vector3::UnitZ()) *
         turn(neck.roll, Vector3::UnitX()) * shift(dimensions.cameraX, 0);
}

BodyTilt BodyPosture::estimate(const std::array<LegAngles, 4>& angles,
                               const std::array<bool, 4>& contacts) const {
  // The plane z = c + a x + b y through the paws' centers, in the axes of the body. A lever of the hip's
  // length makes slopes and heights comparable.
  const double lever = legs_.dimensions().hipX, usual = std::tan(options_.usualPitch);
  Eigen::Matrix3d normal = Eigen::Vector3d(0, 1, 1).asDiagonal();
  normal *= options_.levelWeight * lever * lever;
  Vector3 right(0, options_.levelWeight * lever * lever * usual, 0);
  for (const Leg leg : kLegs) {
    const Vector3 paw = legs_.hipInBody(leg) + legs_.pawInHip(leg, angles[index(leg)]);
    const double weight = contacts[index(leg)] ? options_.groundWeight : 1;
    const Vector3 row(1, paw.x(), paw.y());
    normal += weight * row * row.transpose();
    right += weight * row * paw.z();
  }
  const Vector3 plane = normal.ldlt().solve(right);
  const double a = plane.y(), b = plane.z();
  const double length = std::sqrt(1 + a * a + b * b);
  return {-plane.x() / length + legs_.dimensions().pawRadius, std::atan(a), std::asin(-b / length)};
}

}  // namespace modules
