// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class WorldObjects;
}
namespace simcore {
class Simulation;
struct CameraSensor;
}  // namespace simcore

namespace app {

/// Returns the message of the stream "objects": all models of a simulated world with their links, joints,
/// shapes and solids, all its ports, and its lights. Models with more than kMaxShapes shapes and solids, such
/// as maps of buildings, are listed without them.
std::shared_ptr<const robotcontrol::WorldObjects> worldObjects(const simcore::Simulation& simulation,
                                                               std::optional<robotlink::Instant> at = {});
inline constexpr std::size_t kMaxShapes = 500;

/// Whether a camera's robot sends its images.
bool isSentByRobot(const simcore::Simulation& simulation, const simcore::CameraSensor& camera);
/// The stream that has a camera's images: that of its robot, or, where the robot sends none, that of the
/// port.
std::string imageStreamOf(const simcore::Simulation& simulation, const simcore::CameraSensor& camera);

}  // namespace app
