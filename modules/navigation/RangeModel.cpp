// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/RangeModel.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Pose2;
using robotlink::Vector2;

namespace {

// Conditions for a measurement to be explained, m: how far from a wall a ray may end, how far before its end
// it must not hit one, and how far the range of a cone may differ from the map.
constexpr double kNearWall = 0.15, kThroughWall = 0.3, kExplained = 0.25;
// Cones are slow to evaluate, and a message seldom contains more of them.
constexpr std::size_t kMaxCones = 16;
// An oblique wall may reflect the echo away, so a missing echo says little.
constexpr double kSwallowed = 0.3;

}  // namespace

RangeModel::RangeModel(const DistanceMap& distances, const Options& options)
    : distances_(distances), options_(options), field_(distances) {}

void RangeModel::choose(std::span<const RangeBeam> beams) {
  rays_.clear();
  rayEnds_.clear();
  cones_.clear();
  std::vector<const RangeBeam*> rays;
  for (const RangeBeam& beam : beams) {
    if (beam.openingAngle > 0 && cones_.size() < kMaxCones) cones_.push_back(beam);
    if (beam.openingAngle <= 0 && beam.hit()) rays.push_back(&beam);
  }
  const std::size_t count = std::min(rays.size(), static_cast<std::size_t>(std::max(1, options_.rays)));
  for (std::size_t i = 0; i < count; ++i) {
    rays_.push_back(*rays[i * rays.size() / count]);
    const Vector2 end = rays_.back().endInRobot();
    rayEnds_.push_back({static_cast<float>(end.x()), static_cast<float>(end.y())});
  }
}

double RangeModel::expectedRange(const Pose2& robotInMap, const RangeBeam& cone) const {
  return distances_.range(robotInMap * cone.sensorInRobot, cone.openingAngle, cone.maximum);
}

double RangeModel::logLikelihood(const Particle& particle) const {
  const float c = std::cos(particle.heading), s = std::sin(particle.heading);
  float rays = 0;
  for (const RayEnd& end : rayEnds_)
    rays += field_.logLikelihood(particle.x + c * end.x - s * end.y, particle.y + s * end.x + c * end.y);
  double cones = 0;
  for (const RangeBeam& cone : cones_) {
    const double expected = expectedRange(particle.pose(), cone);
    const double away = (cone.range - expected) / (options_.sonarDeviation + 0.05 * expected);
    const double share = cone.hit() ? options_.randomShare : std::max(kSwallowed, options_.randomShare);
    cones += std::log((1 - share) * std::exp(-0.5 * away * away) + share);
  }
  // Cones have different directions; adjacent rays contain the same information.
  return options_.evidence * (static_cast<double>(rays) + 2 * cones);
}

bool RangeModel::explained(const Pose2& robotInMap, const RangeBeam& ray) const {
  if (distances_.at(robotInMap * ray.endInRobot()) > kNearWall) return false;
  const double before = ray.range - kThroughWall;
  return before <= 0 || distances_.range(robotInMap * ray.sensorInRobot, 0, before) >= before;
}

double RangeModel::explainedShare(const Pose2& robotInMap) const {
  int explained = 0;
  for (const RangeBeam& ray : rays_) explained += this->explained(robotInMap, ray) ? 1 : 0;
  for (const RangeBeam& cone : cones_) {
    const double expected = expectedRange(robotInMap, cone);
    explained += std::abs(expected - cone.range) < kExplained + 0.1 * expected ? 1 : 0;
  }
  return explained / static_cast<double>(rayEnds_.size() + cones_.size());
}

}  // namespace modules
