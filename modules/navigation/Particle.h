// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "modules/modeling/PoseEstimate.h"

namespace modules {

/// A possible pose of the robot. Single precision: thousands of them are gone through ten times a second.
struct Particle {
  float x = 0, y = 0, heading = 0;
  float logWeight = 0;

  robotlink::Pose2 pose() const { return {x, y, heading}; }
  static Particle at(const robotlink::Pose2& pose) {
    return {static_cast<float>(pose.x), static_cast<float>(pose.y), static_cast<float>(pose.heading), 0};
  }
};

struct WeightSums {
  double best = 0;              ///< logarithm of the largest weight
  double sum = 0, squares = 0;  ///< of the weights, the largest being 1
  double effective() const { return sum * sum / squares; }
};
/// The sums over at least one particle.
WeightSums weightSums(std::span<const Particle> particles);

/// The middle of the heaviest cluster, and the deviation of all particles about it; of none a deviation of a
/// kilometre.
PoseEstimate summarize(std::span<const Particle> particles);

/// How many particles a cloud as wide as this one needs, so that it is like the distribution it stands for
/// (Fox, Adapting the sample size in particle filters through KLD-sampling, 2003).
double neededParticles(std::span<const Particle> cloud);

}  // namespace modules
