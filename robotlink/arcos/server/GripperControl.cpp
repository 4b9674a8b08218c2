// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/GripperControl.h"

#include <algorithm>
#include <utility>

#include "robotlink/arcos/GripperState.h"

namespace robotlink::arcos {
namespace {

constexpr Duration kInterval = std::chrono::milliseconds(20);
constexpr int kPressure = 16, kCarry = 17;
constexpr int kMaxIntervals = 255;

unsigned bit(unsigned number, bool set) {
  return set ? 1U << number : 0U;
}

}  // namespace

bool GripperControl::obey(int action) {
  carryValueNext_ = action == kCarry;
  if (action == kPressure || action == kCarry) return true;
  if (action < 0 || action > static_cast<int>(GripperAction::kHalt)) return false;
  const auto move = [this](int paddles, int lift, int liftNext) {
    paddles_ = paddles;
    lift_ = lift;
    liftNext_ = liftNext;
    if (paddles > 0) grasps_ = false;
    pressed_ = carrying_ = {};
  };
  switch (static_cast<GripperAction>(action)) {
    case GripperAction::kOpen:
      move(1, lift_, 0);
      break;
    case GripperAction::kClose:
      move(-1, lift_, 0);
      break;
    case GripperAction::kStop:
      move(0, lift_, 0);
      break;
    case GripperAction::kLiftUp:
      move(paddles_, 1, 0);
      break;
    case GripperAction::kLiftDown:
      move(paddles_, -1, 0);
      break;
    case GripperAction::kLiftStop:
      move(paddles_, 0, 0);
      break;
    case GripperAction::kStore:
      move(-1, 0, 1);
      break;
    case GripperAction::kDeploy:
      move(1, -1, 0);
      break;
    case GripperAction::kHalt:
      halt();
      break;
  }
  return false;
}

void GripperControl::setValue(int intervals) {
  const int value = std::clamp(intervals, 0, kMaxIntervals);
  if (!std::exchange(carryValueNext_, false)) {
    graspTime_ = static_cast<std::uint8_t>(value);
    return;
  }
  lift_ = value > 0 ? 1 : 0;
  carrying_ = value * kInterval;
}

void GripperControl::halt() {
  paddles_ = lift_ = liftNext_ = 0;
  pressed_ = carrying_ = {};
}

GripperCommand GripperControl::step(const GripperSensing& sensing, Duration passed) {
  sensing_ = sensing;
  stepPaddles(passed);
  stepLift(passed);
  return {paddles_, lift_, grasps_};
}

void GripperControl::stepPaddles(Duration passed) {
  if (paddles_ > 0 && sensing_.open) paddles_ = 0;
  if (paddles_ < 0) {
    const bool both = sensing_.leftPaddle && sensing_.rightPaddle;
    pressed_ = both ? pressed_ + passed : Duration{};
    const bool grasped = both && pressed_ >= graspTime_ * kInterval;
    if (grasped) grasps_ = true;
    if (grasped || sensing_.closed) paddles_ = 0;
  }
  if (paddles_ == 0 && liftNext_ != 0) lift_ = std::exchange(liftNext_, 0);
}

void GripperControl::stepLift(Duration passed) {
  if ((lift_ > 0 && sensing_.liftUp) || (lift_ < 0 && sensing_.liftDown)) lift_ = 0;
  if (carrying_ <= Duration{}) return;
  carrying_ -= passed;
  if (carrying_ <= Duration{}) lift_ = 0;
}

std::uint8_t GripperControl::state() const {
  return static_cast<std::uint8_t>(bit(0, sensing_.open) | bit(1, sensing_.closed || grasps_) |
                                   bit(2, paddles_ != 0) | bit(4, sensing_.liftUp) |
                                   bit(5, sensing_.liftDown) | bit(6, lift_ != 0));
}

std::uint8_t GripperControl::switches() const {
  return static_cast<std::uint8_t>(
      bit(0, !sensing_.open) | bit(1, !(sensing_.liftUp || sensing_.liftDown)) | bit(2, sensing_.outerBeam) |
      bit(3, sensing_.innerBeam) | bit(4, !(sensing_.leftPaddle || sensing_.closed)) |
      bit(5, !(sensing_.rightPaddle || sensing_.closed)) | bit(6, lift_ != 0) | bit(7, paddles_ != 0));
}

}  // namespace robotlink::arcos
