// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "robotlink/base/Clock.h"

namespace logplayer {

// Logs of real robots have times since 1970, which users see as dates; those of simulations start near 0.

/// Whether a time lies in this century and is therefore a date.
bool isDate(robotlink::Instant time);

/// Formats a time as "2026-05-04 12:30:01.250 UTC".
std::string dateText(robotlink::Instant time);
/// Formats a time as its date, or as "12.500 s" if it is none.
std::string dateOrSeconds(robotlink::Instant time);

/// Parses a date in UTC: "2026-05-04", "2026-05-04 12:30", "2026-05-04T12:30:01.25Z"; empty if the text is
/// none.
std::optional<robotlink::Instant> instantOfDate(std::string_view text);

}  // namespace logplayer
