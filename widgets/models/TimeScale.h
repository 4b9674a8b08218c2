// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "robotlink/base/Clock.h"

namespace widgets {

/// Which time lies where on a horizontal axis in pixels. A plain value.
struct TimeScale {
  double left = 0;  ///< x of `from`
  robotlink::Instant from{};
  double nsPerPixel = 1e6;

  double x(robotlink::Instant time) const;
  robotlink::Instant time(double x) const;
  /// What lies at `x` stays there.
  void zoomAt(double x, double factor);
};

/// Where an axis has its marks.
struct AxisMarks {
  robotlink::Duration step{};  ///< 1, 2 or 5 times a power of ten of seconds
  robotlink::Instant first{};  ///< the first mark not before the scale's beginning
};
/// Marks at least `spacing` pixels apart, counted from `origin`.
AxisMarks axisMarks(const TimeScale& scale, double spacing, robotlink::Instant origin);

/// "12.340": seconds, with as many digits as the resolution needs.
QString timeText(robotlink::Duration time, robotlink::Duration resolution = std::chrono::milliseconds(1));
/// What a person types: "12.5", "12.5 s", "1:02.5" (minutes) or "1:02:03"; "+1.5" and "-1.5" count from
/// `now`.
std::optional<robotlink::Duration> timeFromText(const QString& text, robotlink::Duration now);

}  // namespace widgets
