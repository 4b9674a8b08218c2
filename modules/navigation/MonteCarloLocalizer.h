// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/navigation/FreeSpace.h"
#include "modules/navigation/Particle.h"
#include "modules/navigation/RangeModel.h"
#include "robotlink/base/Random.h"

namespace modules {

/// Self-localisation in a map of walls by a particle filter over dead reckoning and measured distances (Monte
/// Carlo localisation; Dellaert, Fox et al. 1999), with as many particles as their spread needs.
///
/// It begins anywhere: particles are spread evenly over the map's free space. As long as they are far apart,
/// rays are believed only roughly, so that a particle near the true pose counts although it does not hit it.
/// Measurements that follow each other share their errors, so each counts only in part, and only after the
/// robot has moved. Where measurements fit badly, some particles are drawn anew at the best of many places;
/// where they do so for long, the robot was carried off, and everything begins anew.
///
/// The estimate is the middle of the heaviest cluster; its deviation is that of all particles about it, so
/// that it is large while there is more than one possibility, and larger still while the measurements fit
/// badly. Deterministic: the seed and the calls decide everything. One thread at a time.
class MonteCarloLocalizer {
 public:
  struct Options {
    double particlesPerArea = 120;  ///< 1/m^2 of free space, at the start
    int fewest = 1200, most = 40000;
    double clearance = 0.25;  ///< m, of the robot's middle from walls
    RangeModel::Options ranges;
    double rayDeviation = 0.08;                ///< m, of the ends of rays once the pose is known ...
    double startDeviation = 0.35;              ///< m, ... and while it is not
    double wayNoise = 0.08;                    ///< m after a metre
    double skidNoise = 0.05;                   ///< m after a radian
    double turnNoise = 0.1;                    ///< rad after a radian
    double driftNoise = 0.04;                  ///< rad after a metre
    double leastWay = 0.05, leastTurn = 0.05;  ///< m and rad between measurements that are looked at
    double goodFit = 0.8;   ///< share of measurements that are explained where the pose is right
    double newShare = 0.1;  ///< of particles drawn anew where none is explained
    int lostAfter = 40;     ///< measurements with far less than a good fit until everything begins anew
    std::uint64_t seed = 1;
  };
  /// The map need not outlive it. In one without free space the estimate stays as uncertain as can be.
  MonteCarloLocalizer(const robotlink::GroundMap& map, const Options& options);
  MonteCarloLocalizer(const MonteCarloLocalizer&) = delete;
  MonteCarloLocalizer& operator=(const MonteCarloLocalizer&) = delete;
  /// From now on; the particles, what is free, and the seed stay.
  void setOptions(const Options& options);

  /// Everywhere with any heading.
  void startAnywhere();
  void startAt(const robotlink::Pose2& robotInMap, double positionDeviation, double headingDeviation);
  /// `step`: in the robot's frame, since the last call.
  void move(const robotlink::Pose2& step);
  /// What was measured where the robot is now. Returns false if that was no news: it has hardly moved.
  bool see(std::span<const RangeBeam> beams);

  const PoseEstimate& estimate() const { return estimate_; }
  /// Share of the measurements that the estimate explains, lately; 0 to 1.
  double fit() const { return fit_; }
  std::span<const Particle> particles() const { return particles_; }
  const FreeSpace& freeSpace() const { return freeSpace_; }

 private:
  void judge();
  void weigh();
  void resample();
  void draw(std::size_t count);
  void drawAnew();
  void tell();

  Options options_;
  robotlink::Random random_;
  DistanceMap distances_;
  FreeSpace freeSpace_;
  RangeModel ranges_;
  std::vector<Particle> particles_, drawn_;
  double way_ = 0, turn_ = 0;  // since the last measurement that was looked at
  bool first_ = true;          // none was looked at yet
  double fit_ = 0;
  int badFits_ = 0;
  PoseEstimate estimate_;
};

}  // namespace modules
