// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace logplayer {

/// Called from time to time while something long is done, with the share done in [0, 1]. Returns false to
/// give up.
using Progress = std::function<bool(double)>;

}  // namespace logplayer
