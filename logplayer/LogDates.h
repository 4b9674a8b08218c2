// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "robotlink/base/Clock.h"

namespace logplayer {

// Times of logs that count from 1970, as those of real robots do, are dates for people; those of simulations
// are not.

/// Whether a time lies in this century, so that it is a date.
bool isDate(robotlink::Instant time);

/// "2026-05-04 12:30:01.250 UTC".
std::string dateText(robotlink::Instant time);

/// A date in UTC: "2026-05-04", "2026-05-04 12:30", "2026-05-04T12:30:01.25Z"; nothing if the text is none.
std::optional<robotlink::Instant> instantOfDate(std::string_view text);

}  // namespace logplayer
