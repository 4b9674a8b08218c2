// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "robotcontrol/Debugging.pb.h"

// Modes of debug keys in words, as commands and presets have them.
namespace robotlink {

/// Parses "off", "always", "n 3" (times), "every 3" (frames) or "every-ms 40"; empty if it is none of these.
std::optional<robotcontrol::KeyMode> keyModeOf(const std::string& words);
std::string inWords(const robotcontrol::KeyMode& mode);

}  // namespace robotlink
