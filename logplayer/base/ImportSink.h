// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// Receives the messages of a frame, which are in the order of time, as are frames.
using ImportSink = std::function<robotlink::Result<void>(std::vector<robotlink::StreamMessage>)>;

}  // namespace logplayer
