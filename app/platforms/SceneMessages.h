// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"

namespace foxglove {
class FrameTransforms;
class SceneUpdate;
}  // namespace foxglove
namespace robotcontrol {
class GroundMap;
class WorldForces;
}  // namespace robotcontrol
namespace robotlink {
struct GroundMap;
}
namespace simcore {
class Simulation;
struct ModelParts;
}  // namespace simcore

namespace app {

/// Returns the message of the stream "scene": the shapes of a simulated world, one entity for each visual, in
/// the frame of its body. Its time is `at`, by default that of the simulation. Entities name their objects in
/// their metadata ("object": the path in the stream "objects"), and those of a model that can be moved name
/// that ("model").
std::shared_ptr<const foxglove::SceneUpdate> sceneMessage(const simcore::Simulation& simulation,
                                                          std::optional<robotlink::Instant> at = {});

/// Returns the message of the stream "solids": what collides in a simulated world, one entity for each solid,
/// in the frame of its body, with the path of its object in its metadata ("object"). Planes are as large as
/// the file says, though they collide everywhere.
std::shared_ptr<const foxglove::SceneUpdate> solidsMessage(const simcore::Simulation& simulation,
                                                           std::optional<robotlink::Instant> at = {});

/// The shapes of a robot's model, one entity for each link, in the link's frame.
std::shared_ptr<const foxglove::SceneUpdate> modelMessage(const simcore::ModelParts& model);

/// Returns the message of the stream "transforms": the poses of all bodies in the field's frame, and for each
/// robot a frame of its name on the ground below it. Its time is `at`, by default that of the simulation.
std::shared_ptr<const foxglove::FrameTransforms> transformsMessage(const simcore::Simulation& simulation,
                                                                   std::optional<robotlink::Instant> at = {});

/// Returns the message of the stream "map".
std::shared_ptr<const robotcontrol::GroundMap> mapMessage(const robotlink::GroundMap& map,
                                                          robotlink::Instant now);

/// Returns the message of the stream "forces": the contacts, joints and hands of the last step.
std::shared_ptr<const robotcontrol::WorldForces> forcesMessage(const simcore::Simulation& simulation,
                                                               robotlink::Instant at);

/// The names of the models that the user may move: robots and balls first; not what is fixed to the world.
std::vector<std::string> movableModels(const simcore::Simulation& simulation);

}  // namespace app
