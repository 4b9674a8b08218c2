// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/session/StreamMessage.h"

namespace foxglove {
class Log;
}  // namespace foxglove

namespace logplayer {

/// Formats a text for people, with its time, level and source, and a line end. Further lines are indented,
/// control characters replaced.
std::string textLine(const robotlink::StreamMessage& message, const foxglove::Log& text);

}  // namespace logplayer
