// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/navigation/Particle.h"
#include "modules/navigation/RangeModel.h"
#include "modules/navigation/ReachableSpace.h"
#include "robotlink/base/Random.h"

namespace modules {

/// Self-localization in a map of walls by a particle filter with dead reckoning and measured distances (Monte
/// Carlo localization; Dellaert, Fox et al. 1999). The number of particles adapts to their spread.
///
/// It starts anywhere: particles are spread evenly over the map's free space. While they are far apart, rays
/// are trusted only roughly, so that a particle near the true pose counts although it does not match exactly.
/// Consecutive measurements share their errors, so each one counts only in part, and only after the robot has
/// moved. If measurements fit badly, some particles are replaced by the best of many random poses; if they do
/// so for long, the robot was carried away, and the localization starts again.
///
/// The estimate is the center of the heaviest cluster. Its deviation is that of all particles from it, so it
/// is large while there is more than one possibility, and even larger while the measurements fit badly.
/// Deterministic for a seed. One thread at a time.
class MonteCarloLocalizer {
 public:
  struct Options {
    /// Per m^2 of free space, at the start.
    double particlesPerArea = 120;
    // Limits of the number of particles.
    int fewest = 1200, most = 40000;
    /// The distance of the robot's center from walls, m.
    double clearance = 0.25;
    RangeModel::Options ranges;
    /// Deviation of the ends of rays when the pose is known, m.
    double rayDeviation = 0.08;
    /// The same while it is unknown, m.
    double startDeviation = 0.35;
    double wayNoise = 0.08;    ///< m after one meter
    double skidNoise = 0.05;   ///< m after one radian
    double turnNoise = 0.1;    ///< rad after one radian
    double driftNoise = 0.04;  ///< rad after one meter
    /// The motion between evaluated measurements, m and rad.
    double leastWay = 0.05, leastTurn = 0.05;
    /// The fraction of measurements that are explained at the true pose.
    double goodFit = 0.8;
    /// The fraction of particles that are replaced if nothing is explained.
    double newShare = 0.1;
    /// The number of measurements that fit badly before it starts again.
    int lostAfter = 40;
    std::uint64_t seed = 1;
  };
  /// The map need not outlive it. In a map without free space the estimate stays completely uncertain.
  MonteCarloLocalizer(const robotlink::GroundMap& map, const Options& options);
  MonteCarloLocalizer(const MonteCarloLocalizer&) = delete;
  MonteCarloLocalizer& operator=(const MonteCarloLocalizer&) = delete;
  /// Takes effect from now on, except for the particles, the free space, and the seed.
  void setOptions(const Options& options);

  /// Spreads particles everywhere, with any heading.
  void startAnywhere();
  /// Spreads particles around a pose; deviations in m and rad.
  void startAt(const robotlink::Pose2& robotInMap, double positionDeviation, double headingDeviation);
  /// Applies the motion since the last call, in the robot's frame.
  void move(const robotlink::Pose2& step);
  /// Processes measurements at the robot's present pose. Returns false if they were ignored, because the
  /// robot has hardly moved or none of them can be compared with the map.
  bool see(std::span<const RangeBeam> beams);

  const PoseEstimate& estimate() const { return estimate_; }
  /// The fraction of recent measurements that the estimate explains, 0 to 1.
  double fit() const { return fit_; }
  std::span<const Particle> particles() const { return particles_; }
  const ReachableSpace& freeSpace() const { return freeSpace_; }

 private:
  /// Updates fit() and detects a robot that was carried away.
  void judge();
  /// Multiplies the weights by the likelihood of the measurements.
  void weigh();
  /// Draws a new generation of particles, as many as are needed.
  void resample();
  /// Draws `count` particles by their weights.
  void draw(std::size_t count);
  /// Replaces some particles by the best of random poses.
  void drawAnew();
  /// Computes the estimate from the particles.
  void publish();

  Options options_;
  robotlink::Random random_;
  DistanceMap distances_;
  ReachableSpace freeSpace_;
  RangeModel ranges_;
  /// drawn_ is the next generation, kept to reuse its memory.
  std::vector<Particle> particles_, drawn_;
  /// The motion since the last evaluated measurement, m and rad.
  double way_ = 0, turn_ = 0;
  /// Whether no measurement has been evaluated yet.
  bool first_ = true;
  double fit_ = 0;
  /// Consecutive measurements that fit badly.
  int badFits_ = 0;
  PoseEstimate estimate_;
};

}  // namespace modules
