// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modules/perception/BodyPosture.h"
#include "robotlink/base/Geometry.h"

namespace modules {

/// Combines the tilt that follows from the legs with the direction of gravity that the accelerometer shows,
/// by a complementary filter (Mahony, Hamel, Pflimlin 2008, without gyroscopes): fast changes are those of
/// the legs, what remains in the long run is the accelerometer's, which steps only shake. The height stays
/// that of the legs. A plain value; not thread-safe.
class BodyTiltFilter {
 public:
  struct Options {
    /// The time after which the accelerometer has mostly replaced the legs, s.
    double timeConstant = 6;
    /// Accelerations whose length is farther from gravity, as a fraction of it, are ignored.
    double maximumJolt = 0.12;
  };

  /// Call it once a frame. `legs` is the tilt by the legs; `acceleration` in m/s^2 in the body's frame, at
  /// rest and level (0, 0, 9.81); `seconds` since the last call.
  BodyTilt update(const BodyTilt& legs, const std::optional<robotlink::Vector3>& acceleration, double seconds,
                  const Options& options);

  /// Pitch and roll of a body at rest with this acceleration; height 0.
  static BodyTilt tiltOf(const robotlink::Vector3& acceleration);

 private:
  std::optional<BodyTilt> legs_;
  BodyTilt tilt_;
};

}  // namespace modules
