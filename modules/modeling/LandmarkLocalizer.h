// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/modeling/Particles.h"
#include "modules/modeling/PoseEstimate.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Random.h"

namespace modules {

/// A landmark at a known position of the field, as seen by the robot.
struct LandmarkMeasurement {
  /// In the field, m.
  robotlink::Vector2 position = robotlink::Vector2::Zero();
  /// From the robot's x-axis, rad.
  double bearing = 0;
  /// Meters.
  double distance = 0;
  /// From 0 to 1.
  double confidence = 0;
  /// Large objects have no exact position, so their measurements count less.
  bool isGoal = false;
};

/// Self-localization by a particle filter (Monte Carlo localization; Dellaert, Fox et al. 1999) with dead
/// reckoning and landmarks.
///
/// Consecutive images share their errors, so each one counts only in part; particles are resampled only when
/// few of them carry most of the weight. Otherwise the cloud would soon collapse to one point, possibly a
/// wrong one.
///
/// The weight of a particle follows from bearings (accurate) and distances (inaccurate) of landmarks. If they
/// have fitted badly for a while, some particles are replaced by poses computed from landmarks, so that a
/// robot that was carried away recovers. Deterministic for a seed. Not thread-safe.
class LandmarkLocalizer {
 public:
  struct Options {
    int particles = 200;
    /// Meters.
    double fieldLength = 4.2, fieldWidth = 2.7;
    /// Radians.
    double bearingDeviation = 0.04;
    /// The standard deviation as a fraction of the distance.
    double distanceDeviation = 0.12;
    /// Error after walking one meter, m; grows with the square root of the distance.
    double walkNoise = 0.1;
    /// Error after turning one radian, rad; grows likewise.
    double turnNoise = 0.15;
    /// Added in every update, m and rad.
    double driftNoise = 0.002;
    /// The fraction of an image's information that the previous image did not contain.
    double evidence = 0.3;
    /// Noise added to duplicated particles, m and rad.
    double roughening = 0.02;
    /// The fraction of particles that are replaced when the others fit badly.
    double newShare = 0.1;
    std::uint64_t seed = 1;
  };
  /// Starts with a normal distribution around a pose; `startDeviation` in m.
  LandmarkLocalizer(const Options& options, const robotlink::Pose2& start, double startDeviation);
  /// Takes effect with the next update(), except for the number of particles and the seed.
  void setOptions(const Options& options) { options_ = options; }

  /// Call it once an image. `robotInOdometry` is the pose by dead reckoning with any origin. `shaken` means
  /// that dead reckoning is unreliable because the robot kicks or gets up.
  void update(const robotlink::Pose2& robotInOdometry, bool shaken,
              std::span<const LandmarkMeasurement> seen);
  const PoseEstimate& estimate() const { return estimate_; }
  /// The poses of all particles; for drawings.
  std::vector<robotlink::Pose2> particles() const { return posesOf(particles_); }

 private:
  struct Particle {
    robotlink::Pose2 pose;
    /// Relative; not normalized.
    double weight = 1;
  };
  /// Applies a step of the odometry, with noise.
  void move(const robotlink::Pose2& step, bool shaken);
  /// Multiplies the weights by the likelihood of what was seen.
  void weigh(std::span<const LandmarkMeasurement> seen);
  /// Draws a new generation of particles by their weights.
  void resample(std::span<const LandmarkMeasurement> seen);
  /// A random pose from which a landmark looks as it was seen.
  robotlink::Pose2 drawFrom(const LandmarkMeasurement& seen);
  /// Clamps a pose to the field and its borders.
  void keepOnField(robotlink::Pose2& pose) const;
  /// Computes the estimate from the particles.
  void summarize();

  Options options_;
  robotlink::Random random_;
  std::vector<Particle> particles_;
  /// The next generation, kept to reuse its memory.
  std::vector<Particle> drawn_;
  robotlink::Pose2 odometry_;
  bool hasOdometry_ = false;
  /// The recent fit of the particles, 0 to 1.
  double fit_ = 1;
  PoseEstimate estimate_;
};

}  // namespace modules
