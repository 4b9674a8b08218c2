// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace simcore {

/// A body that touches something other than a floor.
struct ObstacleTouch {
  std::size_t body = 0;
  /// The model that it touches, by its index.
  int other = 0;
};

}  // namespace simcore
