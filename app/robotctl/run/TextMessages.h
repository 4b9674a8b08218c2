// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "robotlink/base/Clock.h"

namespace robotlink {
struct GroundMap;
struct SharedDebugQueue;
}  // namespace robotlink

namespace app {

/// Prints a text with its time and source to stderr, on one line.
void printText(robotlink::Instant time, const std::string& source, const std::string& text);
/// Prints the text messages of a debug queue to stderr, one per line, with their times.
void printTexts(const std::string& robot, const robotlink::SharedDebugQueue& queue);
/// Prints the notes about a map to stderr, one per line. Null: prints nothing.
void printMapNotes(const robotlink::GroundMap* map);

}  // namespace app
