// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/process/Link.h"
#include "widgets/scene/SceneMarkers.h"

namespace robotcontrol {
class WorldForces;
}
namespace robotlink {
class Session;
}

namespace widgets {

/// The contacts and forces in a simulated world, from the stream "forces", as one body in the field's frame:
/// of each contact a point, and the force on the first object as an orange arrow; what joints exert in blue,
/// what is applied by hand in green, with a line to where a hand pulls. Arrows are kMetersPerNewton long, but
/// at most kMaxArrow. The simulation is asked to publish the forces while they are shown. GUI thread.
class ForceMarkers {
 public:
  static constexpr double kMetersPerNewton = 0.01, kMaxArrow = 1;
  /// The maximum number of contacts and joints shown.
  static constexpr int kMaxForces = 5000;

  /// Call this in each tick in which they are shown. `revision` differs when `isShown` may.
  std::vector<SceneBody> bodies(robotlink::Session& session, robotlink::Instant shown, int revision,
                                const ObjectFilter& isShown);

 private:
  /// Asks for the forces every kAskEvery ticks.
  void keepReading(robotlink::Session& session);

  static constexpr int kAskEvery = 60;
  int untilAsked_ = 0;
  /// The message and the shape made of it, which is remade only for another message.
  robotlink::PackagePtr message_;
  int revision_ = -1;
  std::shared_ptr<const SceneShape> shape_;
};

/// Contacts between objects that are both hidden are left out, as are forces on hidden ones.
SceneShape forcesShape(const robotcontrol::WorldForces& forces, const ObjectFilter& isShown);

}  // namespace widgets
