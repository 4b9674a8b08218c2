// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "widgets/ports/PortSubscription.h"
#include "widgets/scene/SceneMarkers.h"

namespace robotcontrol {
class PortReadings;
}

namespace widgets {

/// The sensors of a simulated scene as bodies: what cameras see as a pyramid, sonars as a cone, lasers and
/// distance sensors as rays that end, with a point, at what they hit; contacts as a sphere that is red while
/// something touches, other sensors as a small box. Readings are requested while they are shown, of at most
/// kMaxRead sensors. GUI thread.
class SensorMarkers {
 public:
  static constexpr std::size_t kMaxRead = 200;

  /// The sensors that are shown, at the shown instant.
  std::vector<SceneBody> bodies(robotlink::Session& session, const SceneObjects& objects,
                                const SceneState& scene, robotlink::Instant shown,
                                const ObjectFilter& isShown);
  /// Makes all shapes again, since the sensors may be others.
  void clear() { markers_.clear(); }

 private:
  struct Marker {
    std::vector<double> values;
    std::shared_ptr<const SceneShape> shape;
    bool used = true;
  };

  std::map<std::string, Marker> markers_;
  PortSubscription subscription_;
};

/// The shape of a sensor in its own frame, x ahead; `values` are its readings, empty: not known.
SceneShape sensorShape(const robotcontrol::WorldObject& sensor, const std::vector<double>& values);

}  // namespace widgets
