// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotlink {
class StreamStore;
struct RobotDescription;
}  // namespace robotlink

namespace widgets {

/// What is around a robot on wheels at an instant, as its sonars, laser and bumpers tell: in the robot's
/// frame of that instant, metres and radians. A plain value.
struct RadarReadings {
  struct Echo {
    int number = 0;                  ///< of the sonar
    robotlink::Pose2 sensorInRobot;  ///< where it was when it fired: moved with the odometry since then
    double range = 0;
    bool nothing = false;  ///< there was no echo up to the greatest range
    bool newest = false;   ///< of this sonar
    double age = 0;        ///< s
  };
  std::vector<Echo> echoes;  ///< oldest first
  double openingAngle = 0;
  double sonarMaximum = 0;

  std::vector<robotlink::Vector2> laser;  ///< what its beams hit
  std::vector<robotlink::Vector2>
      laserFree;  ///< outline of what they crossed, from the laser's place and back to it
  robotlink::Vector2 laserInRobot = robotlink::Vector2::Zero();
  bool hasLaser = false;

  robotlink::Vector2 body = robotlink::Vector2(0.5, 0.4);  ///< length and width
  std::vector<bool> frontBumpers,
      rearBumpers;  ///< pressed; from left to right, the front up; empty: it has none
  bool leftStalled = false, rightStalled = false, emergencyStop = false;
  double speed = 0, rotation = 0;          ///< m/s, rad/s
  double heading = 0;                      ///< where it looks, as its odometry says
  std::optional<robotlink::Instant> time;  ///< of what is newest; unset: nothing is told
  /// s since its base said anything: all of this is as old. Unset: it speaks.
  std::optional<double> silence;

  /// The nearest echo of the newest ones and of the laser; unset: nothing is near.
  std::optional<double> nearestSonar() const;
  std::optional<double> nearestLaser() const;
};

/// `description` may be null. `memory`: how old an echo may be.
RadarReadings radarReadings(const robotlink::StreamStore& store, const std::string& robot,
                            const robotlink::RobotDescription* description, robotlink::Instant shown,
                            robotlink::Duration memory);

}  // namespace widgets
