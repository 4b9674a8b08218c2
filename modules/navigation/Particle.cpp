// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/Particle.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Pose2;

namespace {

// Poses in the same bin count as the same possibility; m and rad.
constexpr double kBinSide = 0.25, kBinAngle = robotlink::radians(15);
// Bins for finding the heaviest cluster, and the extent of a cluster from its center.
constexpr double kClusterSide = 1.0, kClusterAngle = robotlink::radians(45);
constexpr double kClusterReach = 1.0, kClusterTurn = 0.6;
// KLD sampling: an error of at most 0.05 in 99 of 100 cases.
constexpr double kKldError = 0.05, kKldQuantile = 2.33;

std::uint64_t binOf(const Particle& particle, double side, double angle) {
  const auto x = static_cast<std::int64_t>(std::floor(particle.x / side));
  const auto y = static_cast<std::int64_t>(std::floor(particle.y / side));
  const auto turn = static_cast<std::int64_t>(std::floor(particle.heading / angle));
  return static_cast<std::uint64_t>(((x & 0xFFFFFF) << 32) | ((y & 0xFFFFFF) << 8) | (turn & 0xFF));
}

double weightOf(const Particle& particle, double best) {
  return std::exp(particle.logWeight - best);
}

/// A particle of the heaviest bin.
Pose2 heaviestPlace(std::span<const Particle> particles, double best) {
  std::unordered_map<std::uint64_t, double> bins;
  const Particle* heaviest = &particles.front();
  double most = 0;
  for (const Particle& particle : particles) {
    double& weight = bins[binOf(particle, kClusterSide, kClusterAngle)];
    weight += weightOf(particle, best);
    if (weight <= most) continue;
    most = weight;
    heaviest = &particle;
  }
  return heaviest->pose();
}

/// The weighted mean of the particles near a place; the place itself if there are none.
Pose2 middleAbout(const Pose2& place, std::span<const Particle> particles, double best) {
  double sum = 0, x = 0, y = 0, turn = 0;
  for (const Particle& particle : particles) {
    const double away = normalizedAngle(particle.heading - place.heading);
    if (std::hypot(particle.x - place.x, particle.y - place.y) > kClusterReach ||
        std::abs(away) > kClusterTurn)
      continue;
    const double weight = weightOf(particle, best);
    sum += weight;
    x += weight * particle.x;
    y += weight * particle.y;
    turn += weight * away;
  }
  if (sum <= 0) return place;
  return {x / sum, y / sum, normalizedAngle(place.heading + turn / sum)};
}

}  // namespace

WeightSums weightSums(std::span<const Particle> particles) {
  WeightSums sums;
  sums.best = std::ranges::max(particles, {}, &Particle::logWeight).logWeight;
  for (const Particle& particle : particles) {
    const double weight = weightOf(particle, sums.best);
    sums.sum += weight;
    sums.squares += weight * weight;
  }
  return sums;
}

PoseEstimate summarize(std::span<const Particle> particles) {
  if (particles.empty()) return {{}, 1e3, robotlink::kPi};
  const WeightSums sums = weightSums(particles);
  PoseEstimate estimate{heaviestPlace(particles, sums.best), 0, 0};
  for (int pass = 0; pass < 3; ++pass)
    estimate.robotInField = middleAbout(estimate.robotInField, particles, sums.best);
  double places = 0, turns = 0;
  for (const Particle& particle : particles) {
    const double weight = weightOf(particle, sums.best);
    const double x = particle.x - estimate.robotInField.x, y = particle.y - estimate.robotInField.y;
    const double turn = normalizedAngle(particle.heading - estimate.robotInField.heading);
    places += weight * (x * x + y * y);
    turns += weight * turn * turn;
  }
  estimate.positionDeviation = std::sqrt(0.5 * places / sums.sum);
  estimate.headingDeviation = std::sqrt(turns / sums.sum);
  return estimate;
}

double neededParticles(std::span<const Particle> cloud) {
  std::unordered_set<std::uint64_t> bins;
  for (const Particle& particle : cloud) bins.insert(binOf(particle, kBinSide, kBinAngle));
  const auto k = static_cast<double>(bins.size());
  if (k < 2) return 1;
  const double a = 2 / (9 * (k - 1)), root = 1 - a + std::sqrt(a) * kKldQuantile;
  return (k - 1) / (2 * kKldError) * root * root * root;
}

}  // namespace modules
