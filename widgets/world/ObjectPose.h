// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "robotlink/base/Geometry.h"

namespace robotcontrol {
class Request;
class WorldObject;
}  // namespace robotcontrol
namespace robotlink {
class Session;
}

namespace widgets {

class SceneState;

/// The pose of an object in the field's frame: x, y, z in m, then roll, pitch and heading in rad, which turn
/// about x first, then about y, then about z, as SDFormat has it.
using ObjectPose = std::array<double, 6>;
ObjectPose objectPose(const robotlink::Pose3& pose);

/// The object of a path in the stream "objects"; null: there is none. Valid until the session's next tick.
const robotcontrol::WorldObject* worldObject(robotlink::Session& session, const std::string& path);
/// The pose of an object in the field; unset: it has none, or its frame is not known.
std::optional<robotlink::Pose3> worldPose(const robotcontrol::WorldObject& object, const SceneState& scene);
/// Asks to place a model, as it is tilted, too.
robotcontrol::Request placeRequest(const std::string& model, const robotlink::Pose3& pose);

}  // namespace widgets
