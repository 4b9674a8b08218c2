// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "modules/modeling/PoseEstimate.h"

namespace modules {

/// A hypothetical pose of the robot. In single precision, because thousands are processed ten times a second.
struct Particle {
  // m and rad, in the map.
  float x = 0, y = 0, heading = 0;
  // Logarithm of the weight; only differences matter.
  float logWeight = 0;

  robotlink::Pose2 pose() const { return {x, y, heading}; }
  static Particle at(const robotlink::Pose2& pose) {
    return {static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.heading), 0};
  }
};

/// Sums over the weights of all particles.
struct WeightSums {
  /// The logarithm of the largest weight.
  double best = 0;
  /// Sums over the weights, relative to the largest one.
  double sum = 0, squares = 0;
  /// The number of particles of equal weight that would be as informative.
  double effective() const { return sum * sum / squares; }
};
/// There must be at least one particle.
WeightSums weightSums(std::span<const Particle> particles);

/// The center of the heaviest cluster, and the deviation of all particles from it; without particles, a
/// deviation of a kilometer.
PoseEstimate summarize(std::span<const Particle> particles);

/// The number of particles that a cloud as wide as this one needs to approximate its distribution (Fox,
/// Adapting the sample size in particle filters through KLD-sampling, 2003).
double neededParticles(std::span<const Particle> cloud);

}  // namespace modules
