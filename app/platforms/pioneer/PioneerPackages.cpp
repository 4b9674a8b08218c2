// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerPackages.h"

#include <cmath>

#include "robotlink/packages/Conversions.h"

namespace app {
namespace {

using robotlink::arcos::RobotState;
using robotlink::arcos::StandardInformation;

// The largest plausible motion between two packets, m and rad. With a larger one the robot's client has set
// the odometry, which is no motion.
constexpr double kMaxStep = 1.0;
constexpr double kMaxTurn = robotlink::radians(90.0);

robotcontrol::DriveState::Charging chargingOf(const RobotState& state) {
  using robotcontrol::DriveState;
  if (!state.charging) return DriveState::UNKNOWN;
  return *state.charging ? DriveState::CHARGING : DriveState::NOT_CHARGING;
}

}  // namespace

PioneerPackages::PioneerPackages(std::string robot, const robotlink::RobotDescription& description)
    : robot_(std::move(robot)), description_(description) {}

void PioneerPackages::restart() {
  last_.reset();
}

void PioneerPackages::setBumpers(int front, int rear) {
  frontBumpers_ = front;
  rearBumpers_ = rear;
}

void PioneerPackages::setBattery(double low, double empty) {
  batteryLow_ = low;
  batteryEmpty_ = empty;
}

void PioneerPackages::resetOdometry() {
  odometry_ = {};
}

void PioneerPackages::followOdometry(const robotlink::Pose2& now) {
  if (last_) {
    const robotlink::Pose2 step = last_->inverse() * now;
    if (step.translation().norm() <= kMaxStep && std::abs(step.heading) <= kMaxTurn)
      odometry_ = odometry_ * step;
  }
  last_ = now;
}

std::shared_ptr<const robotcontrol::DriveState> PioneerPackages::state(const RobotState& said,
                                                                       const StandardInformation& information,
                                                                       robotlink::Instant now) {
  followOdometry(said.pose);
  auto state = std::make_shared<robotcontrol::DriveState>();
  robotlink::assign(*state->mutable_timestamp(), now);
  robotlink::assign(*state->mutable_odometry(), odometry_);
  state->set_left_speed(said.leftSpeed);
  state->set_right_speed(said.rightSpeed);
  state->mutable_velocity()->set_x(said.speed);
  state->mutable_velocity()->set_rotation(said.rotation);
  state->set_motors_on(said.motorsOn);
  state->set_sonar_on(said.sonarOn);
  state->set_left_stalled(said.leftStalled);
  state->set_right_stalled(said.rightStalled);
  state->set_emergency_stop(said.emergencyStop);
  for (int i = 0; i < frontBumpers_; ++i) state->add_front_bumpers((said.frontBumpers >> i & 1) != 0);
  for (int i = 0; i < rearBumpers_; ++i) state->add_rear_bumpers((said.rearBumpers >> i & 1) != 0);
  state->set_battery(said.battery);
  if (batteryLow_ > 0) state->set_battery_low(batteryLow_);
  if (batteryEmpty_ > 0) state->set_battery_empty(batteryEmpty_);
  if (said.stateOfCharge) state->set_state_of_charge(*said.stateOfCharge);
  state->set_charging(chargingOf(said));
  if (said.temperature) state->set_temperature(*said.temperature);
  state->set_digital_in(said.digitalIn);
  state->set_digital_out(said.digitalOut);
  state->set_analog_in(said.analogIn);
  state->set_fault_flags(said.faultFlags);
  if (information.rotationRateDeciDegS)
    state->set_rotation_rate(robotlink::radians(*information.rotationRateDeciDegS / 10.0));
  return state;
}

std::shared_ptr<const robotcontrol::SonarReadings> PioneerPackages::sonars(
    const StandardInformation& information, double unit, robotlink::Instant now) const {
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
    reading.set_range(std::min(unit * sonar.rangeMm, description_.sonars->maximum));
    robotlink::assign(*reading.mutable_timestamp(), now);
  }
  return readings;
}

std::shared_ptr<const foxglove::LaserScan> PioneerPackages::laser(
    const robotlink::arcos::RangeScan& seen) const {
  if (!description_.laser) return nullptr;
  auto scan = std::make_shared<foxglove::LaserScan>();
  robotlink::assign(*scan->mutable_timestamp(), seen.time);
  scan->set_frame_id(robot_);
  const auto& laser = *description_.laser;
  robotlink::Pose3 pose = robotlink::Pose3::Identity();
  pose.translate(robotlink::Vector3(laser.inRobot.x, laser.inRobot.y, 0));
  pose.rotate(Eigen::AngleAxisd(laser.inRobot.heading, robotlink::Vector3::UnitZ()));
  robotlink::assign(*scan->mutable_pose(), pose);
  scan->set_start_angle(laser.startAngle);
  scan->set_end_angle(laser.endAngle);
  scan->mutable_ranges()->Add(seen.ranges.begin(), seen.ranges.end());
  return scan;
}

}  // namespace app
