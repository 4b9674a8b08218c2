// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The accuracy of a ball percept: its distance is much less certain than its direction, and the more so the
/// farther away the ball is. A plain value.
struct BallAccuracy {
  /// Standard deviation along the ray, m, plus this for each meter of distance.
  double deviationNear = 0.008, deviationPerMeter = 0.03;
  /// Across the ray, rad.
  double bearingDeviation = 0.015;

  /// The covariance in the frame of dead reckoning of a percept of the robot at this pose, m^2. Lower
  /// confidence (from 0 to 1) makes it wider.
  Eigen::Matrix2d covariance(const robotlink::Vector2& inRobot, double confidence,
                             const robotlink::Pose2& robotInOdometry) const {
    const double doubt = 1 + 2 * (1 - confidence), distance = inRobot.norm();
    const double along = doubt * (deviationNear + deviationPerMeter * distance);
    const double across = doubt * (0.5 * deviationNear + bearingDeviation * distance);
    const double heading = robotInOdometry.heading + std::atan2(inRobot.y(), inRobot.x());
    Eigen::Matrix2d axes;
    axes << std::cos(heading), -std::sin(heading), std::sin(heading), std::cos(heading);
    const Eigen::Vector2d variances(along * along, across * across);
    return axes * variances.asDiagonal() * axes.transpose();
  }
};

}  // namespace modules
