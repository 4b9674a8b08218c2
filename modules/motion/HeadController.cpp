// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/HeadController.h"

#include <algorithm>
#include <cmath>

#include "modules/motion/Approach.h"

namespace modules {
namespace {

// The head cannot look at points nearer to the neck than this, m: it would have to look through the chest.
constexpr double kNearest = 0.06;
// If the head lags behind a sweep by more than this, rad, the sweep waits.
constexpr double kLag = 0.5;
// A ball that is nearer to the body's origin is before the paws, m, and from there on it is kept lower the
// farther it is away, in full after this distance.
constexpr double kBeforePaws = 0.2, kFullyLow = 0.1;

// A ball that was nearer than this, m, is searched before the paws first.
constexpr double kNearBall = 0.45;

}  // namespace

HeadAngles HeadController::advance(const HeadCommand& desired, const std::optional<BallSight>& ball,
                                   const HeadAngles& now, robotlink::Duration frame) {
  const double dt = robotlink::seconds(frame);
  const bool isKnown = ball && ball->position.allFinite();
  if (isKnown) {
    side_ = ball->position.y() < 0 ? -1 : 1;
    searchesNear_ = ball->position.norm() < kNearBall;
  }
  const bool looksForBall =
      desired.kind == HeadCommand::Kind::kTrackBall || desired.kind == HeadCommand::Kind::kSearchBall;
  // After looking elsewhere, the head first looks for an old ball at its place.
  lookedFor_ = isKnown && looksForBall ? std::min(ball->age, lookedFor_ + dt) : 0;
  switch (desired.kind) {
    case HeadCommand::Kind::kLookAhead:
      state_ = State::kStill;
      return {parameters_.aheadTilt, 0, 0, 0};
    case HeadCommand::Kind::kAngles:
      state_ = State::kStill;
      return desired.angles;
    case HeadCommand::Kind::kLookAround:
      return lookAround(now, frame);
    default:
      break;
  }
  if (isKnown && lookedFor_ < parameters_.lostAfter) {
    state_ = State::kTracking;
    return tracking(ball->position);
  }
  const double far = parameters_.searchFarTilt, near = parameters_.searchNearTilt;
  const double wide = parameters_.searchFarPan * side_, narrow = parameters_.searchNearPan * side_;
  if (searchesNear_)
    return swept({{near, narrow}, {near, -narrow}, {far, -wide}, {far, wide}}, State::kSearching, now, dt);
  return swept({{far, wide}, {far, -wide}, {near, -narrow}, {near, narrow}}, State::kSearching, now, dt);
}

HeadAngles HeadController::lookAround(const HeadAngles& now, robotlink::Duration frame) {
  const double tilt = parameters_.aroundTilt, pan = parameters_.aroundPan;
  return swept({{tilt, pan}, {tilt, -pan}}, State::kSweeping, now, robotlink::seconds(frame));
}

/// Moves along a closed path at the sweep's speed, starting at the head's present angles.
HeadAngles HeadController::swept(const std::vector<Waypoint>& path, State state, const HeadAngles& now,
                                 double seconds) {
  if (state_ != state) {
    state_ = state;
    sweep_ = {now.tilt, now.pan, 0, 0};
    waypoint_ = 0;
  }
  const double lag = std::max(std::abs(sweep_.pan - now.pan), std::abs(sweep_.tilt - now.tilt));
  const double step = lag > kLag ? 0 : parameters_.sweepSpeed * seconds;
  const Waypoint& target = path[waypoint_ % path.size()];
  sweep_.tilt = approached(sweep_.tilt, target.tilt, step);
  sweep_.pan = approached(sweep_.pan, target.pan, step);
  if (sweep_.tilt == target.tilt && sweep_.pan == target.pan) waypoint_ = (waypoint_ + 1) % path.size();
  return sweep_;
}

HeadAngles HeadController::tracking(const robotlink::Vector2& ball) const {
  HeadAngles angles = anglesTowards({ball.x(), ball.y(), parameters_.ballRadius});
  const double share = std::clamp((ball.norm() - kBeforePaws) / kFullyLow, 0.0, 1.0);
  const double up = std::max(0.0, parameters_.aroundTilt - angles.tilt);
  angles.tilt += std::min(up, share * parameters_.ballLow);
  return angles;
}

HeadAngles HeadController::anglesTowards(const robotlink::Vector3& pointInRobot) const {
  // From the robot's frame on the ground to the body's, whose nose is pitched down.
  const robotlink::Vector3 raised = pointInRobot - robotlink::Vector3(0, 0, parameters_.bodyHeight);
  robotlink::Vector3 point = Eigen::AngleAxisd(-parameters_.bodyPitch, robotlink::Vector3::UnitY()) * raised;
  point -= robotlink::Vector3(dimensions_.neckX, 0, dimensions_.neckZ);
  point.x() = std::max(point.x(), kNearest);
  // The pan axis is on the tilted neck, so tilt must bring the point to the height of the pan's center.
  const double distance = std::hypot(point.x(), point.z());
  const double tilt =
      std::atan2(point.z(), point.x()) - std::asin(std::min(dimensions_.neckLength / distance, 1.0));
  const double ahead = point.x() * std::cos(tilt) + point.z() * std::sin(tilt);
  return {tilt, std::atan2(point.y(), ahead), 0, 0};
}

}  // namespace modules
