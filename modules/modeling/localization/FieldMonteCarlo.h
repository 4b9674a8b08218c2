// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "modules/modeling/Particles.h"
#include "modules/modeling/PoseEstimate.h"
#include "modules/modeling/localization/FieldEdgeMap.h"
#include "modules/modeling/localization/LandmarkMemory.h"
#include "modules/modeling/localization/LineMeasurement.h"
#include "robotlink/base/Random.h"

namespace modules {

/// Self-localization on a field by a particle filter over dead reckoning, landmarks and points of lines
/// (Monte Carlo localization; Fox, Burgard, Dellaert, Thrun 1999), as Röfer and Jüngel (2003) had it on the
/// ERS-210.
///
/// Where the particles fit badly to what is seen, some are replaced by poses that follow from the landmarks
/// that were seen lately (sensor resetting; Lenser, Veloso 2000), so that a robot that was carried away finds
/// itself again; half of them only turn, since other robots turn one that pushes them. The estimate is the
/// mean of the densest cluster and not of all particles, which may lie between two clusters. Deterministic
/// for a seed. Not thread-safe.
class FieldMonteCarlo {
 public:
  struct Options {
    int particles = 150;
    /// The deviation of a landmark's bearing, rad.
    double bearingDeviation = 0.05;
    /// The deviation of a landmark's distance, as a fraction of it.
    double distanceDeviation = 0.1;
    /// The deviation of the place of a line's point, m, plus a fraction of its distance.
    double lineDeviation = 0.03, lineDeviationPerMeter = 0.08;
    /// The number of an image's points of lines that are used; 0: none.
    int linePoints = 12;
    /// The fraction of an image's information that the previous image did not contain: of landmarks, and of
    /// each point of a line.
    double landmarkEvidence = 0.25, lineEvidence = 0.03;
    /// Error after walking one meter, m; grows with the square root of the distance.
    double walkNoise = 0.12;
    /// Error after turning one radian, rad; grows likewise.
    double turnNoise = 0.15;
    /// Added in every update, m and rad.
    double driftNoise = 0.002;
    /// Noise added to duplicated particles, m and rad.
    double roughening = 0.01;
    /// Mean fit of the landmarks, 0 to 1, below which particles are replaced.
    double goodFit = 0.45;
    /// The fraction of particles that are replaced if nothing fits; and in every image.
    double newShare = 0.2, probeShare = 0.01;
    /// The time for which landmarks are remembered for new particles, s.
    double memory = 4;
    std::uint64_t seed = 1;
  };
  /// Starts anywhere on the field.
  FieldMonteCarlo(const robotlink::FieldDescription& field, const Options& options);
  /// Restarts with a normal distribution around a pose; `deviation` in m and rad.
  void startAt(const robotlink::Pose2& pose, double deviation);
  /// Takes effect with the next update(), except for the number of particles and the seed.
  void setOptions(const Options& options) { options_ = options; }

  /// The contents of an image, and what else is known at its time.
  struct Frame {
    /// The time on any clock, s.
    double time = 0;
    /// The pose by dead reckoning with any origin.
    robotlink::Pose2 robotInOdometry;
    /// Dead reckoning is unreliable because the robot kicks, gets up, or pushes something.
    bool shaken = false;
    /// The robot was picked up, and may be put down anywhere.
    bool carried = false;
    std::span<const LandmarkMeasurement> landmarks = {};
    std::span<const LineMeasurement> lines = {};
  };
  /// Call it once an image.
  void update(const Frame& frame);

  const PoseEstimate& estimate() const { return estimate_; }
  /// The recent fit of the particles to the landmarks, 0 to 1.
  double fit() const { return fit_; }
  /// The poses of all particles; for drawings.
  std::vector<robotlink::Pose2> particles() const { return posesOf(particles_); }
  const FieldEdgeMap& edges() const { return edges_; }

 private:
  struct Particle {
    robotlink::Pose2 pose;
    /// The cosine and the sine of the heading.
    double cosine = 1, sine = 0;
    /// Relative; not normalized.
    double weight = 1;
  };
  /// A landmark as it is compared with many particles: the direction in which it was seen as a unit vector,
  /// and the deviations of direction (rad) and distance (m).
  struct Sight {
    robotlink::Vector2 position, direction;
    double distance, directionDeviation, distanceDeviation;
  };
  /// A point of a line as it is compared with many particles, m and rad in the robot's frame, and 1 over its
  /// deviation, 1/m.
  struct LinePoint {
    robotlink::Vector2 inRobot;
    double direction, perDeviation;
  };
  /// A block of 2 x 2 x 2 cells of x, y and heading; their numbers in the order of these.
  struct Block {
    int x = 0, y = 0, heading = 0;
    bool contains(const Block& cell) const;
  };
  Block cellOf(const robotlink::Pose2& pose) const;
  /// The block of cells with the highest sum of weights, or that of the last estimate if it is nearly as
  /// dense.
  Block densestBlock();
  void set(Particle& particle, const robotlink::Pose2& pose) const;
  void move(const robotlink::Pose2& step, bool shaken);
  /// Squared deviations of a particle from the landmarks, each bounded.
  double landmarkSquares(const Particle& particle) const;
  double lineSquares(const Particle& particle) const;
  void weigh(const Frame& frame);
  void choose(const Frame& frame);
  /// Draws a new generation of particles by their weights. Particles that follow from landmarks are added
  /// only if the image shows one: lines alone would let mirrored poses win.
  void resample(const Frame& frame);
  /// A pose from two landmarks of the memory, or around one; any pose if there is none.
  robotlink::Pose2 drawPose(const robotlink::Pose2& robotInOdometry);
  robotlink::Pose2 anyPose();
  /// The same place, turned so that a landmark is where the image shows it; it shows one at least.
  robotlink::Pose2 turned(const robotlink::Pose2& pose, const Frame& frame);
  /// The estimate is that of the densest cluster.
  void summarize();
  /// A number that is distributed nearly normally, much faster than Random::normal().
  double noise();

  Options options_;
  robotlink::Random random_;
  FieldEdgeMap edges_;
  /// Half of the field's surface, m.
  double halfLength_, halfWidth_;
  LandmarkMemory memory_;
  std::vector<Particle> particles_;
  /// The next generation, kept to reuse its memory.
  std::vector<Particle> drawn_;
  /// The observations with which the particles are compared.
  std::vector<Sight> sights_;
  std::vector<LinePoint> points_;
  /// Weights of cells of poses, for summarize().
  std::vector<double> cells_;
  robotlink::Pose2 odometry_;
  bool hasOdometry_ = false, hasEstimate_ = false;
  double fit_ = 0;
  PoseEstimate estimate_;
};

}  // namespace modules
