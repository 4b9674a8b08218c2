// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/ball/RollingBallFilter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace modules {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector4d;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

/// The variance of the velocity of a ball of which nothing is known, and of one at rest, m^2/s^2.
constexpr double kUnknownVelocity = 0.09, kRestVelocity = 1e-6;
constexpr double kStartProbability = 0.3;

}  // namespace

void RollingBallFilter::restart(const Vector2& position, const Matrix2d& covariance) {
  for (Model& model : models_) {
    model.state << position, 0, 0;
    model.covariance.setZero();
    model.covariance.topLeftCorner<2, 2>() = covariance;
  }
  models_[kRest].covariance.bottomRightCorner<2, 2>() = Matrix2d::Identity() * kRestVelocity;
  models_[kRoll].covariance.bottomRightCorner<2, 2>() = Matrix2d::Identity() * kUnknownVelocity;
  models_[kRoll].probability = kStartProbability;
  models_[kRest].probability = 1 - kStartProbability;
  outliers_ = 0;
}

void RollingBallFilter::mix(double seconds) {
  // Rates of changes become probabilities within this time.
  const std::array leave{1 - std::exp(-options_.startRate * seconds),
                         1 - std::exp(-options_.stopRate * seconds)};
  const std::array before = models_;
  for (const std::size_t to : {0U, 1U}) {
    const std::size_t other = 1 - to;
    const double stayed = before[to].probability * (1 - leave[to]);
    const double came = before[other].probability * leave[other];
    Model& model = models_[to];
    model.probability = stayed + came;
    const double share = came / std::max(1e-12, model.probability);
    Model source = before[other];
    // A ball that began to roll may have any velocity, one that has stopped has none.
    source.state.tail<2>().setZero();
    source.covariance.topRightCorner<2, 2>().setZero();
    source.covariance.bottomLeftCorner<2, 2>().setZero();
    source.covariance.bottomRightCorner<2, 2>() =
        Matrix2d::Identity() * (to == kRoll ? kUnknownVelocity : kRestVelocity);
    model.state = (1 - share) * before[to].state + share * source.state;
    const Vector4d a = before[to].state - model.state, b = source.state - model.state;
    model.covariance = (1 - share) * (before[to].covariance + a * a.transpose()) +
                       share * (source.covariance + b * b.transpose());
  }
}

void RollingBallFilter::rest(Model& model, double seconds) const {
  model.covariance.diagonal().head<2>().array() += options_.drift * options_.drift * seconds;
}

void RollingBallFilter::roll(Model& model, double seconds) const {
  const double speed = model.state.tail<2>().norm();
  const double slower = options_.roll.speedAfter(speed, seconds);
  const double decay = speed > 1e-6 ? slower / speed : 1;
  Matrix4d transition = Matrix4d::Identity();
  transition(0, 2) = transition(1, 3) = 0.5 * (1 + decay) * seconds;
  transition(2, 2) = transition(3, 3) = decay;
  model.state = transition * model.state;
  // Differences of velocities decay by damping only: a deceleration that does not depend on the speed leaves
  // them as they are.
  transition(0, 2) = transition(1, 3) = seconds;
  transition(2, 2) = transition(3, 3) = std::exp(-options_.roll.damping * seconds);
  const double a = options_.acceleration * options_.acceleration, s2 = seconds * seconds;
  Matrix4d noise = Matrix4d::Zero();
  noise.topLeftCorner<2, 2>() =
      Matrix2d::Identity() * (0.25 * a * s2 * s2 + options_.drift * options_.drift * seconds);
  noise.topRightCorner<2, 2>() = noise.bottomLeftCorner<2, 2>() =
      Matrix2d::Identity() * (0.5 * a * s2 * seconds);
  noise.bottomRightCorner<2, 2>() = Matrix2d::Identity() * (a * s2);
  model.covariance = transition * model.covariance * transition.transpose() + noise;
}

double RollingBallFilter::squaredDistance(const Model& model, const Vector2& measured,
                                          const Matrix2d& covariance) {
  const Matrix2d innovation = model.covariance.topLeftCorner<2, 2>() + covariance;
  const Vector2 difference = measured - model.state.head<2>();
  return difference.dot(innovation.inverse() * difference);
}

double RollingBallFilter::correct(Model& model, const Vector2& measured, const Matrix2d& covariance) {
  const Matrix2d innovation = model.covariance.topLeftCorner<2, 2>() + covariance;
  const Matrix2d inverse = innovation.inverse();
  const Vector2 difference = measured - model.state.head<2>();
  const Eigen::Matrix<double, 4, 2> gain = model.covariance.leftCols<2>() * inverse;
  model.state += gain * difference;
  model.covariance -= (gain * model.covariance.topRows<2>()).eval();
  return std::exp(-0.5 * difference.dot(inverse * difference)) / std::sqrt(innovation.determinant());
}

void RollingBallFilter::see(const BallMeasurement& seen, const Pose2& robotInOdometry, double time) {
  const Vector2 measured = robotInOdometry * seen.position;
  const Matrix2d covariance = options_.accuracy.covariance(seen.position, seen.confidence, robotInOdometry);
  const double gate = options_.gate * options_.gate;
  if (!seenAt_ || time - *seenAt_ > options_.memory) {
    restart(measured, covariance);
  } else if (squaredDistance(models_[kRest], measured, covariance) > gate &&
             squaredDistance(models_[kRoll], measured, covariance) > gate) {
    // A single wrong percept must not move the ball; several at the same place mean that the ball was moved.
    const double deviation = std::sqrt(covariance.trace());
    const bool again = outliers_ > 0 && (measured - lastOutlier_).norm() < 0.15 + 3 * deviation;
    outliers_ = again ? outliers_ + 1 : 1;
    lastOutlier_ = measured;
    if (outliers_ < options_.outliersToRestart) return;
    restart(measured, covariance);
  } else {
    double sum = 0;
    for (Model& model : models_) {
      model.probability *= std::max(1e-9, correct(model, measured, covariance));
      sum += model.probability;
    }
    for (Model& model : models_) model.probability /= sum;
    outliers_ = 0;
  }
  seenAt_ = time;
}

RollingBallFilter::Model RollingBallFilter::combined() const {
  Model mean;
  mean.state.setZero();
  mean.covariance.setZero();
  for (const Model& model : models_) mean.state += model.probability * model.state;
  for (const Model& model : models_) {
    const Vector4d off = model.state - mean.state;
    mean.covariance += model.probability * (model.covariance + off * off.transpose());
  }
  return mean;
}

void RollingBallFilter::forget() {
  seenAt_.reset();
  estimate_.known = false;
}

void RollingBallFilter::update(double time, const Pose2& robotInOdometry,
                               const std::optional<BallMeasurement>& seen) {
  const double seconds = updatedAt_ ? time - *updatedAt_ : 0;
  updatedAt_ = time;
  if (seconds > 0 && seenAt_) {
    mix(seconds);
    rest(models_[kRest], seconds);
    roll(models_[kRoll], seconds);
  }
  if (seen) see(*seen, robotInOdometry, time);
  if (!seenAt_) return;
  const Model mean = combined();
  estimate_.secondsSinceSeen = time - *seenAt_;
  estimate_.known = estimate_.secondsSinceSeen <= options_.memory;
  estimate_.position = robotInOdometry.inverse() * Vector2(mean.state.head<2>());
  estimate_.velocity = Pose2{0, 0, -robotInOdometry.heading} * Vector2(mean.state.tail<2>());
  estimate_.deviation = std::sqrt(0.5 * (mean.covariance(0, 0) + mean.covariance(1, 1)));
}

}  // namespace modules
