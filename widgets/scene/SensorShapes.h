// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Clock.h"
#include "widgets/scene/render/SceneMesh.h"

namespace robotlink {
class StreamStore;
struct RobotDescription;
}  // namespace robotlink

namespace widgets {

/// Returns lines for a robot's camera frustum, as a pyramid half a meter long, and for what its distance
/// sensor, sonars and laser measure, as a line each, in its frame on the ground. `description` may be null.
/// GUI thread.
SceneLines sensorLines(const robotlink::StreamStore& store, const std::string& robot,
                       const robotlink::RobotDescription* description, robotlink::Instant shown);

/// Whether two sets of lines look alike.
bool areSame(const SceneLines& a, const SceneLines& b);

}  // namespace widgets
