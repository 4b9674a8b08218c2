// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/RangePackages.h"

#include <algorithm>
#include <cmath>

#include "foxglove/Ranging.pb.h"
#include "modules/FinitePose.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/packages/Conversions.h"

namespace modules {

using robotlink::Pose2;

namespace {

constexpr int kMaxReadings = 256, kMaxRays = 4096;
// The range of a Pioneer's sonars, used if a message does not contain it.
constexpr double kSonarMaximum = 5;

}  // namespace

std::vector<RangeBeam> beams(const robotcontrol::SonarReadings& sonar) {
  std::vector<RangeBeam> result;
  const double maximum = sonar.maximum() > 0 ? sonar.maximum() : kSonarMaximum;
  const double opening = std::clamp(sonar.opening_angle(), robotlink::radians(1), robotlink::kPi);
  const int count = std::min(kMaxReadings, sonar.readings_size());
  for (int i = 0; i < count; ++i) {
    const robotcontrol::SonarReadings::Reading& reading = sonar.readings(i);
    const Pose2 sensor = robotlink::pose2(reading.sensor_in_robot());
    if (!(reading.range() > 0) || !isFinite(sensor)) continue;
    const auto& time = reading.has_timestamp() ? reading.timestamp() : sonar.timestamp();
    result.push_back(
        {sensor, std::min(reading.range(), maximum), maximum, opening, robotlink::instant(time)});
  }
  return result;
}

std::vector<RangeBeam> beams(const foxglove::LaserScan& laser, double maximum) {
  std::vector<RangeBeam> result;
  const int count = std::min(kMaxRays, laser.ranges_size());
  const Pose2 sensor = robotlink::groundPose(robotlink::pose3(laser.pose()));
  const double step = count > 1 ? (laser.end_angle() - laser.start_angle()) / (laser.ranges_size() - 1) : 0;
  if (!isFinite(sensor) || !std::isfinite(laser.start_angle()) || !std::isfinite(step)) return result;
  const robotlink::Instant time = robotlink::instant(laser.timestamp());
  for (int i = 0; i < count; ++i) {
    const double range = laser.ranges(i);
    const bool hit = range > 0 && range < maximum;
    result.push_back(
        {sensor * Pose2{0, 0, laser.start_angle() + i * step}, hit ? range : maximum, maximum, 0, time});
  }
  return result;
}

}  // namespace modules
