// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/CornerEscape.h"

namespace modules {

namespace {

// The requested rotation, rad/s, and the possible speed, m/s, below which there is none.
constexpr double kWantsTurn = 0.1, kDrivesSpeed = 0.04;
// The time of turning without success before it tries the other side, s.
constexpr double kOtherSideAfter = 12;

// The time in which a move must have made room, s; and the bonus for continuing in the same direction, m.
constexpr double kMakingRoom = 1.5, kKeeping = 0.03;

/// Returns 1 if there is more room to the left, -1 if to the right.
double betterSide(const PolarView& view) {
  double left = 0, right = 0;
  for (int sector = 1; sector < PolarView::kSectors / 2; ++sector) {
    left += view.free(sector);
    right += view.free(-sector);
  }
  return left >= right ? 1 : -1;
}

}  // namespace

bool CornerEscape::freed(const DriveVelocity& desired, const Clearance& clearance, const PolarView& view,
                         const DriveLimits& limits) const {
  if (desired.forward <= kWantsSpeed)
    return clearance.safe({0, std::copysign(options_.rotation, desired.rotation)}, limits, options_.latency);
  return view.freeAbout(0, robotlink::radians(10)) > options_.roomAhead &&
         clearance.safe({0.2, 0}, limits, options_.latency);
}

DriveVelocity CornerEscape::decide(const DriveVelocity& desired, const DriveVelocity& possible,
                                   const Clearance& clearance, const PolarView& view,
                                   const DriveLimits& limits, double time) {
  const bool wantsAhead = desired.forward > kWantsSpeed;
  const bool wantsTurn = std::abs(desired.forward) <= kWantsSpeed && std::abs(desired.rotation) > kWantsTurn;
  if (side_ != 0 && (wantsAhead || wantsTurn) && !freed(desired, clearance, view, limits))
    return escape(clearance, limits, time);
  const bool was = side_ != 0;
  side_ = 0;
  const double least = 0.3 * std::min(std::abs(desired.rotation), options_.rotation);
  const bool stuck =
      wantsAhead ? possible.forward < kDrivesSpeed : wantsTurn && std::abs(possible.rotation) < least;
  if (was || !stuck || stuckSince_ < 0 || stuckSince_ > time) stuckSince_ = stuck ? time : -1;
  if (!stuck || time - stuckSince_ < options_.patience) return possible;
  side_ = wantsTurn ? std::copysign(1, desired.rotation) : betterSide(view);
  since_ = time;
  return escape(clearance, limits, time);
}

DriveVelocity CornerEscape::escape(const Clearance& clearance, const DriveLimits& limits, double time) {
  if (time - since_ > kOtherSideAfter) {
    side_ = -side_;
    since_ = time;
  }
  for (const double share : {1.0, 0.4}) {
    const DriveVelocity turning{0, side_ * share * options_.rotation};
    if (clearance.safe(turning, limits, options_.latency)) return turning;
  }
  // There is no room to turn: move to where there is more, back or ahead, straight or in a curve.
  DriveVelocity best;
  double most = -1;
  for (const double direction : {-1.0, 1.0}) {
    for (const double turn : {0.0, 0.1, -0.1, 0.3, -0.3}) {
      const DriveVelocity moving{direction * options_.backingSpeed, turn * options_.rotation};
      if (!clearance.safe(moving, limits, options_.latency)) continue;
      // Prevents moving back and forth.
      const double room =
          clearance.nearestAfter(moving, kMakingRoom) + (direction == direction_ ? kKeeping : 0);
      if (room <= most) continue;
      most = room;
      best = moving;
    }
  }
  if (most >= 0) {
    direction_ = best.forward > 0 ? 1 : -1;
    return best;
  }
  const DriveVelocity other{0, -side_ * 0.4 * options_.rotation};
  return clearance.safe(other, limits, options_.latency) ? other : DriveVelocity{};
}

}  // namespace modules
