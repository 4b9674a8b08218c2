// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"

namespace foxglove {
class FrameTransforms;
class SceneUpdate;
}  // namespace foxglove
namespace robotcontrol {
class GroundMap;
}
namespace robotlink {
struct GroundMap;
}
namespace simcore {
class Simulation;
}

namespace app {

/// The stream "scene": the shapes of a simulated world, one entity a visual, each in the frame of its body.
/// What belongs to a model that can be moved names it in its metadata ("model").
std::shared_ptr<const foxglove::SceneUpdate> sceneMessage(const simcore::Simulation& simulation);

/// The stream "transforms": where all bodies are in the field, and for each robot the frame of its name on
/// the ground below it.
std::shared_ptr<const foxglove::FrameTransforms> transformsMessage(const simcore::Simulation& simulation);

/// The stream "map".
std::shared_ptr<const robotcontrol::GroundMap> mapMessage(const robotlink::GroundMap& map,
                                                          robotlink::Instant now);

/// Models that a person may move: the robots, and the ball.
std::vector<std::string> movableModels(const simcore::Simulation& simulation);

}  // namespace app
