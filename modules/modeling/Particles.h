// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "robotlink/base/Geometry.h"

// Functions that the particle filters over poses share; a particle has a `pose` and a `weight`.
namespace modules {

/// The number of particles of equal weight that would be as informative; 0 if no particle has a weight.
template <typename Particle>
double effectiveParticles(const std::vector<Particle>& particles) {
  double sum = 0, squares = 0;
  for (const Particle& particle : particles) {
    sum += particle.weight;
    squares += particle.weight * particle.weight;
  }
  return squares > 0 ? sum * sum / squares : 0;
}

/// The poses of all particles; for drawings.
template <typename Particle>
std::vector<robotlink::Pose2> posesOf(const std::vector<Particle>& particles) {
  std::vector<robotlink::Pose2> poses;
  for (const Particle& particle : particles) poses.push_back(particle.pose);
  return poses;
}

}  // namespace modules
