// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/modeling/PoseEstimate.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Random.h"

namespace modules {

/// A landmark at a known place of the field, as the robot sees it.
struct LandmarkMeasurement {
  robotlink::Vector2 position = robotlink::Vector2::Zero();  ///< in the field, m
  double bearing = 0;                                        ///< rad, in the robot
  double distance = 0;                                       ///< m
  double confidence = 0;                                     ///< 0 to 1
  bool isGoal = false;                                       ///< large things have no exact place
};

/// Self-localisation by a particle filter (Monte Carlo localisation; Dellaert, Fox et al. 1999) over dead
/// reckoning and landmarks.
///
/// Images that follow each other share their errors, so each counts only in part; particles are drawn anew
/// only when few of them carry most of the weight. Otherwise the cloud would soon shrink to one point, a
/// wrong one as likely as not.
///
/// A particle's weight follows from bearings (good) and distances (poor) of landmarks; where they fit badly
/// for a while, particles are drawn anew from what the landmarks say, so that a robot that was carried off
/// finds itself again. Deterministic: a seed and the calls decide everything.
class LandmarkLocalizer {
 public:
  struct Options {
    int particles = 200;
    double fieldLength = 4.2, fieldWidth = 2.7;  ///< m
    double bearingDeviation = 0.04;              ///< rad
    double distanceDeviation = 0.12;             ///< share of the distance
    double walkNoise = 0.1;                      ///< m after one metre, growing with the root of the way
    double turnNoise = 0.15;                     ///< rad after one radian, likewise
    double driftNoise = 0.002;                   ///< m and rad an update
    double evidence = 0.3;     ///< share of an image's news that the image before did not tell already
    double roughening = 0.02;  ///< m and rad, of particles that are doubled
    double newShare = 0.1;     ///< of particles drawn anew where the rest fits badly
    std::uint64_t seed = 1;
  };
  LandmarkLocalizer(const Options& options, const robotlink::Pose2& start, double startDeviation);
  /// From now on; the number of particles and the seed stay.
  void setOptions(const Options& options) { options_ = options; }

  /// `robotInOdometry`: dead reckoning since any start. `shaken`: the robot does what dead reckoning knows
  /// little of, it kicks or gets up.
  void update(const robotlink::Pose2& robotInOdometry, bool shaken,
              std::span<const LandmarkMeasurement> seen);
  const PoseEstimate& estimate() const { return estimate_; }
  std::vector<robotlink::Pose2> particles() const;

 private:
  struct Particle {
    robotlink::Pose2 pose;
    double weight = 1;
  };
  void move(const robotlink::Pose2& step, bool shaken);
  void weigh(std::span<const LandmarkMeasurement> seen);
  void resample(std::span<const LandmarkMeasurement> seen);
  /// A pose from which one of the landmarks looks as it was seen.
  robotlink::Pose2 drawFrom(const LandmarkMeasurement& seen);
  void keepOnField(robotlink::Pose2& pose) const;
  double effectiveParticles() const;
  void summarize();

  Options options_;
  robotlink::Random random_;
  std::vector<Particle> particles_;
  std::vector<Particle> drawn_;
  robotlink::Pose2 odometry_;
  bool hasOdometry_ = false;
  double fit_ = 1;  ///< how well particles fitted lately, 0 to 1
  PoseEstimate estimate_;
};

}  // namespace modules
