// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/VectorField.h"

#include <algorithm>

namespace modules {

using robotlink::normalizedAngle;

namespace {

// The distance from the outline that is enforced in the direction of driving, m.
constexpr double kHardMargin = 0.1;
// The fraction of the requested speed that is kept in every direction.
constexpr double kMinShare = 0.1;

}  // namespace

void VectorField::setOptions(const Options& options) {
  options_ = options;
  escape_.setOptions(options.escape);
}

void VectorField::openSectors(double need) {
  const double again = need + std::max(0.0, options_.needAgain - options_.need);
  for (int sector = 0; sector < PolarView::kSectors; ++sector) {
    bool& open = open_[static_cast<std::size_t>(sector)];
    open = view_.free(sector) > (open ? need : again);
  }
}

DriveVelocity VectorField::steered(const DriveVelocity& desired, const DriveLimits& limits) {
  const double wanted = std::clamp(desired.rotation * options_.desiredTime, -2.0, 2.0);
  // Slow requests need less room.
  openSectors(std::min(options_.need, options_.outline.halfLength + 0.15 + 1.6 * desired.forward));
  double best = 1e9, direction = 0;
  bool found = false;
  for (int sector = 0; sector < PolarView::kSectors; ++sector) {
    const double angle = PolarView::angleOf(sector);
    if (!open(sector) || std::abs(angle) > robotlink::radians(120)) continue;
    const double cost = options_.desiredCost * std::abs(normalizedAngle(angle - wanted)) +
                        options_.straightCost * std::abs(angle) +
                        options_.lastCost * std::abs(normalizedAngle(angle - direction_)) +
                        1.0 / std::max(0.2, view_.free(sector));
    if (cost >= best) continue;
    best = cost;
    direction = angle;
    found = true;
  }
  if (!found) return {0, 0};
  direction_ = direction;
  const double room = view_.freeAbout(0, robotlink::radians(5));
  const double straight = std::max(kMinShare, std::cos(direction));
  const double speed = desired.forward * straight * std::clamp(room / options_.reach + kMinShare, 0.0, 1.0);
  // If the requested direction is open, the request is followed unchanged.
  const bool asDesired = std::abs(direction - wanted) < 0.6 * PolarView::kSector;
  const double rotation = asDesired ? desired.rotation : options_.steering * direction;
  return {direction > 1.2 || direction < -1.2 ? 0 : speed,
          std::clamp(rotation, -limits.rotation, limits.rotation)};
}

DriveVelocity VectorField::decide(const AvoidanceSituation& situation) {
  const Clearance clearance(options_.outline, {kHardMargin, 3.0}, situation.points);
  view_ = PolarView(situation.points, options_.outline.halfWidth + options_.margin, options_.reach);
  DriveVelocity wanted = situation.desired;
  // Only motion ahead is steered; turning on the spot and moving backward are executed as requested.
  if (wanted.forward > CornerEscape::kWantsSpeed)
    wanted = steered(wanted, situation.limits);
  else
    direction_ = 0;
  const DriveVelocity possible = clearance.limited(wanted, situation.limits, options_.latency);
  return escape_.decide(situation.desired, possible, clearance, view_, situation.limits, situation.time);
}

}  // namespace modules
