// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Clock.h"

namespace robotcontrol {
class DebugQueue;
}
namespace robotlink {
struct GroundMap;
}

namespace app {

/// Prints one line on stderr: what was said when, and by whom.
void printText(robotlink::Instant time, const std::string& source, const std::string& text);
/// Prints the text messages of a debug queue on stderr, one a line, with their times.
void printTexts(const std::string& robot, const robotcontrol::DebugQueue& queue);
/// Prints what is to be known about a map that was read, one note a line, on stderr. Null: nothing.
void printMapNotes(const robotlink::GroundMap* map);

}  // namespace app
