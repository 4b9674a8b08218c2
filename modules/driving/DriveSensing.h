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

Outline outlineOf(const robotlink::RobotDescription& robot);
/// What the description leaves out is that of a Pioneer 3-AT.
DriveLimits limitsOf(const robotlink::RobotDescription& robot);

/// What a solution that drives knows of what is around the robot, from the packages drive/state, range/sonar
/// and range/laser; one that uses it must say that it uses these. A bumper that is pressed, or a wheel that
/// stalls, is an obstacle, too.
class DriveSensing {
 public:
  explicit DriveSensing(robotlink::SolutionContext& context);

  /// Once a frame; `requested`: m/s, what the robot was told last, to know which end of it stalls.
  void update(double requested);
  /// Neither blind nor without odometry: there are readings that are not older than a second.
  bool awake() const { return awake_; }
  /// A sentence that says what is missing; not while it is awake.
  std::string whyNot() const;
  /// Obstacles in the robot's frame.
  const std::vector<robotlink::Vector2>& points() const { return points_; }
  robotlink::Pose2 robotInOdometry() const { return odometry_.latest().value_or(robotlink::Pose2{}); }
  const OdometryHistory& odometry() const { return odometry_; }
  DriveVelocity velocity() const;
  bool emergencyStop() const { return drive_ && drive_->emergency_stop(); }
  double time() const { return robotlink::seconds(clock_.now()); }

 private:
  void feelBumpers(double requested);

  const robotlink::Clock& clock_;
  robotlink::Input<robotcontrol::DriveState> drive_;
  robotlink::Input<robotcontrol::SonarReadings> sonar_;
  robotlink::Input<foxglove::LaserScan> laser_;
  Outline outline_;
  double laserMaximum_;
  OdometryHistory odometry_;
  RangeMemory memory_{{}};
  std::vector<robotlink::Vector2> points_;
  bool awake_ = false;
};

}  // namespace modules
