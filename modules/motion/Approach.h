// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace modules {

/// A value that follows a target, but changes by `change` at most (not negative). All three in the same unit.
inline double approached(double value, double target, double change) {
  return value + std::clamp(target - value, -change, change);
}

}  // namespace modules
