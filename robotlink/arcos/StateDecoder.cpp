// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/StateDecoder.h"

#include <algorithm>

namespace robotlink::arcos {
namespace {

// Some controllers wrap at 2^15, others at 2^16. Unwrapping at 2^15 is right for both, because no robot
// drives 16 m in a cycle.
constexpr int kWrap = 1 << 15;
// If a reset is expected, a robot this near the origin has done it. It may have moved on since.
constexpr double kNearOrigin = 0.2;  // m

int difference(int now, int before) {
  const int forwards = (now - before) & (kWrap - 1);
  return forwards >= kWrap / 2 ? forwards - kWrap : forwards;
}

}  // namespace

StateDecoder::StateDecoder(RobotType type) : type_(std::move(type)) {
  for (const Pose2& pose : type_.sonarsInRobot)
    state_.sonars.push_back({pose, type_.sonarMaximum, false, {}, {}});
}

void StateDecoder::followOdometry(const StandardInformation& information, Instant now) {
  const Counts counts{information.xMm, information.yMm};
  const Vector2 here = type_.distance * Vector2(counts.x, counts.y);
  if (resetUntil_ && now > *resetUntil_) resetUntil_.reset();
  const bool isReset = resetUntil_ && here.norm() <= kNearOrigin;
  if (!last_ || isReset) {
    state_.pose.x = here.x();
    state_.pose.y = here.y();
  } else {
    state_.pose.x += type_.distance * difference(counts.x, last_->x);
    state_.pose.y += type_.distance * difference(counts.y, last_->y);
  }
  state_.pose.heading = normalizedAngle(type_.angle * information.heading4096);
  last_ = counts;
}

Pose2 StateDecoder::odometryAt(int xMm, int yMm, double heading) const {
  if (!last_) return {type_.distance * xMm, type_.distance * yMm, normalizedAngle(heading)};
  return {state_.pose.x + type_.distance * difference(xMm, last_->x),
          state_.pose.y + type_.distance * difference(yMm, last_->y), normalizedAngle(heading)};
}

void StateDecoder::takeSonars(const StandardInformation& information, Instant now) {
  for (const StandardInformation::Sonar& sonar : information.sonars) {
    // A sonar of an array that this type of robot does not have.
    if (sonar.number >= state_.sonars.size()) continue;
    SonarReading& reading = state_.sonars[sonar.number];
    reading.range = std::min(type_.range * sonar.rangeMm, type_.sonarMaximum);
    reading.echo = reading.range < type_.sonarMaximum;
    reading.time = now;
    reading.robot = state_.pose;
  }
}

void StateDecoder::take(const StandardInformation& information, Instant now) {
  followOdometry(information, now);
  takeSonars(information, now);
  RobotState& s = state_;
  s.time = now;
  s.leftSpeed = type_.speed * information.leftSpeedMmS;
  s.rightSpeed = type_.speed * information.rightSpeedMmS;
  s.speed = (s.leftSpeed + s.rightSpeed) / 2;
  s.rotation = information.rotationRateDeciDegS ? radians(*information.rotationRateDeciDegS / 10.0)
                                                : (s.rightSpeed - s.leftSpeed) / type_.track;
  s.moving = information.moving || information.leftSpeedMmS != 0 || information.rightSpeedMmS != 0;
  s.motorsOn = information.motorsOn();
  s.sonarOn = information.sonarOn();
  s.emergencyStop = (information.flags & StandardInformation::kEmergencyStop) != 0;
  s.leftStalled = information.leftStalled();
  s.rightStalled = information.rightStalled();
  s.frontBumpers = static_cast<std::uint8_t>(information.frontBumpers());
  s.rearBumpers = static_cast<std::uint8_t>(information.rearBumpers());
  s.battery = information.batteryDecivoltsBest() / 10.0;
  const int charge = information.stateOfChargePercent.value_or(0);
  s.stateOfCharge = charge > 0 ? std::optional(charge / 100.0) : std::nullopt;
  const int charging = information.chargeState.value_or(255);
  s.charging = charging != 255 ? std::optional(charging != 0) : std::nullopt;
  const int temperature = information.temperatureDegC.value_or(StandardInformation::kNoTemperature);
  s.temperature =
      temperature > StandardInformation::kNoTemperature ? std::optional<double>(temperature) : std::nullopt;
  s.gripper.reset();
  if (information.gripState) s.gripper = gripperState(*information.gripState);
  s.digitalIn = information.digitalIn.value_or(0);
  s.digitalOut = information.digitalOut.value_or(0);
  s.analogIn = information.analog.value_or(0);
  s.flags = information.flags;
  s.faultFlags = information.faultFlags.value_or(0);
}

}  // namespace robotlink::arcos
