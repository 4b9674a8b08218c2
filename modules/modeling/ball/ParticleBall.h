// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "modules/RollingBall.h"
#include "modules/modeling/BallFilter.h"
#include "modules/modeling/ball/BallMeasuring.h"
#include "robotlink/base/Random.h"

namespace modules {

/// A particle filter over place and velocity of the ball in the frame of dead reckoning (Kwok, Fox: Map-based
/// multiple model tracking of a moving object, RoboCup 2004). Each particle rests or rolls, and begins to
/// roll or stops at random; so the ball may be in two places until the next percepts decide.
///
/// With each percept some particles are redrawn at its place, so that a ball that was moved is found again
/// without a threshold. The estimate is the mean of the particles near the heaviest place. Deterministic for
/// a seed. Not thread-safe.
class ParticleBall {
 public:
  struct Options {
    int particles = 80;
    /// The time for which the ball is known without percepts, s.
    double memory = 6;
    RollingBall roll;
    /// How often a ball begins to roll and stops, 1/s.
    double startRate = 0.5, stopRate = 0.5;
    /// Standard deviation of the velocity of a ball that begins to roll, m/s.
    double startSpeed = 0.6;
    /// The change of velocities, m/s after one second, growing with the root of time.
    double velocityNoise = 0.4;
    /// The distance by which dead reckoning moves a ball, m after one second, growing with the root of time.
    double drift = 0.12;
    BallAccuracy accuracy;
    /// The fraction of particles that are drawn at a percept.
    double newShare = 0.06;
    /// The fraction of a percept's information that the percept before did not contain.
    double evidence = 0.7;
    std::uint64_t seed = 1;
  };
  struct Particle {
    /// In the odometry frame, m and m/s.
    robotlink::Vector2 position = robotlink::Vector2::Zero();
    robotlink::Vector2 velocity = robotlink::Vector2::Zero();
    double weight = 1;
  };

  explicit ParticleBall(const Options& options) : options_(options), random_(options.seed) {}
  /// Takes effect with the next update(), except for the seed.
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once a frame; the arguments are those of LastBall::update().
  void update(double time, const robotlink::Pose2& robotInOdometry,
              const std::optional<BallMeasurement>& seen);
  /// Same as LastBall::forget().
  void forget();
  BallEstimate estimate() const { return estimate_; }
  /// Empty before the first percept.
  const std::vector<Particle>& particles() const { return particles_; }

 private:
  void move(double seconds);
  void see(const BallMeasurement& seen, const robotlink::Pose2& robotInOdometry);
  Particle drawAt(const robotlink::Vector2& place, const Eigen::Matrix2d& root);
  void resample(const robotlink::Vector2& place, const Eigen::Matrix2d& covariance);
  /// Remembers a percept of the last moments, from which the velocity of a kicked ball follows.
  void remember(double time, const robotlink::Vector2& place);
  void summarize(const robotlink::Pose2& robotInOdometry);

  Options options_;
  robotlink::Random random_;
  BallEstimate estimate_;
  std::vector<Particle> particles_, drawn_;
  std::optional<double> updatedAt_, seenAt_;
  /// A percept's place in the odometry frame, m, and its time, s.
  struct Seen {
    double time = 0;
    robotlink::Vector2 place = robotlink::Vector2::Zero();
  };
  /// The percepts of the last moments, the newest last.
  std::deque<Seen> recent_;
};

}  // namespace modules
