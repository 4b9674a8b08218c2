// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/modules/OneSolution.h"
#include "tests/modules/driving/RollingRobot.h"

namespace modules {

inline robotcontrol::DriveState driveState(const RollingRobot& robot) {
  robotcontrol::DriveState state;
  robotlink::assign(*state.mutable_timestamp(), robot.now());
  robotlink::assign(*state.mutable_odometry(), robot.odometry());
  state.mutable_velocity()->set_x(robot.velocity().forward);
  state.mutable_velocity()->set_rotation(robot.velocity().rotation);
  state.set_motors_on(true);
  return state;
}

inline robotcontrol::SonarReadings sonarReadings(const RollingRobot& robot) {
  robotcontrol::SonarReadings sonar;
  robotlink::assign(*sonar.mutable_timestamp(), robot.now());
  sonar.set_maximum(robot.description().sonars->maximum);
  sonar.set_opening_angle(robot.description().sonars->openingAngle);
  for (const RangeBeam& beam : robot.beams()) {
    if (beam.openingAngle <= 0) continue;
    auto& reading = *sonar.add_readings();
    robotlink::assign(*reading.mutable_sensor_in_robot(), beam.sensorInRobot);
    robotlink::assign(*reading.mutable_timestamp(), beam.time);
    reading.set_range(beam.range);
  }
  return sonar;
}

inline foxglove::LaserScan laserScan(const RollingRobot& robot) {
  const auto& laser = *robot.description().laser;
  foxglove::LaserScan scan;
  robotlink::assign(*scan.mutable_timestamp(), robot.now());
  robotlink::assign(*scan.mutable_pose(),
                    robotlink::Pose3(Eigen::Translation3d(laser.inRobot.x, laser.inRobot.y, 0.3)));
  scan.set_start_angle(laser.startAngle);
  scan.set_end_angle(laser.endAngle);
  for (const RangeBeam& beam : robot.beams())
    if (beam.openingAngle <= 0) scan.add_ranges(beam.hit() ? beam.range : 0);
  return scan;
}

/// Sets the inputs that a platform would send now.
inline void sense(OneSolution& solution, const RollingRobot& robot, bool laser) {
  solution.set(robotlink::kDriveState, driveState(robot));
  solution.set(robotlink::kSonar, sonarReadings(robot));
  if (laser) solution.set(robotlink::kLaser, laserScan(robot));
}

}  // namespace modules
