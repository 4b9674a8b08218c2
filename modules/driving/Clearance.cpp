// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/Clearance.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Vector2;

namespace {

// The maximum distance that a corner of the robot moves between two checks, m.
constexpr double kStep = 0.04;
// The distance by which a point within the margin may come closer before that counts, m.
constexpr double kSlack = 0.003;
// The distance that is kept even from points within the margin, m.
constexpr double kTouching = 0.02;

}  // namespace

Clearance::Clearance(const Outline& outline, const Options& options, std::span<const Vector2> points)
    : outline_(outline), options_(options) {
  for (const Vector2& point : points) {
    const double distance = outline_.distance(point);
    nearest_ = std::min(nearest_, distance);
    // A point inside the outline is an error, or it is too late.
    const double allowed =
        std::min(options_.margin, std::max(distance - kSlack, std::min(distance, kTouching)));
    obstacles_.push_back({static_cast<float>(point.x()), static_cast<float>(point.y()),
                          static_cast<float>(allowed), static_cast<float>(point.norm())});
  }
  std::ranges::sort(obstacles_, {}, &Obstacle::reach);
}

double Clearance::freeTime(const DriveVelocity& velocity) const {
  const double cornerSpeed = std::abs(velocity.forward) + std::abs(velocity.rotation) * outline_.radius();
  if (cornerSpeed < 1e-6) return options_.horizon;
  const double step = kStep / cornerSpeed;
  const auto halfLength = static_cast<float>(outline_.halfLength),
             halfWidth = static_cast<float>(outline_.halfWidth);
  for (double time = step; time < options_.horizon; time += step) {
    const double turn = velocity.rotation * time;
    // The displacement along an arc.
    const double half = 0.5 * turn;
    const double chord = velocity.forward * time * (std::abs(half) < 1e-6 ? 1 : std::sin(half) / half);
    const auto x = static_cast<float>(chord * std::cos(half)), y = static_cast<float>(chord * std::sin(half));
    const auto c = static_cast<float>(std::cos(turn)), s = static_cast<float>(std::sin(turn));
    const auto reach = static_cast<float>(std::abs(chord) + outline_.radius() + options_.margin);
    for (const Obstacle& obstacle : obstacles_) {
      if (obstacle.reach > reach) break;
      const float dx = obstacle.x - x, dy = obstacle.y - y;
      const float ahead = std::max(0.0F, std::abs(c * dx + s * dy) - halfLength);
      const float aside = std::max(0.0F, std::abs(c * dy - s * dx) - halfWidth);
      if (ahead * ahead + aside * aside < obstacle.allowed * obstacle.allowed) return time - step;
    }
  }
  return options_.horizon;
}

double Clearance::nearestAfter(const DriveVelocity& velocity, double time) const {
  const double turn = velocity.rotation * time, half = 0.5 * turn;
  const double chord = velocity.forward * time * (std::abs(half) < 1e-6 ? 1 : std::sin(half) / half);
  const robotlink::Pose2 before =
      robotlink::Pose2{chord * std::cos(half), chord * std::sin(half), turn}.inverse();
  double nearest = 1e3;
  for (const Obstacle& obstacle : obstacles_)
    nearest = std::min(nearest, outline_.distance(before * Vector2(obstacle.x, obstacle.y)));
  return nearest;
}

bool Clearance::safe(const DriveVelocity& velocity, const DriveLimits& limits, double latency) const {
  // Braking takes half as long as the same distance at the initial velocity.
  const double braking = std::max(0.5 * std::abs(velocity.forward) / limits.acceleration,
                                  0.5 * std::abs(velocity.rotation) / limits.rotationAcceleration);
  return freeTime(velocity) >= std::min(options_.horizon, latency + braking);
}

DriveVelocity Clearance::limited(const DriveVelocity& velocity, const DriveLimits& limits,
                                 double latency) const {
  for (const double share : {1.0, 0.8, 0.6, 0.45, 0.3, 0.2, 0.1}) {
    const DriveVelocity less{share * velocity.forward, share * velocity.rotation};
    if (safe(less, limits, latency)) return less;
  }
  for (const double share : {1.0, 0.5}) {
    const DriveVelocity turning{0, share * velocity.rotation};
    if (safe(turning, limits, latency)) return turning;
  }
  return {};
}

}  // namespace modules
