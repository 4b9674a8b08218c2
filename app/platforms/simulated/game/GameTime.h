// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"
#include "simcore/world/StateStream.h"

namespace app {

/// Writes or reads how long something has lasted, which is not negative.
inline void transferTime(simcore::StateStream& stream, robotlink::Duration& time) {
  std::int64_t count = time.count();
  stream.raw(count);
  stream.require(count >= 0);
  if (stream.good()) time = robotlink::Duration(count);
}

}  // namespace app
