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

/// The map at the shown instant; null if the world has none. The map is published once, at the start; if the
/// history no longer reaches back to it, the oldest one that is kept counts.
std::shared_ptr<const robotcontrol::GroundMap> shownMap(robotlink::Session& session);

}  // namespace widgets
