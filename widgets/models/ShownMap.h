// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace robotcontrol {
class GroundMap;
}
namespace robotlink {
class Session;
}

namespace widgets {

/// The map of the instant that is shown; null if the world has none. It is told once, at the start: where the
/// history no longer reaches back to it, the oldest one that is there counts.
std::shared_ptr<const robotcontrol::GroundMap> shownMap(robotlink::Session& session);

}  // namespace widgets
