// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/RadarReadings.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "foxglove/Ranging.pb.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/StreamStore.h"
#include "widgets/BaseSilence.h"

namespace widgets {
namespace {

using robotlink::Instant;
using robotlink::Pose2;
using robotlink::StreamStore;
using robotlink::Vector2;

constexpr double kLaserMaximum = 32;  // m, if there is no description
constexpr robotlink::Duration kLaserMemory = std::chrono::seconds(2);
constexpr int kMaxReadings = 20'000;  // of one message: what is beyond is no laser's

std::string pathOf(const std::string& robot, const char* package) {
  return robot + '/' + package;
}

std::optional<Pose2> odometryAt(const StreamStore& store, const std::string& robot, Instant time) {
  const auto* state =
      store.latestAs<robotcontrol::DriveState>(pathOf(robot, robotlink::kDriveState.name), time);
  if (state == nullptr) return {};
  return robotlink::pose2(state->odometry());
}

void addState(RadarReadings& readings, const robotcontrol::DriveState& state) {
  readings.frontBumpers.assign(state.front_bumpers().begin(), state.front_bumpers().end());
  readings.rearBumpers.assign(state.rear_bumpers().begin(), state.rear_bumpers().end());
  readings.leftStalled = state.left_stalled();
  readings.rightStalled = state.right_stalled();
  readings.emergencyStop = state.emergency_stop();
  readings.speed = state.velocity().x();
  readings.rotation = state.velocity().rotation();
  readings.heading = state.odometry().heading();
}

/// The time of a reading: its own timestamp if that is plausible, else the message's.
Instant timeOf(const robotcontrol::SonarReadings::Reading& reading, Instant message) {
  if (!reading.has_timestamp()) return message;
  const Instant own = robotlink::instant(reading.timestamp());
  return own > message || message - own > std::chrono::seconds(1) ? message : own;
}

void addSonar(RadarReadings& readings, const StreamStore& store, const std::string& robot, Instant shown,
              robotlink::Duration memory) {
  const auto* stream = store.find(pathOf(robot, robotlink::kSonar.name));
  if (stream == nullptr) return;
  const auto now = odometryAt(store, robot, shown);
  std::set<int> seen;
  const auto after = std::ranges::upper_bound(stream->messages, shown, {}, &robotlink::StreamMessage::time);
  for (auto at = std::make_reverse_iterator(after); at != stream->messages.rend(); ++at) {
    const auto& message = *at;
    if (shown - message.time > memory) break;
    const auto* sonar = dynamic_cast<const robotcontrol::SonarReadings*>(message.value.get());
    if (sonar == nullptr) continue;
    if (readings.openingAngle == 0) {
      readings.openingAngle = sonar->opening_angle();
      readings.sonarMaximum = sonar->maximum();
      readings.time = std::max(readings.time.value_or(message.time), message.time);
    }
    for (auto of = sonar->readings().rbegin(); of != sonar->readings().rend(); ++of) {
      const auto& reading = *of;
      if (!(reading.range() > 0) || !std::isfinite(reading.range())) continue;
      const Instant fired = timeOf(reading, message.time);
      RadarReadings::Echo echo;
      echo.number = static_cast<int>(reading.number());
      echo.sensorInRobot = robotlink::pose2(reading.sensor_in_robot());
      echo.range = reading.range();
      echo.nothing = sonar->maximum() > 0 && reading.range() >= sonar->maximum();
      echo.newest = seen.insert(echo.number).second;
      echo.age = std::max(0.0, robotlink::seconds(shown - fired));
      const auto then = odometryAt(store, robot, fired);
      if (now && then) echo.sensorInRobot = now->inverse() * *then * echo.sensorInRobot;
      readings.echoes.push_back(echo);
    }
  }
  std::reverse(readings.echoes.begin(), readings.echoes.end());
}

void addLaser(RadarReadings& readings, const foxglove::LaserScan& scan, double maximum) {
  const Pose2 laser = robotlink::groundPose(robotlink::pose3(scan.pose()));
  readings.laserInRobot = laser.translation();
  readings.hasLaser = true;
  const int count = std::min(scan.ranges_size(), kMaxReadings);
  const double step = count > 1 ? (scan.end_angle() - scan.start_angle()) / (count - 1) : 0;
  readings.laserFree.push_back(laser.translation());
  for (int i = 0; i < count; ++i) {
    const double angle = scan.start_angle() + i * step, range = scan.ranges(i);
    const bool hit = range > 0 && range < maximum;
    const double reach = hit ? range : maximum;
    const Vector2 at = laser * Vector2(reach * std::cos(angle), reach * std::sin(angle));
    if (!std::isfinite(at.x()) || !std::isfinite(at.y())) continue;
    if (hit) readings.laser.push_back(at);
    readings.laserFree.push_back(at);
  }
}

}  // namespace

std::optional<double> RadarReadings::nearestSonar() const {
  std::optional<double> nearest;
  for (const Echo& echo : echoes) {
    if (echo.newest && !echo.nothing && echo.range < nearest.value_or(1e300)) nearest = echo.range;
  }
  return nearest;
}

std::optional<double> RadarReadings::nearestLaser() const {
  std::optional<double> nearest;
  for (const Vector2& hit : laser) nearest = std::min(nearest.value_or(1e300), (hit - laserInRobot).norm());
  return nearest;
}

RadarReadings radarReadings(const StreamStore& store, const std::string& robot,
                            const robotlink::RobotDescription* description, Instant shown,
                            robotlink::Duration memory) {
  RadarReadings readings;
  if (description != nullptr && description->drive)
    readings.body = {description->drive->length, description->drive->width};
  if (const auto* message = store.latest(pathOf(robot, robotlink::kDriveState.name), shown)) {
    readings.time = message->time;
    if (const auto* state = dynamic_cast<const robotcontrol::DriveState*>(message->value.get()))
      addState(readings, *state);
  }
  readings.silence = baseSilence(store, robot, shown);
  addSonar(readings, store, robot, shown, memory);
  if (readings.openingAngle == 0 && description != nullptr && description->sonars) {
    readings.openingAngle = description->sonars->openingAngle;
    readings.sonarMaximum = description->sonars->maximum;
  }
  const auto* laser = store.latest(pathOf(robot, robotlink::kLaser.name), shown);
  if (laser != nullptr && shown - laser->time <= kLaserMemory) {
    readings.time = std::max(readings.time.value_or(laser->time), laser->time);
    const double maximum =
        description != nullptr && description->laser ? description->laser->maximum : kLaserMaximum;
    if (const auto* scan = dynamic_cast<const foxglove::LaserScan*>(laser->value.get()))
      addLaser(readings, *scan, maximum);
  }
  return readings;
}

}  // namespace widgets
