// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/PioneerPackages.h"

#include <cmath>

#include "robotlink/packages/Conversions.h"

namespace app {
namespace {

using robotlink::arcos::LaserPacket;
using robotlink::arcos::StandardInformation;

constexpr double kMetre = 1000;         // mm
constexpr double kTurn = 4096;          // units of the heading
// More between two packets is no way that it has gone: its client has set the robot's odometry.
constexpr double kMostStep = 1.0;  // m
constexpr double kMostTurn = robotlink::radians(90.0);

double headingOf(std::int16_t units) { return units * (2 * robotlink::kPi / kTurn); }

/// How far a counter of 16 bits that wraps has gone.
int difference(std::int16_t now, std::int16_t before) { return static_cast<std::int16_t>(now - before); }

robotcontrol::DriveState::Charging chargingOf(const StandardInformation& information) {
  using robotcontrol::DriveState;
  if (!information.chargeState || *information.chargeState == 255) return DriveState::UNKNOWN;
  return *information.chargeState == 0 ? DriveState::NOT_CHARGING : DriveState::CHARGING;
}

}  // namespace

void PioneerPackages::setBumpers(int front, int rear) {
  frontBumpers_ = front;
  rearBumpers_ = rear;
}

void PioneerPackages::resetOdometry() { odometry_ = {}; }

void PioneerPackages::follow(const StandardInformation& information) {
  const Raw now{information.xMm, information.yMm, information.heading4096};
  if (last_) {
    // Steps are turned from the robot's own frame into the one that this counting began in.
    const double turned = odometry_.heading - headingOf(last_->heading);
    const robotlink::Vector2 step =
        robotlink::Pose2{0, 0, turned} *
        robotlink::Vector2(difference(now.x, last_->x) / kMetre, difference(now.y, last_->y) / kMetre);
    const double turn = robotlink::normalizedAngle(headingOf(now.heading) - headingOf(last_->heading));
    if (step.norm() <= kMostStep && std::abs(turn) <= kMostTurn) {
      odometry_.x += step.x();
      odometry_.y += step.y();
      odometry_.heading = robotlink::normalizedAngle(odometry_.heading + turn);
    }
  }
  last_ = now;
}

std::shared_ptr<const robotcontrol::DriveState> PioneerPackages::state(const StandardInformation& information,
                                                                       robotlink::Instant now) {
  follow(information);
  auto state = std::make_shared<robotcontrol::DriveState>();
  robotlink::assign(*state->mutable_timestamp(), now);
  robotlink::assign(*state->mutable_odometry(), odometry_);
  const double left = information.leftSpeedMmS / kMetre, right = information.rightSpeedMmS / kMetre;
  state->set_left_speed(left);
  state->set_right_speed(right);
  state->mutable_velocity()->set_x((left + right) / 2);
  const double track = description_.drive ? description_.drive->track : 1;
  state->mutable_velocity()->set_rotation((right - left) / track);
  state->set_motors_on(information.motorsOn());
  state->set_sonar_on(information.sonarOn());
  state->set_left_stalled(information.leftStalled());
  state->set_right_stalled(information.rightStalled());
  state->set_emergency_stop((information.flags & StandardInformation::kEmergencyStop) != 0);
  for (int i = 0; i < frontBumpers_; ++i) state->add_front_bumpers((information.frontBumpers() >> i & 1U) != 0);
  for (int i = 0; i < rearBumpers_; ++i) state->add_rear_bumpers((information.rearBumpers() >> i & 1U) != 0);
  state->set_battery(information.batteryDecivoltsBest() / 10.0);
  if (information.stateOfChargePercent.value_or(0) > 0) state->set_state_of_charge(*information.stateOfChargePercent / 100.0);
  state->set_charging(chargingOf(information));
  if (information.temperatureDegC.value_or(-128) > StandardInformation::kNoTemperature) {
    state->set_temperature(*information.temperatureDegC);
  }
  state->set_digital_in(information.digitalIn.value_or(0));
  state->set_digital_out(information.digitalOut.value_or(0));
  state->set_analog_in(information.analog.value_or(0));
  state->set_fault_flags(information.faultFlags.value_or(0));
  if (information.rotationRateDeciDegS) state->set_rotation_rate(robotlink::radians(*information.rotationRateDeciDegS / 10.0));
  return state;
}

std::shared_ptr<const robotcontrol::SonarReadings> PioneerPackages::sonars(const StandardInformation& information,
                                                                           robotlink::Instant now) const {
  if (information.sonars.empty() || !description_.sonars) return nullptr;
  auto readings = std::make_shared<robotcontrol::SonarReadings>();
  robotlink::assign(*readings->mutable_timestamp(), now);
  readings->set_opening_angle(description_.sonars->openingAngle);
  readings->set_maximum(description_.sonars->maximum);
  for (const auto& sonar : information.sonars) {
    if (sonar.number >= description_.sonars->sensors.size()) continue;
    auto& reading = *readings->add_readings();
    reading.set_number(sonar.number);
    robotlink::assign(*reading.mutable_sensor_in_robot(), description_.sonars->sensors[sonar.number].inRobot);
    reading.set_range(std::min(sonar.rangeMm / kMetre, description_.sonars->maximum));
    robotlink::assign(*reading.mutable_timestamp(), now);
  }
  return readings;
}

std::shared_ptr<const foxglove::LaserScan> PioneerPackages::laser(const LaserPacket& part, robotlink::Instant now) {
  const auto whole = assembler_.take(part, nullptr, now);
  if (!whole || !description_.laser) return nullptr;
  auto scan = std::make_shared<foxglove::LaserScan>();
  robotlink::assign(*scan->mutable_timestamp(), whole->takenAt);
  scan->set_frame_id(robot_);
  const auto& laser = *description_.laser;
  robotlink::Pose3 pose = robotlink::Pose3::Identity();
  pose.translate(robotlink::Vector3(laser.inRobot.x, laser.inRobot.y, 0));
  pose.rotate(Eigen::AngleAxisd(laser.inRobot.heading, robotlink::Vector3::UnitZ()));
  robotlink::assign(*scan->mutable_pose(), pose);
  scan->set_start_angle(laser.startAngle);
  scan->set_end_angle(laser.endAngle);
  for (const std::uint16_t rangeMm : whole->rangesMm) scan->add_ranges(rangeMm / kMetre);
  return scan;
}

}  // namespace app
