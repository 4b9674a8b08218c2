// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/modules/driving/RollingRobot.h"

#include <algorithm>
#include <stdexcept>

namespace modules {

using robotlink::Pose2;

namespace {

constexpr double kTick = 0.02;
constexpr int kTicksPerCycle = 5, kTicksPerSonar = 2;

}  // namespace

RollingRobot::RollingRobot(const FlatWorld& world, const Options& options)
    : world_(world), options_(options), random_(options.seed, 77), pose_(options.start) {
  auto description = robotlink::readRobotDescription(ROBOTCONTROL_SOURCE_DIR "/resources/robots/p3at.yaml");
  if (!description) throw std::runtime_error(robotlink::describe(description.error()));
  description_ = *description;
  turnError_ = 1 + options.skid * random_.normal();
  wayError_ = 1 + options.skid * random_.normal();
  fireSonars();
  scan();
}

DriveLimits RollingRobot::limits() const {
  const auto& drive = *description_.drive;
  return {drive.maximumSpeed, drive.maximumRotation, drive.acceleration, drive.rotationAcceleration};
}

Outline RollingRobot::outline() const {
  return {0.5 * description_.drive->length, 0.5 * description_.drive->width};
}

void RollingRobot::drive(const DriveVelocity& request) {
  beams_.clear();
  const DriveLimits can = limits();
  const auto approach = [](double from, double to, double step) {
    return from + std::clamp(to - from, -step, step);
  };
  for (int i = 0; i < kTicksPerCycle; ++i) {
    velocity_.forward = approach(velocity_.forward, std::clamp(request.forward, -can.speed, can.speed),
                                 can.acceleration * kTick);
    velocity_.rotation =
        approach(velocity_.rotation, std::clamp(request.rotation, -can.rotation, can.rotation),
                 can.rotationAcceleration * kTick);
    now_ += robotlink::fromSeconds(kTick);
    const double turn = velocity_.rotation * kTick, way = velocity_.forward * kTick;
    odometry_ = odometry_ * Pose2{way, 0, turn};
    const double skid = options_.skid * random_.normal();
    const Pose2 next = pose_ * Pose2{way * wayError_, 0, turn * (turnError_ + 2 * skid) + 0.5 * skid * way};
    const double distance = world_.distance(outline(), next);
    nearest_ = std::min(nearest_, distance);
    if (distance > 0) {
      pose_ = next;
      way_ += std::abs(way);
    } else {
      velocity_ = {};
    }
    if (++ticks_ % kTicksPerSonar == 0) fireSonars();
  }
  scan();
}

/// One of each array, in turn.
void RollingRobot::fireSonars() {
  const auto& sonars = *description_.sonars;
  for (std::size_t sonar = fired_ % 8; sonar < sonars.sensors.size(); sonar += 8) {
    const Pose2 inRobot = sonars.sensors[sonar].inRobot;
    const double range = world_.cone(pose_ * inRobot, sonars.openingAngle, sonars.maximum);
    const double noisy = range < sonars.maximum ? std::max(0.02, range + 0.01 * random_.normal()) : range;
    beams_.push_back({inRobot, std::min(noisy, sonars.maximum), sonars.maximum, sonars.openingAngle, now_});
  }
  ++fired_;
}

void RollingRobot::scan() {
  if (!options_.laser) return;
  const auto& laser = *description_.laser;
  for (int i = 0; i < laser.readings; ++i) {
    const double angle = laser.startAngle + (laser.endAngle - laser.startAngle) * i / (laser.readings - 1);
    const Pose2 inRobot = laser.inRobot * Pose2{0, 0, angle};
    const double range = world_.ray(pose_ * inRobot, laser.maximum);
    const double noisy = range < laser.maximum ? std::max(0.02, range + 0.005 * random_.normal()) : range;
    beams_.push_back({inRobot, std::min(noisy, laser.maximum), laser.maximum, 0, now_});
  }
}

}  // namespace modules
