// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/navigation/LikelihoodField.h"
#include "modules/navigation/Particle.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// How likely measured distances are at a pose in the map: rays by where they end (a likelihood field), cones
/// by how far the nearest wall in them is.
class RangeModel {
 public:
  struct Options {
    int rays = 40;                 ///< that are looked at, evenly spread over all
    double evidence = 0.12;        ///< share of a measurement's news that the others did not tell already
    double sonarDeviation = 0.15;  ///< m, plus a twentieth of the range
    double randomShare = 0.1;      ///< of measurements of what the map does not know
  };
  /// The map must outlive it.
  RangeModel(const DistanceMap& distances, const Options& options);
  void setOptions(const Options& options) { options_ = options; }
  /// m, of the ends of rays.
  void setRayDeviation(double deviation) { field_.setDeviation(deviation, options_.randomShare); }

  /// From now on the measurements to explain, in the robot's frame. Rays that hit nothing are left out.
  void choose(std::span<const RangeBeam> beams);
  bool empty() const { return rayEnds_.empty() && cones_.empty(); }

  double logLikelihood(const Particle& particle) const;
  /// Share of the measurements that the map explains from there, 0 to 1: unlike for the likelihood, a ray
  /// must not have gone through walls. Not if there are none.
  double explainedShare(const robotlink::Pose2& robotInMap) const;

 private:
  struct RayEnd {
    float x, y;  // in the robot's frame
  };
  bool explained(const robotlink::Pose2& robotInMap, const RangeBeam& ray) const;
  double expectedRange(const robotlink::Pose2& robotInMap, const RangeBeam& cone) const;

  const DistanceMap& distances_;
  Options options_;
  LikelihoodField field_;
  std::vector<RangeBeam> rays_;
  std::vector<RayEnd> rayEnds_;  // theirs, as the many particles need them
  std::vector<RangeBeam> cones_;
};

}  // namespace modules
