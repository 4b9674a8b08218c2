// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/navigation/LikelihoodField.h"
#include "modules/navigation/Particle.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// The likelihood of measured distances at a pose in the map: rays by their ends (a likelihood field), cones
/// by the distance to the nearest wall in them. Not thread-safe.
class RangeModel {
 public:
  struct Options {
    /// The number of rays that are used, evenly spread.
    int rays = 40;
    /// The fraction of a measurement's information that the others do not contain.
    double evidence = 0.12;
    double sonarDeviation = 0.15;  ///< m, plus a twentieth of the range
    /// The fraction of measurements of things unknown to the map.
    double randomShare = 0.1;
  };
  /// `distances` must outlive it.
  RangeModel(const DistanceMap& distances, const Options& options);
  void setOptions(const Options& options) { options_ = options; }
  /// Sets the deviation of the ends of rays, m.
  void setRayDeviation(double deviation) { field_.setDeviation(deviation, options_.randomShare); }

  /// Selects the measurements to explain, in the robot's frame. Rays that hit nothing are ignored.
  void choose(std::span<const RangeBeam> beams);
  /// Whether there are no measurements to explain.
  bool empty() const { return rayEnds_.empty() && cones_.empty(); }

  /// The sum over the selected measurements, weighted by `evidence`.
  double logLikelihood(const Particle& particle) const;
  /// The fraction of the measurements that the map explains from a pose, 0 to 1. Unlike for the likelihood,
  /// rays must not pass through walls. There must be measurements.
  double explainedShare(const robotlink::Pose2& robotInMap) const;

 private:
  struct RayEnd {
    /// In the robot's frame.
    float x, y;
  };
  /// Whether a ray ends at a wall and passes through none.
  bool explained(const robotlink::Pose2& robotInMap, const RangeBeam& ray) const;
  /// The reading of a cone according to the map, m.
  double expectedRange(const robotlink::Pose2& robotInMap, const RangeBeam& cone) const;

  const DistanceMap& distances_;
  Options options_;
  LikelihoodField field_;
  std::vector<RangeBeam> rays_;
  /// The ends of rays_, for fast access.
  std::vector<RayEnd> rayEnds_;
  std::vector<RangeBeam> cones_;
};

}  // namespace modules
