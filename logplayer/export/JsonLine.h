// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Error.h"
#include "robotlink/session/StreamMessage.h"

namespace logplayer {

/// A message as one JSON object on a line of its own, with its line break: "stream", "log_time" in s,
/// "process" and "frame" where they are known, "type", and the "message" as Protocol Buffers write it, with
/// its fields' own names. Fails if it has none, for example because of a time after the year 9999.
robotlink::Result<std::string> jsonLine(const robotlink::StreamMessage& message);

}  // namespace logplayer
