// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "robotlink/base/Geometry.h"

namespace modules {

/// The estimated state of the ball, in the robot's frame, meters.
struct BallEstimate {
  /// False before the first percept, and when the last one is too old.
  bool known = false;
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  /// Over ground, m/s.
  robotlink::Vector2 velocity = robotlink::Vector2::Zero();
  double secondsSinceSeen = 0;
  /// Standard deviation of the position, m.
  double deviation = 0;
};

/// A ball percept.
struct BallMeasurement {
  /// In the robot's frame, m.
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  /// From 0 to 1.
  double confidence = 0;
};

/// The simplest ball model: the ball stays where it was seen last, while the robot moves. Not thread-safe.
class LastBall {
 public:
  struct Options {
    /// The time for which a percept is used, s.
    double memory = 4;
  };
  explicit LastBall(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame. `time` is that of any clock, s; `robotInOdometry` is the pose by dead reckoning.
  void update(double time, const robotlink::Pose2& robotInOdometry,
              const std::optional<BallMeasurement>& seen);
  /// The ball is unknown until the next percept, with which the estimator starts again.
  void forget();
  BallEstimate estimate() const { return estimate_; }

 private:
  Options options_;
  BallEstimate estimate_;
  /// The last percept in the odometry frame.
  robotlink::Vector2 inOdometry_ = robotlink::Vector2::Zero();
  std::optional<double> seenAt_;
};

/// A Kalman filter for position and velocity of the ball in the odometry frame, in which a resting ball stays
/// in place although the robot walks. Rolling balls slow down. Percepts that do not fit are ignored until
/// several agree with each other. Not thread-safe.
class BallFilter {
 public:
  struct Options {
    /// The time for which the ball is known without percepts, s.
    double memory = 6;
    /// Rate at which a velocity decays, 1/s.
    double friction = 0.3;
    /// Standard deviation of accelerations by kicks and by errors of dead reckoning, m/s^2.
    double acceleration = 0.6;
    /// Standard deviation of a percept, m, ...
    double deviationNear = 0.02;
    /// ...plus this for each meter of distance.
    double deviationPerMeter = 0.06;
    /// Percepts farther away than this many standard deviations are outliers.
    double gate = 4;
    /// The number of agreeing outliers after which the filter starts again there.
    int outliersToRestart = 3;
  };
  explicit BallFilter(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame; the arguments are those of LastBall::update().
  void update(double time, const robotlink::Pose2& robotInOdometry,
              const std::optional<BallMeasurement>& seen);
  /// Same as LastBall::forget().
  void forget();
  BallEstimate estimate() const { return estimate_; }

 private:
  /// x, y, vx, vy in the odometry frame.
  using State = Eigen::Vector4d;
  /// Moves the state ahead in time.
  void predict(double seconds);
  /// Fuses a percept, or counts it as an outlier.
  void correct(const BallMeasurement& seen, const robotlink::Pose2& robotInOdometry, double time);
  /// Starts at a position with zero velocity.
  void restart(const robotlink::Vector2& position, double deviation);

  Options options_;
  BallEstimate estimate_;
  State state_ = State::Zero();
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Identity();
  std::optional<double> updatedAt_;
  std::optional<double> seenAt_;
  /// Consecutive outliers that agree.
  int outliers_ = 0;
  /// In the odometry frame.
  robotlink::Vector2 lastOutlier_ = robotlink::Vector2::Zero();
};

}  // namespace modules
