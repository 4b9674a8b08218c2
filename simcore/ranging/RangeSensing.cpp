// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/ranging/RangeSensing.h"

#include <algorithm>
#include <cmath>

#include "simcore/physics/Step.h"
#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

// The rays of a sonar's cone of 30 degrees are 1.5 degrees apart, so that the leg of a table is not missed at
// a distance at which a robot avoids it.
constexpr double kEchoRaysApart = robotlink::radians(1.5);
constexpr int kFewestEchoRays = 3, kMaxEchoRays = 121;

/// Separates these random numbers from those of other sensors.
constexpr std::uint64_t kRangeStream = 0x72616E6765;

RayFan fanOf(const RangeSensor& sensor) {
  if (sensor.kind == RangeSensor::Kind::kLaser) return {sensor.startAngle, sensor.endAngle, sensor.readings};
  const double half = sensor.openingAngle / 2;
  const int wanted = static_cast<int>(std::lround(sensor.openingAngle / kEchoRaysApart)) + 1;
  // An odd number, so that one ray is the axis.
  return {-half, half, std::clamp(wanted, kFewestEchoRays, kMaxEchoRays) | 1};
}

bool isSame(const RayFan& a, const RayFan& b) {
  return a.size() == b.size() && a.start() == b.start() && a.step() == b.step();
}

}  // namespace

RangeSensing::RangeSensing(const std::shared_ptr<const RenderScene>& scene,
                           const std::vector<RangeSensor>& sensors, std::vector<RayCaster::BodyRange> own)
    : sensors_(sensors), own_(std::move(own)), chosen_(sensors.size()), caster_(scene) {
  for (const RangeSensor& sensor : sensors_) {
    RayFan fan = fanOf(sensor);
    const auto found = std::ranges::find_if(fans_, [&](const RayFan& other) { return isSame(fan, other); });
    fanOf_.push_back(static_cast<std::size_t>(found - fans_.begin()));
    if (found == fans_.end()) fans_.push_back(std::move(fan));
    noise_.emplace_back(NoiseProcess::Stream{kRangeStream, noise_.size()}, 1, kStepSeconds,
                        sensor.errors.noise);
  }
}

void RangeSensing::setPoses(std::span<const Pose3> bodyInWorld) {
  poses_ = bodyInWorld;
  caster_.setPoses(bodyInWorld);
}

double RangeSensing::nearestEcho(const RangeSensor& sensor, std::span<const FanHit> hits) {
  double nearest = sensor.maximum;
  const double leastCosine = std::max(0.0, std::cos(sensor.mostIncidence) - 1e-9);
  for (const FanHit& hit : hits) {
    if (hit.distance < nearest && hit.cosIncidence >= leastCosine) nearest = hit.distance;
  }
  return nearest;
}

void RangeSensing::measure(std::size_t index, const Noise& noise, std::span<double> ranges) {
  const RangeSensor& sensor = sensors_[index];
  const RayFan& fan = fans_[fanOf_[index]];
  std::vector<FanHit> hits(fan.size());
  const Pose3 pose = poses_[static_cast<std::size_t>(sensor.body)] * sensor.sensorInBody;
  caster_.castFan(fan, pose, sensor.maximum, own_[index], hits);
  if (sensor.kind == RangeSensor::Kind::kSonar) {
    ranges[0] = nearestEcho(sensor, hits);
  } else {
    std::ranges::transform(hits, ranges.begin(), &FanHit::distance);
  }
  if (noise.on || chosen_[index]) {
    // No noise is added where there is no echo.
    noise_[index].apply(noise.seed, noise.step, ranges.data(), ranges.size(),
                        [&](double range) { return range < sensor.maximum; });
  }
  for (double& range : ranges) range = std::clamp(range, sensor.minimum, sensor.maximum);
}

void RangeSensing::transfer(StateStream& stream, const Noise& noise) {
  for (NoiseProcess& process : noise_) process.transfer(stream, noise.seed, noise.step);
  stream.bits(chosen_);
}

void RangeSensing::setErrors(std::size_t sensor, const SensorErrors& errors, const Noise& noise) {
  noise_[sensor].change(errors.noise, noise.seed, noise.step);
  chosen_[sensor] = true;
}

}  // namespace simcore
