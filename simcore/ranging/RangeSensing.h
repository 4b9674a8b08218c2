// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/noise/NoiseProcess.h"
#include "simcore/rendering/RayCaster.h"
#include "simcore/world/RangeSensor.h"

namespace simcore {

class StateStream;

/// Computes the ranges of sonars and lasers. The noise depends only on seed, sensor and step, so it does not
/// matter how often, or whether, readings are requested. One thread at a time, but measure() may be called in
/// several threads, for different sensors.
class RangeSensing {
 public:
  /// `own[i]` are the bodies of the robot that carries sensors[i], which the sensor does not see. `sensors`
  /// must outlive it.
  RangeSensing(const std::shared_ptr<const RenderScene>& scene, const std::vector<RangeSensor>& sensors,
               std::vector<RayCaster::BodyRange> own);

  /// Sets the present poses of the bodies, by body index of the scene. They must stay valid until the last
  /// measure().
  void setPoses(std::span<const Pose3> bodyInWorld);

  using Noise = NoiseSelection;
  /// Replaces the noise of a sensor from this step on, and applies it even where noise is off.
  void setErrors(std::size_t sensor, const SensorErrors& errors, const Noise& noise);
  /// Writes or reads the errors of all sensors and what has drifted; `noise` is that of the present step.
  void transfer(StateStream& stream, const Noise& noise);
  /// Writes the readings of a sensor at the poses that were set, m; ranges.size() must be their number.
  void measure(std::size_t sensor, const Noise& noise, std::span<double> ranges);

 private:
  /// The reading of a sonar from the hits of its rays.
  static double nearestEcho(const RangeSensor& sensor, std::span<const FanHit> hits);

  const std::vector<RangeSensor>& sensors_;
  std::vector<RayCaster::BodyRange> own_;
  std::vector<RayFan> fans_;
  /// Index in fans_; identical sensors share a fan.
  std::vector<std::size_t> fanOf_;
  /// The noise of each sensor, and whether a user chose its errors, instead of the scene.
  std::vector<NoiseProcess> noise_;
  std::vector<bool> chosen_;
  RayCaster caster_;
  std::span<const Pose3> poses_;
};

}  // namespace simcore
