// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerBattery.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double kCapacity = 3 * 7.2 * 3600;              // A s
constexpr double kInternalResistance = 0.03;              // ohm, of all three
constexpr double kIdleCurrent = 2, kMotorsCurrent = 0.5;  // A
constexpr double kDrivingCurrent = 8;                     // A at 1 m/s

}  // namespace

void PioneerBattery::discharge(bool motorsOn, double speed, robotlink::Duration passed) {
  current_ =
      kIdleCurrent + (motorsOn ? kMotorsCurrent + kDrivingCurrent * std::min(std::abs(speed), 2.0) : 0);
  charge_ = std::max(0.0, charge_ - current_ * robotlink::seconds(passed) / kCapacity);
}

double PioneerBattery::voltage() const {
  return empty_ + (full_ - empty_) * charge_ - kInternalResistance * current_;
}

}  // namespace app
