// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "robotlink/base/Clock.h"

namespace widgets {

/// A linear mapping of times to a horizontal axis in pixels. A plain value.
struct TimeScale {
  /// x of `from`.
  double left = 0;
  /// Time at the left end.
  robotlink::Instant from{};
  /// The zoom; zoomAt() keeps it between 1 us and about twelve days per pixel.
  double nsPerPixel = 1e6;

  double x(robotlink::Instant time) const;
  robotlink::Instant time(double x) const;
  /// Zooms in by `factor` (above 1); the time at `x` stays there.
  void zoomAt(double x, double factor);
};

/// The marks of an axis.
struct AxisMarks {
  /// Distance of the marks: 1, 2 or 5 times a power of ten of seconds.
  robotlink::Duration step{};
  /// The first mark not before the scale's left end.
  robotlink::Instant first{};
};
/// Marks at least `spacing` pixels apart, at multiples of the step from `origin`.
AxisMarks axisMarks(const TimeScale& scale, double spacing, robotlink::Instant origin);

/// "12.340": seconds, with as many digits as `resolution` needs (at most 9).
QString timeText(robotlink::Duration time, robotlink::Duration resolution = std::chrono::milliseconds(1));
/// Parses what the user typed: "12.5", "12.5 s", "1:02.5" (minutes) or "1:02:03"; "+1.5" and "-1.5" are
/// relative to `now`. A comma counts as a point. Unset if it is no time.
std::optional<robotlink::Duration> timeFromText(const QString& text, robotlink::Duration now);

}  // namespace widgets
