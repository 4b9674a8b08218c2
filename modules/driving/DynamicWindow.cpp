// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/DynamicWindow.h"

#include <algorithm>
#include <cmath>

namespace modules {

namespace {

// Reach of the view for escapes and for room on the sides, m.
constexpr double kReach = 2.5;

/// The i-th of `count` samples from low to high.
double sample(double low, double high, int i, int count) {
  return count > 1 ? low + (high - low) * i / (count - 1) : 0.5 * (low + high);
}

}  // namespace

void DynamicWindow::setOptions(const Options& options) {
  options_ = options;
  escape_.setOptions(options.escape);
}

DynamicWindow::Candidate DynamicWindow::judged(const DriveVelocity& velocity,
                                               const AvoidanceSituation& situation,
                                               const Clearance& clearance, const PolarView& view) const {
  Candidate candidate{velocity, clearance.freeTime(velocity), false, 0};
  const DriveLimits& limits = situation.limits;
  const double braking = std::max(0.5 * std::abs(velocity.forward) / limits.acceleration,
                                  0.5 * std::abs(velocity.rotation) / limits.rotationAcceleration);
  candidate.admissible = candidate.freeTime >= std::min(options_.horizon, options_.latency + braking);
  const double speed = std::abs(velocity.forward - situation.desired.forward) / limits.speed;
  const double rotation = std::abs(velocity.rotation - situation.desired.rotation) / limits.rotation;
  // The room in the direction that the robot will have after a while.
  const double room = view.freeAt(0.7 * velocity.rotation) / view.reach();
  // The distance that the robot gets, relative to the requested distance without obstacles.
  const double desired = std::max(1e-3, std::abs(situation.desired.forward)) * options_.horizon;
  const double way = std::abs(velocity.forward) * candidate.freeTime / desired;
  candidate.value = -options_.speedWeight * speed - options_.rotationWeight * rotation +
                    options_.wayWeight * way + options_.roomWeight * room;
  return candidate;
}

DriveVelocity DynamicWindow::best(const AvoidanceSituation& situation, const Clearance& clearance,
                                  const PolarView& view) {
  const DriveLimits& limits = situation.limits;
  const double faster = limits.acceleration * options_.window;
  const double sharper = limits.rotationAcceleration * options_.window;
  const double desired = situation.desired.forward;
  // Never faster than requested, and backward only if requested.
  const double most = std::max(0.0, desired), least = std::min(0.0, desired);
  const double low = std::clamp(situation.now.forward - 2 * faster, least, most);
  const double high = std::clamp(situation.now.forward + faster, least, most);
  const double right =
      std::max(-limits.rotation, std::min(situation.now.rotation, limits.rotation) - sharper);
  const double left = std::min(limits.rotation, std::max(situation.now.rotation, -limits.rotation) + sharper);
  candidates_.clear();
  candidates_.push_back(
      judged({std::clamp(desired, low, high), std::clamp(situation.desired.rotation, right, left)}, situation,
             clearance, view));
  for (int i = 0; i < options_.speeds; ++i)
    for (int j = 0; j < options_.rotations; ++j)
      candidates_.push_back(
          judged({sample(low, high, i, options_.speeds), sample(right, left, j, options_.rotations)},
                 situation, clearance, view));
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates_)
    if (candidate.admissible && (best == nullptr || candidate.value > best->value)) best = &candidate;
  return best != nullptr ? best->velocity : DriveVelocity{};
}

DriveVelocity DynamicWindow::decide(const AvoidanceSituation& situation) {
  const Clearance clearance(options_.outline, {options_.margin, options_.horizon}, situation.points);
  const PolarView view(situation.points, options_.outline.halfWidth + options_.margin, kReach);
  if (situation.desired.forward > CornerEscape::kWantsSpeed) {
    chosen_ = best(situation, clearance, view);
  } else {
    // Turning on the spot and moving backward are executed as requested, as far as that is safe.
    candidates_.clear();
    chosen_ = clearance.limited(situation.desired, situation.limits, options_.latency);
  }
  chosen_ = escape_.decide(situation.desired, chosen_, clearance, view, situation.limits, situation.time);
  return chosen_;
}

}  // namespace modules
