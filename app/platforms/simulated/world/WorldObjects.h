// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class WorldObjects;
}
namespace simcore {
class Simulation;
}

namespace app {

class ExternalControllers;

/// Returns the message of the stream "objects": all models of a simulated world with their links, joints,
/// shapes and solids, all its ports, and its lights. Models with more than kMaxShapes shapes and solids, such
/// as maps of buildings, are listed without them. Controllers have the views that they add below them;
/// `external` are the remote ones, if there are any.
std::shared_ptr<const robotcontrol::WorldObjects> worldObjects(const simcore::Simulation& simulation,
                                                               const ExternalControllers* external = nullptr,
                                                               std::optional<robotlink::Instant> at = {});
inline constexpr std::size_t kMaxShapes = 500;

}  // namespace app
