// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/BallFilter.h"

#include <Eigen/LU>
#include <cmath>

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

void LastBall::update(double time, const Pose2& robotInOdometry, const std::optional<BallMeasurement>& seen) {
  if (seen) {
    inOdometry_ = robotInOdometry * seen->position;
    seenAt_ = time;
  }
  if (!seenAt_) return;
  estimate_.secondsSinceSeen = time - *seenAt_;
  estimate_.known = estimate_.secondsSinceSeen <= options_.memory;
  estimate_.position = robotInOdometry.inverse() * inOdometry_;
  estimate_.deviation = 0.03 + 0.05 * estimate_.position.norm() + 0.05 * estimate_.secondsSinceSeen;
}

void LastBall::forget() {
  seenAt_.reset();
  estimate_.known = false;
}

void BallFilter::forget() {
  seenAt_.reset();
  estimate_.known = false;
}

void BallFilter::restart(const Vector2& position, double deviation) {
  state_ << position, 0, 0;
  const double square = deviation * deviation;
  covariance_ = Eigen::Vector4d(square, square, 0.04, 0.04).asDiagonal();
  outliers_ = 0;
}

void BallFilter::predict(double seconds) {
  if (seconds <= 0) return;
  const double decay = std::exp(-options_.friction * seconds);
  Eigen::Matrix4d transition = Eigen::Matrix4d::Identity();
  transition(0, 2) = transition(1, 3) = seconds;
  transition(2, 2) = transition(3, 3) = decay;
  state_ = transition * state_;
  const double a = options_.acceleration * options_.acceleration;
  const double s2 = seconds * seconds;
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  noise.topLeftCorner<2, 2>() = Eigen::Matrix2d::Identity() * (0.25 * a * s2 * s2);
  noise.topRightCorner<2, 2>() = noise.bottomLeftCorner<2, 2>() =
      Eigen::Matrix2d::Identity() * (0.5 * a * s2 * seconds);
  noise.bottomRightCorner<2, 2>() = Eigen::Matrix2d::Identity() * (a * s2);
  covariance_ = transition * covariance_ * transition.transpose() + noise;
}

void BallFilter::correct(const BallMeasurement& seen, const Pose2& robotInOdometry, double time) {
  const Vector2 measured = robotInOdometry * seen.position;
  const double doubt = 1 + 2 * (1 - seen.confidence);
  const double deviation =
      doubt * (options_.deviationNear + options_.deviationPerMeter * seen.position.norm());
  if (!seenAt_) {
    restart(measured, deviation);
    seenAt_ = time;
    return;
  }
  const Eigen::Matrix2d innovation =
      covariance_.topLeftCorner<2, 2>() + Eigen::Matrix2d::Identity() * deviation * deviation;
  const Vector2 difference = measured - state_.head<2>();
  if (difference.dot(innovation.inverse() * difference) > options_.gate * options_.gate) {
    // A single wrong percept must not move the ball; several at the same place mean that the ball was moved.
    const bool again = outliers_ > 0 && (measured - lastOutlier_).norm() < 0.1 + 3 * deviation;
    outliers_ = again ? outliers_ + 1 : 1;
    lastOutlier_ = measured;
    if (outliers_ < options_.outliersToRestart) return;
    restart(measured, deviation);
  } else {
    const Eigen::Matrix<double, 4, 2> gain = covariance_.leftCols<2>() * innovation.inverse();
    state_ += gain * difference;
    covariance_ -= gain * covariance_.topRows<2>();
    outliers_ = 0;
  }
  seenAt_ = time;
}

void BallFilter::update(double time, const Pose2& robotInOdometry,
                        const std::optional<BallMeasurement>& seen) {
  if (updatedAt_) predict(time - *updatedAt_);
  updatedAt_ = time;
  if (seen) correct(*seen, robotInOdometry, time);
  if (!seenAt_) return;
  estimate_.secondsSinceSeen = time - *seenAt_;
  estimate_.known = estimate_.secondsSinceSeen <= options_.memory;
  estimate_.position = robotInOdometry.inverse() * Vector2(state_.head<2>());
  estimate_.velocity = Pose2{0, 0, -robotInOdometry.heading} * Vector2(state_.tail<2>());
  estimate_.deviation = std::sqrt(0.5 * (covariance_(0, 0) + covariance_(1, 1)));
}

}  // namespace modules
