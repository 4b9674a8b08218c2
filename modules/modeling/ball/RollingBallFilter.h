// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "modules/RollingBall.h"
#include "modules/modeling/BallFilter.h"
#include "modules/modeling/ball/BallMeasuring.h"

namespace modules {

/// Two Kalman filters over place and velocity of the ball in the frame of dead reckoning, one for a ball that
/// rests and one for a ball that rolls and slows down, which are mixed by how well each explains the percepts
/// (interacting multiple models; Blom, Bar-Shalom 1988). A resting ball is therefore held still in spite of
/// noise, and a kicked one is followed within a few images.
///
/// Percepts have the errors of BallAccuracy. Those that fit neither filter are ignored until several agree
/// with each other. Not thread-safe.
class RollingBallFilter {
 public:
  struct Options {
    /// The time for which the ball is known without percepts, s.
    double memory = 6;
    RollingBall roll;
    /// Standard deviation of the accelerations of a rolling ball, m/s^2.
    double acceleration = 2;
    /// The drift of a resting ball by dead reckoning, m after one second, growing with the root of time.
    double drift = 0.1;
    /// How often a ball begins to roll and stops, 1/s.
    double startRate = 0.5, stopRate = 0.5;
    BallAccuracy accuracy;
    /// Percepts farther away than this many standard deviations are outliers.
    double gate = 4;
    /// The number of agreeing outliers after which the filter starts again there.
    int outliersToRestart = 3;
  };
  explicit RollingBallFilter(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame; the arguments are those of LastBall::update().
  void update(double time, const robotlink::Pose2& robotInOdometry,
              const std::optional<BallMeasurement>& seen);
  /// Same as LastBall::forget().
  void forget();
  BallEstimate estimate() const { return estimate_; }
  /// The probability that the ball rolls, 0 to 1.
  double rolling() const { return models_[kRoll].probability; }

 private:
  enum { kRest, kRoll };
  /// A filter: x, y, vx, vy in the odometry frame, and how probable its model is.
  struct Model {
    Eigen::Vector4d state = Eigen::Vector4d::Zero();
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
    double probability = 0.5;
  };
  void restart(const robotlink::Vector2& position, const Eigen::Matrix2d& covariance);
  /// Lets each model begin with what the other one found out, as far as it may have been in that.
  void mix(double seconds);
  void rest(Model& model, double seconds) const;
  void roll(Model& model, double seconds) const;
  /// Corrects a model, and returns the likelihood of the percept.
  static double correct(Model& model, const robotlink::Vector2& measured, const Eigen::Matrix2d& covariance);
  /// The squared distance of a percept from a model in standard deviations.
  static double squaredDistance(const Model& model, const robotlink::Vector2& measured,
                                const Eigen::Matrix2d& covariance);
  void see(const BallMeasurement& seen, const robotlink::Pose2& robotInOdometry, double time);
  /// The mean of both models.
  Model combined() const;

  Options options_;
  BallEstimate estimate_;
  std::array<Model, 2> models_;
  std::optional<double> updatedAt_;
  std::optional<double> seenAt_;
  /// Consecutive outliers that agree.
  int outliers_ = 0;
  /// In the odometry frame.
  robotlink::Vector2 lastOutlier_ = robotlink::Vector2::Zero();
};

}  // namespace modules
