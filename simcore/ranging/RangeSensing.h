// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "simcore/rendering/RayCaster.h"
#include "simcore/world/RangeSensor.h"

namespace simcore {

/// Works out what sonars and lasers measure, with noise that depends on seed, sensor and step only: it does
/// not matter how often, or whether, readings are asked for. One thread at a time.
class RangeSensing {
 public:
  /// `own[i]` are the bodies of the robot that sensors[i] is on, which it does not see. `sensors` must
  /// outlive it.
  RangeSensing(const std::shared_ptr<const RenderScene>& scene, const std::vector<RangeSensor>& sensors,
               std::vector<RayCaster::BodyRange> own);

  /// Where the bodies are now, by body index of the scene.
  void setPoses(std::span<const Pose3> bodyInWorld);

  struct Noise {
    bool on = true;
    std::uint64_t seed = 0;
    std::uint64_t step = 0;
  };
  /// Writes the readings of a sensor; ranges.size() is their number.
  void measure(std::size_t sensor, const Noise& noise, std::span<double> ranges);

 private:
  double nearestEcho(const RangeSensor& sensor) const;

  const std::vector<RangeSensor>& sensors_;
  std::vector<RayCaster::BodyRange> own_;
  std::vector<RayFan> fans_;
  std::vector<std::size_t> fanOf_;  // sensors alike share a fan
  RayCaster caster_;
  std::span<const Pose3> poses_;
  std::vector<FanHit> hits_;
};

}  // namespace simcore
