// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace robotcontrol {
class DebugQueue;
}

namespace app {

/// Prints the text messages of a debug queue on stderr, one a line, with their times.
void printTexts(const std::string& robot, const robotcontrol::DebugQueue& queue);

}  // namespace app
