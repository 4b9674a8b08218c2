// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "robotlink/base/Clock.h"
#include "widgets/log/LogModel.h"

namespace widgets {

/// An instant, or a stretch of time, that is marked, on the timeline.
struct TimeMark {
  robotlink::Instant from, to;
  QString text;
  LogEntry::Level level = LogEntry::Level::kInfo;
  bool operator==(const TimeMark&) const = default;
};

}  // namespace widgets
