// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/DriveSensing.h"

#include <cmath>

#include "foxglove/Ranging.pb.h"
#include "modules/FinitePose.h"
#include "modules/navigation/RangePackages.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

using robotlink::Instant;
using robotlink::Pose2;
using robotlink::Vector2;

namespace {

// Readings older than this are not sufficient for driving, s.
constexpr double kOutdated = 1.0;
// The distance in front of the outline at which a contact is stored, m.
constexpr double kTouch = 0.01;

}  // namespace

Outline outlineOf(const robotlink::RobotDescription& robot) {
  Outline outline;
  if (robot.drive && robot.drive->length > 0) outline.halfLength = 0.5 * robot.drive->length;
  if (robot.drive && robot.drive->width > 0) outline.halfWidth = 0.5 * robot.drive->width;
  return outline;
}

DriveLimits limitsOf(const robotlink::RobotDescription& robot) {
  DriveLimits limits;
  if (!robot.drive) return limits;
  const auto take = [](double& limit, double described) {
    if (described > 0) limit = described;
  };
  take(limits.speed, robot.drive->maximumSpeed);
  take(limits.rotation, robot.drive->maximumRotation);
  take(limits.acceleration, robot.drive->acceleration);
  take(limits.rotationAcceleration, robot.drive->rotationAcceleration);
  return limits;
}

DriveSensing::DriveSensing(robotlink::SolutionContext& context)
    : clock_(context.clock()),
      drive_(context.input(robotlink::kDriveState)),
      sonar_(context.input(robotlink::kSonar)),
      laser_(context.input(robotlink::kLaser)),
      outline_(outlineOf(context.robot().description)),
      laserMaximum_(context.robot().description.laser ? context.robot().description.laser->maximum : 32) {}

void DriveSensing::update(double requested) {
  const Instant now = clock_.now();
  if (drive_ && drive_.isNew()) {
    const Pose2 robot = robotlink::pose2(drive_->odometry());
    if (isFinite(robot) && !odometry_.add(robotlink::instant(drive_->timestamp()), robot)) memory_.clear();
    feelBumpers(requested);
  }
  // Rays first, because they explain echoes of cones.
  if (laser_ && laser_.isNew()) memory_.see(beams(*laser_, laserMaximum_), odometry_);
  if (sonar_ && sonar_.isNew()) memory_.see(beams(*sonar_), odometry_);
  memory_.forget(now, robotInOdometry());
  points_ = memory_.pointsInRobot(robotInOdometry());
  const bool seeing = memory_.newest() && std::abs(robotlink::seconds(now - *memory_.newest())) < kOutdated;
  const bool moving =
      drive_ && std::abs(robotlink::seconds(now - robotlink::instant(drive_->timestamp()))) < kOutdated;
  awake_ = seeing && moving && !odometry_.empty();
}

std::string DriveSensing::whyNot() const {
  if (!drive_ || odometry_.empty()) return "the robot has not reported its odometry yet";
  if (!memory_.newest()) return "neither sonars nor laser have sent readings yet: are they switched on?";
  return "sonars, laser or odometry have reported nothing for a second";
}

/// Segments are numbered from left to right at either end.
void DriveSensing::feelBumpers(double requested) {
  const Pose2 robot = robotInOdometry();
  const Instant now = clock_.now();
  const auto feel = [&](const auto& bumpers, double x) {
    for (int i = 0; i < bumpers.size(); ++i) {
      const double y = outline_.halfWidth * (1 - (2 * i + 1.0) / bumpers.size());
      if (bumpers.Get(i)) memory_.touch(Vector2(x, y), robot, now);
    }
  };
  const double end = outline_.halfLength + kTouch;
  feel(drive_->front_bumpers(), end);
  feel(drive_->rear_bumpers(), -end);
  const double pushed = requested >= 0 ? end : -end;
  if (drive_->left_stalled()) memory_.touch(Vector2(pushed, outline_.halfWidth), robot, now);
  if (drive_->right_stalled()) memory_.touch(Vector2(pushed, -outline_.halfWidth), robot, now);
}

DriveVelocity DriveSensing::velocity() const {
  if (!drive_) return {};
  const DriveVelocity velocity{drive_->velocity().x(), drive_->velocity().rotation()};
  return std::isfinite(velocity.forward) && std::isfinite(velocity.rotation) ? velocity : DriveVelocity{};
}

}  // namespace modules
