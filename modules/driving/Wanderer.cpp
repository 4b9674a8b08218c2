// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/Wanderer.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::normalizedAngle;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

// m, beyond which more room makes no difference.
constexpr double kOpenReach = 3.5;
// rad, to the sides that it chooses from while it drives.
constexpr double kWidest = robotlink::radians(100);
// The value of a radian closer to straight ahead, in m of room.
constexpr double kStraightness = 0.8;
// The same for the preferred direction, and for the direction chosen before.
constexpr double kLiking = 0.3, kSteadiness = 0.8;
// The robot stops at this fraction of the distance at which it begins to turn on the spot.
constexpr double kTooNear = 0.6;
// The angle on both sides of a direction that should be free, too, rad.
constexpr double kBeside = 1.01 * PolarView::kSector;
// Side of the squares whose visits are counted, m; time after which a square counts as known, s; step and
// reach of the search for new squares, m.
constexpr double kSquare = 1.0, kUsualVisit = 6, kNewsStep = 0.75, kNewsReach = 3;
constexpr std::size_t kMaxSquares = 20000;

std::uint64_t squareOf(const Vector2& place) {
  const auto x = static_cast<std::int32_t>(std::clamp(std::floor(place.x() / kSquare), -1e9, 1e9));
  const auto y = static_cast<std::int32_t>(std::clamp(std::floor(place.y() / kSquare), -1e9, 1e9));
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) | static_cast<std::uint32_t>(y);
}

}  // namespace

void Wanderer::visit(const Vector2& place, double time) {
  if (visits_.size() >= kMaxSquares) visits_.clear();
  // Longer gaps were spent in other places.
  const double spent = std::clamp(time - visitedAt_, 0.0, 0.5);
  visitedAt_ = time;
  visits_[squareOf(place)] += spent;
}

double Wanderer::visited(const Vector2& place) const {
  const auto found = visits_.find(squareOf(place));
  return found == visits_.end() ? 0 : 1 - std::exp(-found->second / kUsualVisit);
}

double Wanderer::valueOf(double angle, const PolarView& view, const Pose2& robotInOdometry) const {
  const double free = view.freeAt(angle);
  double news = 0;
  for (double way = kNewsStep; way <= kNewsReach; way += kNewsStep) {
    if (way > free) break;
    const Vector2 place = robotInOdometry * (Pose2{0, 0, angle} * Vector2(way, 0));
    news += (1 - visited(place)) * kNewsStep / kNewsReach;
  }
  // Including its neighbors, because the center of a gap is better than its edge.
  return 0.75 * free + 0.25 * view.freeAbout(angle, kBeside) + options_.novelty * news;
}

double Wanderer::bestDirection(const PolarView& view, const Pose2& robotInOdometry) const {
  double best = -1e9, direction = 0;
  const double last = normalizedAngle(heading_ - robotInOdometry.heading);
  for (int sector = 0; sector < PolarView::kSectors; ++sector) {
    const double angle = PolarView::angleOf(sector);
    if (std::abs(angle) > kWidest) continue;
    const double value = valueOf(angle, view, robotInOdometry) - kStraightness * std::abs(angle) -
                         kLiking * std::abs(angle - liking_) -
                         kSteadiness * std::abs(normalizedAngle(angle - last));
    if (value <= best) continue;
    best = value;
    direction = angle;
  }
  return direction;
}

double Wanderer::betterSide(const PolarView& view, const Pose2& robotInOdometry) const {
  double left = 0, right = 0;
  for (int sector = 1; sector < PolarView::kSectors / 2; ++sector) {
    const double angle = PolarView::angleOf(sector);
    left += valueOf(angle, view, robotInOdometry);
    right += valueOf(-angle, view, robotInOdometry);
  }
  return left >= right ? 1 : -1;
}

DriveVelocity Wanderer::decide(std::span<const Vector2> points, const Pose2& robotInOdometry, double time) {
  if (time >= likingUntil_ || time < likingUntil_ - 2 * options_.likingTime) {
    liking_ = random_.uniform(-1, 1);
    likingUntil_ = time + options_.likingTime * random_.uniform(0.5, 1.5);
  }
  visit(robotInOdometry.translation(), time);
  const PolarView view(points, options_.halfWidth, kOpenReach);
  const double ahead = view.free(0);
  direction_ = bestDirection(view, robotInOdometry);
  heading_ = robotInOdometry.heading + direction_;
  if (turning_ != 0 && ahead >= options_.roomAgain) turning_ = 0;
  if (turning_ == 0 && ahead < options_.room && view.freeAt(direction_) < options_.roomAgain)
    turning_ = betterSide(view, robotInOdometry);
  if (turning_ != 0) return {0, turning_ * options_.rotation};
  const double share = std::clamp((ahead - kTooNear * options_.room) / options_.easyRoom, 0.0, 1.0);
  const double straight = std::max(0.0, std::cos(direction_));
  return {options_.speed * share * straight * straight,
          std::clamp(1.2 * direction_, -options_.rotation, options_.rotation)};
}

}  // namespace modules
