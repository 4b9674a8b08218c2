// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "robotlink/base/Geometry.h"

namespace modules {

/// Where the ball is believed to be. Robot frame, metres.
struct BallEstimate {
  bool known = false;
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  robotlink::Vector2 velocity = robotlink::Vector2::Zero();  ///< m/s, over ground
  double secondsSinceSeen = 0;
  double deviation = 0;  ///< m, standard deviation
};

/// What one image says of the ball.
struct BallMeasurement {
  robotlink::Vector2 position = robotlink::Vector2::Zero();  ///< robot frame, m
  double confidence = 0;
};

/// Remembers the last percept: the ball stays where it was seen, while the robot moves.
class LastBall {
 public:
  struct Options {
    double memory = 4;  ///< s that a percept is of use
  };
  explicit LastBall(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `time` in seconds of any clock; `robotInOdometry` by dead reckoning.
  void update(double time, const robotlink::Pose2& robotInOdometry,
              const std::optional<BallMeasurement>& seen);
  BallEstimate estimate() const { return estimate_; }

 private:
  Options options_;
  BallEstimate estimate_;
  robotlink::Vector2 inOdometry_ = robotlink::Vector2::Zero();
  std::optional<double> seenAt_;
};

/// A Kalman filter over place and velocity of the ball in the frame of dead reckoning, where a ball at rest
/// stays where it is although the robot walks. Rolling balls slow down; percepts that do not fit are ignored
/// until several agree with each other.
class BallFilter {
 public:
  struct Options {
    double memory = 6;                ///< s
    double friction = 0.3;            ///< 1/s: how fast a velocity dies away
    double acceleration = 0.6;        ///< m/s^2, of kicks and dead reckoning that slips
    double deviationNear = 0.02;      ///< m, of a percept, plus ...
    double deviationPerMetre = 0.06;  ///< ... this for each metre of distance
    double gate = 4;                  ///< standard deviations
    int outliersToRestart = 3;
  };
  explicit BallFilter(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  void update(double time, const robotlink::Pose2& robotInOdometry,
              const std::optional<BallMeasurement>& seen);
  BallEstimate estimate() const { return estimate_; }

 private:
  using State = Eigen::Vector4d;  // x, y, vx, vy
  void predict(double seconds);
  void correct(const BallMeasurement& seen, const robotlink::Pose2& robotInOdometry, double time);
  void restart(const robotlink::Vector2& position, double deviation);

  Options options_;
  BallEstimate estimate_;
  State state_ = State::Zero();
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Identity();
  std::optional<double> updatedAt_;
  std::optional<double> seenAt_;
  int outliers_ = 0;
  robotlink::Vector2 lastOutlier_ = robotlink::Vector2::Zero();
};

}  // namespace modules
