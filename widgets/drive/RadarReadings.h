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

/// The surroundings of a robot on wheels at an instant, by its sonars, laser and bumpers. Coordinates are in
/// the robot's frame at that instant (x forward, y to the left), in meters and radians. A plain value.
struct RadarReadings {
  /// A reading of a sonar.
  struct Echo {
    /// Number of the sonar.
    int number = 0;
    /// Pose of the sonar when it fired, moved by the odometry since then.
    robotlink::Pose2 sensorInRobot;
    /// m, along the sonar's x axis.
    double range = 0;
    /// Whether there is no echo up to the maximum range.
    bool nothing = false;
    /// The newest reading of this sonar.
    bool newest = false;
    /// Seconds before the shown instant.
    double age = 0;
  };
  /// Oldest first.
  std::vector<Echo> echoes;
  /// Field of view of a sonar; 0: unknown.
  double openingAngle = 0;
  /// Maximum range of the sonars, m; 0: unknown.
  double sonarMaximum = 0;

  /// The points that the laser's beams hit.
  std::vector<robotlink::Vector2> laser;
  /// Outline of the free area that the beams crossed, beginning at the laser's position.
  std::vector<robotlink::Vector2> laserFree;
  /// Position of the laser.
  robotlink::Vector2 laserInRobot = robotlink::Vector2::Zero();
  /// Whether there is a scan that is not older than two seconds.
  bool hasLaser = false;

  /// Length and width of the robot, m.
  robotlink::Vector2 body = robotlink::Vector2(0.5, 0.4);
  /// Pressed bumpers from left to right, seen with the robot's front up; empty: the robot has none.
  std::vector<bool> frontBumpers, rearBumpers;
  /// Stalled motors, and whether the emergency stop is pressed.
  bool leftStalled = false, rightStalled = false, emergencyStop = false;
  double speed = 0, rotation = 0;          ///< m/s, rad/s
  double heading = 0;                      ///< where it looks, as its odometry says
  std::optional<robotlink::Instant> time;  ///< of the newest reading; unset: there is none
  /// s since its base said anything: all of this is as old. Unset: it speaks.
  std::optional<double> silence;

  /// Range of the nearest of each sonar's newest echoes, m; unset: no echo.
  std::optional<double> nearestSonar() const;
  /// Distance of the nearest hit from the laser, m; unset: no hit.
  std::optional<double> nearestLaser() const;
};

/// Collects the readings from the session's history. `description` may be null; `memory` is the maximum age
/// of an echo.
RadarReadings radarReadings(const robotlink::StreamStore& store, const std::string& robot,
                            const robotlink::RobotDescription* description, robotlink::Instant shown,
                            robotlink::Duration memory);

}  // namespace widgets
