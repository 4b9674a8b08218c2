// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <string>

#include "robotlink/base/Clock.h"

namespace robotlink {
struct GroundMap;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

/// Prints a text with its time and source, on one line.
void printText(std::ostream& out, robotlink::Instant time, const std::string& source,
               const std::string& text);
/// Prints the text messages of a debug queue, one per line, with their times.
void printTexts(std::ostream& out, const std::string& robot, const robotlink::SharedDebugQueue& queue);
/// Prints the notes about a map, one per line. Null: prints nothing.
void printMapNotes(std::ostream& out, const robotlink::GroundMap* map);

}  // namespace app
