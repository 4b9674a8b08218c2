// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace robotlink {
class Session;
}

namespace widgets {

/// From when to when values of live robots are only on disk, and a series lacks them that begins at `begin`
/// and is computed of all these streams. Seconds on the session's timeline; unset: there are none. GUI
/// thread.
std::optional<std::pair<double, double>> valuesOnDisk(robotlink::Session& session,
                                                      const std::vector<std::string>& streams, double begin);

}  // namespace widgets
