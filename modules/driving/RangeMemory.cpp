// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/RangeMemory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_set>

namespace modules {

using robotlink::Instant;
using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

constexpr std::size_t kMaxPoints = 3000;
// A measurement does not remove points that it passes by more than this, m.
constexpr double kBehind = 0.15;
// Side of the squares that yield one point each, m.
constexpr double kThinning = 0.05;
// An older scan says nothing about what a sonar hears now, s.
constexpr double kRaysOutdated = 0.3;
// How far outside a cone a ray may still explain its echo, rad.
constexpr double kRayAside = 0.05;
constexpr std::size_t kMaxCones = 256;

double bearingOf(const Vector2& point) {
  return std::atan2(point.y(), point.x());
}

}  // namespace

void RangeMemory::see(std::span<const RangeBeam> beams, const OdometryHistory& odometry) {
  std::vector<RangeBeam> rays;
  for (const RangeBeam& beam : beams)
    if (beam.openingAngle <= 0) rays.push_back(beam);
  if (!rays.empty()) {
    if (const auto robot = odometry.at(rays.front().time)) {
      seeRays(rays, *robot);
      lastRays_ = std::move(rays);
    }
  }
  for (const RangeBeam& beam : beams) {
    if (beam.openingAngle <= 0) continue;
    if (const auto robot = odometry.at(beam.time)) seeCone(beam, *robot, lastRays_);
  }
}

void RangeMemory::add(const Vector2& place, Instant time, Source source) {
  if (points_.size() >= kMaxPoints) points_.erase(points_.begin(), points_.begin() + kMaxPoints / 10);
  points_.push_back({place, time, source});
}

/// Processes a scan in the order of its angles: it replaces what earlier scans saw within its field of view.
void RangeMemory::seeRays(std::span<const RangeBeam> rays, const Pose2& robotInOdometry) {
  newest_ = std::max(newest_.value_or(rays.front().time), rays.front().time);
  const Pose2 laserInRobot{rays.front().sensorInRobot.x, rays.front().sensorInRobot.y, 0};
  const Pose2 odometryInLaser = (robotInOdometry * laserInRobot).inverse();
  const double first = rays.front().sensorInRobot.heading;
  const double step = rays.size() > 1 ? normalizedAngle(rays[1].sensorInRobot.heading - first) : 0;
  std::erase_if(points_, [&](const Point& point) {
    if (point.source != Source::kLaser || step == 0) return false;
    double ray = normalizedAngle(bearingOf(odometryInLaser * point.place) - first) / step;
    if (ray < -0.5) ray += 2 * robotlink::kPi / std::abs(step);
    return ray >= -0.5 && ray < static_cast<double>(rays.size()) - 0.5;
  });
  for (const RangeBeam& ray : rays)
    if (ray.hit() && ray.range < options_.reach)
      add(robotInOdometry * ray.endInRobot(), ray.time, Source::kLaser);
}

bool RangeMemory::FreeCone::contains(const Vector2& place) const {
  const Vector2 inSensor = sensor.inverse() * place;
  return std::abs(bearingOf(inSensor)) < half && inSensor.norm() < range - kBehind;
}

void RangeMemory::seeCone(const RangeBeam& cone, const Pose2& robotInOdometry,
                          std::span<const RangeBeam> rays) {
  newest_ = std::max(newest_.value_or(cone.time), cone.time);
  const FreeCone free{robotInOdometry * cone.sensorInRobot, 0.5 * cone.openingAngle, cone.range, cone.time};
  std::erase_if(points_, [&](const Point& point) {
    return point.source == Source::kSonar && free.contains(point.place);
  });
  while (!freeCones_.empty() &&
         (freeCones_.size() >= kMaxCones ||
          robotlink::seconds(cone.time - freeCones_.front().time) > options_.coneMemory))
    freeCones_.pop_front();
  if (cone.hit() && cone.range < options_.reach && !explainedByRays(cone, rays)) addArc(free);
  freeCones_.push_back(free);
}

bool RangeMemory::explainedByRays(const RangeBeam& cone, std::span<const RangeBeam> rays) const {
  const Pose2 robotInSensor = cone.sensorInRobot.inverse();
  return std::ranges::any_of(rays, [&](const RangeBeam& ray) {
    if (!ray.hit() || std::abs(robotlink::seconds(cone.time - ray.time)) > kRaysOutdated) return false;
    const Vector2 end = robotInSensor * ray.endInRobot();
    return std::abs(bearingOf(end)) < 0.5 * cone.openingAngle + kRayAside &&
           std::abs(end.norm() - cone.range) < options_.sameAs;
  });
}

void RangeMemory::addArc(const FreeCone& cone) {
  // From the axis outwards.
  constexpr std::array kShares{0.0, 0.3, -0.3, 0.6, -0.6, 0.9, -0.9};
  constexpr std::size_t kMax = 3;
  std::size_t added = 0;
  for (const double share : kShares) {
    const Vector2 place = cone.sensor * Pose2{0, 0, share * cone.half} * Vector2(cone.range, 0);
    const bool free =
        std::ranges::any_of(freeCones_, [&](const FreeCone& other) { return other.contains(place); });
    if (free) continue;
    add(place, cone.time, Source::kSonar);
    if (++added == kMax) return;
  }
  // The whole arc was free a moment ago, so something moves.
  if (added == 0) add(cone.sensor * Vector2(cone.range, 0), cone.time, Source::kSonar);
}

void RangeMemory::touch(const Vector2& placeInRobot, const Pose2& robotInOdometry, Instant now) {
  add(robotInOdometry * placeInRobot, now, Source::kBumper);
}

void RangeMemory::forget(Instant now, const Pose2& robotInOdometry) {
  std::erase_if(points_, [&](const Point& point) {
    const double age = robotlink::seconds(now - point.time);
    const double away = (point.place - robotInOdometry.translation()).norm();
    double most = point.source == Source::kBumper ? options_.bumperMemory : options_.memory;
    if (point.source == Source::kLaser && away < options_.near) most = options_.nearMemory;
    return age > most || away > options_.reach;
  });
}

std::vector<Vector2> RangeMemory::pointsInRobot(const Pose2& robotInOdometry) const {
  const Pose2 odometryInRobot = robotInOdometry.inverse();
  std::unordered_set<std::uint64_t> taken;
  std::vector<Vector2> result;
  for (const Point& point : points_) {
    const auto x = static_cast<std::int32_t>(std::floor(point.place.x() / kThinning));
    const auto y = static_cast<std::int32_t>(std::floor(point.place.y() / kThinning));
    const std::uint64_t square =
        (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) | static_cast<std::uint32_t>(y);
    if (taken.insert(square).second) result.push_back(odometryInRobot * point.place);
  }
  return result;
}

}  // namespace modules
