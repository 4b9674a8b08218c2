// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "modules/driving/Outline.h"
#include "modules/driving/RangeMemory.h"
#include "modules/navigation/OdometryHistory.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/debugging/Solution.h"

namespace modules {

/// The outline of a robot with a drive; the default if the description has none.
Outline outlineOf(const robotlink::RobotDescription& robot);
/// Missing values are those of a Pioneer 3-AT.
DriveLimits limitsOf(const robotlink::RobotDescription& robot);

/// The knowledge of a driving solution about its surroundings, from the packages drive/state, range/sonar and
/// range/laser; the solution must declare that it uses them. Pressed bumpers and stalled wheels count as
/// obstacles, too. One thread, that of the solution's process.
class DriveSensing {
 public:
  explicit DriveSensing(robotlink::SolutionContext& context);

  /// Call it once a frame. `requested` is the last requested speed, m/s; it tells which end of the robot
  /// stalls.
  void update(double requested);
  /// Whether there are odometry and readings not older than a second, so that driving is safe.
  bool awake() const { return awake_; }
  /// A sentence that says what is missing, for when awake() is false.
  std::string whyNot() const;
  /// Obstacles in the robot's frame, m.
  const std::vector<robotlink::Vector2>& points() const { return points_; }
  /// The latest pose by odometry; the origin before the first one.
  robotlink::Pose2 robotInOdometry() const { return odometry_.latest().value_or(robotlink::Pose2{}); }
  const OdometryHistory& odometry() const { return odometry_; }
  /// The velocity as measured by the wheels.
  DriveVelocity velocity() const;
  bool emergencyStop() const { return drive_ && drive_->emergency_stop(); }
  /// The time of the platform's clock, s.
  double time() const { return robotlink::seconds(clock_.now()); }

 private:
  /// Adds obstacles where bumpers are pressed or the robot stalls.
  void feelBumpers(double requested);

  const robotlink::Clock& clock_;
  robotlink::Input<robotcontrol::DriveState> drive_;
  robotlink::Input<robotcontrol::SonarReadings> sonar_;
  robotlink::Input<foxglove::LaserScan> laser_;
  Outline outline_;
  /// The range of the laser, m.
  double laserMaximum_;
  OdometryHistory odometry_;
  RangeMemory memory_{{}};
  std::vector<robotlink::Vector2> points_;
  /// The state computed by update().
  bool awake_ = false;
};

}  // namespace modules
