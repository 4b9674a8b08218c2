// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFontMetricsF>
#include <QRectF>
#include <QSize>
#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "widgets/log/TimeScale.h"
#include "widgets/timing/GanttFrames.h"

class QPainter;
class QPalette;

// Layout and painting of a Gantt chart of processes. Pure functions.
namespace widgets {

/// All that the picture depends on; pixels.
struct GanttLook {
  QSize size;
  /// The axis; its left end is the right edge of the gutter with the names.
  TimeScale scale;
  /// The instant that is shown as 0 s, and the one that the timeline shows.
  robotlink::Instant origin, shown;
  std::vector<GanttLane> lanes;
  /// Tasks in the order in which colors were given to them.
  std::vector<std::string> tasks;
};

/// The object at a place: a frame of a lane and, if `task` is not negative, one of its tasks.
struct GanttHit {
  std::size_t lane = 0, frame = 0;
  int task = -1;
  bool operator==(const GanttHit&) const = default;
};

/// A lane is not lower than this, nor higher than that.
inline constexpr int kMinGanttLane = 30, kMaxGanttLane = 64;
inline constexpr int kGanttRuler = 20;

/// The width of the gutter that the names and rates of the lanes need.
int ganttGutter(const GanttLook& look, const QFontMetricsF& font);
QRectF ganttLaneRect(const GanttLook& look, std::size_t lane);
/// The bar of a frame, at least a pixel wide; and that of one of its tasks, below.
QRectF ganttBar(const GanttLook& look, const GanttHit& of);
std::optional<GanttHit> ganttHit(const GanttLook& look, const QPointF& at);
/// The tooltip about it: names, begin, how long, which share of the period, whether it overruns.
QString ganttText(const GanttLook& look, const GanttHit& of);
void paintGantt(QPainter& painter, const GanttLook& look, const QPalette& palette);

}  // namespace widgets
