// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/GanttPaint.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "robotcontrol/Debugging.pb.h"
#include "widgets/Theme.h"

namespace widgets {
namespace {

using robotlink::Instant;

constexpr double kGanttMargin = 6;
/// The share of a lane's height that its frames have; the rest is for their tasks.
constexpr double kFrameShare = 0.4;
constexpr double kMinLabelled = 24;  // pixels; narrower bars have no text

struct GanttTexts {
  Q_DECLARE_TR_FUNCTIONS(Gantt)
};

QString millisecondsText(double seconds) {
  return GanttTexts::tr("%1 ms").arg(seconds * 1000, 0, 'f', seconds < 0.1 ? 3 : 1);
}

double widthOf(const GanttLook& look, double seconds) {
  return seconds * 1e9 / look.scale.nsPerPixel;
}

/// Returns the duration of the tasks before one of them, s, without the entry of the whole frame.
double secondsBefore(const GanttFrame& frame, int task) {
  double before = 0;
  for (int i = 0; i < task; ++i) {
    const auto& entry = frame.times->entries(i);
    if (!entry.task().empty()) before += entry.seconds();
  }
  return before;
}

/// "25.0 Hz, 2 overruns"
QString rateText(const GanttLane& lane) {
  const QString rate = lane.rate > 0 ? GanttTexts::tr("%1 Hz").arg(lane.rate, 0, 'f', 1) : QString();
  if (lane.overruns == 0) return rate;
  return GanttTexts::tr("%1, over: %2").arg(rate).arg(lane.overruns);
}

/// The arguments of the functions below.
struct GanttSheet {
  QPainter& painter;
  const GanttLook& look;
  const QPalette& palette;

  QColor base() const { return palette.color(QPalette::Base); }
  QColor text() const { return palette.color(QPalette::Text); }
  QColor line() const { return mixed(base(), text(), 0.14); }
  QColor muted() const { return colorOf(Meaning::kMuted, palette); }
  QColor bad() const { return colorOf(Meaning::kBad, palette); }
  QColor colorOfTask(const std::string& task) const {
    const auto found = std::ranges::find(look.tasks, task);
    return curveColor(static_cast<int>(found - look.tasks.begin()), palette);
  }
  void label(const QRectF& bar, const QString& text) const {
    if (bar.width() < kMinLabelled) return;
    painter.setPen(palette.color(QPalette::Text));
    const QRectF room = bar.adjusted(3, 0, -2, 0);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(room.width())));
  }
};

void paintGanttRuler(const GanttSheet& sheet) {
  QPainter& painter = sheet.painter;
  const GanttLook& look = sheet.look;
  painter.fillRect(QRectF(0, 0, look.size.width(), kGanttRuler), sheet.palette.color(QPalette::Window));
  const double label = painter.fontMetrics().horizontalAdvance(QStringLiteral("0000.0000")) + 16;
  const AxisMarks marks = axisMarks(look.scale, label, look.origin);
  for (Instant time = marks.first; look.scale.x(time) < look.size.width(); time += marks.step) {
    const double x = std::round(look.scale.x(time)) + 0.5;
    painter.setPen(sheet.line());
    painter.drawLine(QPointF(x, kGanttRuler), QPointF(x, look.size.height()));
    painter.setPen(sheet.palette.color(QPalette::WindowText));
    painter.drawText(QRectF(x + 3, 0, label, kGanttRuler), Qt::AlignLeft | Qt::AlignVCenter,
                     timeText(time - look.origin, marks.step));
  }
  painter.setPen(sheet.muted());
  painter.drawText(QRectF(kGanttMargin, 0, look.scale.left - 2 * kGanttMargin, kGanttRuler),
                   Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("s"));
}

void paintGanttFrame(const GanttSheet& sheet, const GanttHit& of) {
  QPainter& painter = sheet.painter;
  const GanttFrame& frame = sheet.look.lanes[of.lane].frames[of.frame];
  const QRectF bar = ganttBar(sheet.look, of);
  painter.fillRect(bar, mixed(sheet.base(), sheet.text(), 0.32));
  if (frame.overruns()) {
    // The part beyond the period is in another color and hatched.
    QRectF beyond = bar;
    beyond.setLeft(std::min(bar.left() + widthOf(sheet.look, frame.period), bar.right() - 3));
    painter.fillRect(beyond, mixed(sheet.base(), sheet.bad(), 0.75));
    painter.fillRect(beyond, QBrush(sheet.base(), Qt::BDiagPattern));
    painter.setPen(sheet.bad());
    painter.drawLine(bar.topLeft(), bar.topRight());
  }
  sheet.label(bar, millisecondsText(frame.seconds));
}

void paintGanttTasks(const GanttSheet& sheet, GanttHit of) {
  const auto& entries = sheet.look.lanes[of.lane].frames[of.frame].times->entries();
  for (of.task = 0; of.task < entries.size(); ++of.task) {
    const auto& entry = entries[of.task];
    if (entry.task().empty()) continue;
    const QRectF bar = ganttBar(sheet.look, of);
    sheet.painter.fillRect(bar, mixed(sheet.base(), sheet.colorOfTask(entry.task()), 0.6));
    sheet.label(bar, QString::fromStdString(entry.task()));
  }
}

void paintGanttLane(const GanttSheet& sheet, std::size_t lane) {
  QPainter& painter = sheet.painter;
  const QRectF rect = ganttLaneRect(sheet.look, lane);
  const auto& frames = sheet.look.lanes[lane].frames;
  painter.setClipRect(rect.adjusted(sheet.look.scale.left, 0, 0, 0));
  // If many frames share a pixel, only one is painted, and all that overrun.
  double painted = -1e9;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const QRectF bar = ganttBar(sheet.look, {lane, i, -1});
    if (bar.right() < painted + 1 && !frames[i].overruns()) continue;
    painted = bar.right();
    paintGanttFrame(sheet, {lane, i, -1});
    paintGanttTasks(sheet, {lane, i, -1});
  }
  painter.setClipping(false);
}

void paintGanttName(const GanttSheet& sheet, std::size_t lane) {
  QPainter& painter = sheet.painter;
  const GanttLane& of = sheet.look.lanes[lane];
  const QRectF rect = ganttLaneRect(sheet.look, lane);
  QRectF room(kGanttMargin, rect.top(), sheet.look.scale.left - 2 * kGanttMargin, rect.height() / 2);
  painter.setPen(sheet.text());
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, QString::fromStdString(of.process));
  painter.setPen(of.overruns > 0 ? sheet.bad() : sheet.muted());
  painter.drawText(room.translated(0, rect.height() / 2 - 2), Qt::AlignLeft | Qt::AlignVCenter, rateText(of));
}

}  // namespace

int ganttGutter(const GanttLook& look, const QFontMetricsF& font) {
  double width = font.horizontalAdvance(QStringLiteral("motion, 100.0 Hz"));
  for (const GanttLane& lane : look.lanes) {
    width = std::max({width, font.horizontalAdvance(QString::fromStdString(lane.process)),
                      font.horizontalAdvance(rateText(lane))});
  }
  return static_cast<int>(std::min(width, look.size.width() / 3.0) + 2 * kGanttMargin);
}

QRectF ganttLaneRect(const GanttLook& look, std::size_t lane) {
  const double lanes = static_cast<double>(std::max<std::size_t>(1, look.lanes.size()));
  const double height =
      std::clamp((look.size.height() - kGanttRuler) / lanes, double{kMinGanttLane}, double{kMaxGanttLane});
  return {0, kGanttRuler + static_cast<double>(lane) * height, double(look.size.width()), height};
}

QRectF ganttBar(const GanttLook& look, const GanttHit& of) {
  const GanttFrame& frame = look.lanes[of.lane].frames[of.frame];
  const QRectF lane = ganttLaneRect(look, of.lane);
  const double x = look.scale.x(frame.time), split = std::round(lane.top() + lane.height() * kFrameShare);
  if (of.task < 0) {
    return {x, lane.top() + 3, std::max(1.0, widthOf(look, frame.seconds)), split - lane.top() - 3};
  }
  return {x + widthOf(look, secondsBefore(frame, of.task)), split + 1,
          widthOf(look, frame.times->entries(of.task).seconds()), lane.bottom() - split - 5};
}

std::optional<GanttHit> ganttHit(const GanttLook& look, const QPointF& at) {
  constexpr double kNear = 2;  // pixels; bars may be as narrow as one
  if (at.x() < look.scale.left) return std::nullopt;
  for (std::size_t lane = 0; lane < look.lanes.size(); ++lane) {
    if (!ganttLaneRect(look, lane).contains(at)) continue;
    const auto& frames = look.lanes[lane].frames;
    // Frames painted last are on top.
    for (std::size_t i = frames.size(); i-- > 0;) {
      const QRectF bar = ganttBar(look, {lane, i, -1});
      if (at.x() < bar.left() - kNear || at.x() > bar.right() + kNear) continue;
      if (at.y() > bar.bottom()) {
        for (int task = 0; task < frames[i].times->entries_size(); ++task) {
          const QRectF part = ganttBar(look, {lane, i, task});
          const bool isTask = !frames[i].times->entries(task).task().empty();
          if (isTask && at.x() >= part.left() && at.x() <= part.right()) return GanttHit{lane, i, task};
        }
      }
      return GanttHit{lane, i, -1};
    }
  }
  return std::nullopt;
}

QString ganttText(const GanttLook& look, const GanttHit& of) {
  const GanttLane& lane = look.lanes[of.lane];
  const GanttFrame& frame = lane.frames[of.frame];
  QStringList lines;
  double begin = robotlink::seconds(frame.time - look.origin), took = frame.seconds;
  if (of.task < 0) {
    lines << GanttTexts::tr("%1, frame %2").arg(QString::fromStdString(lane.process)).arg(frame.number);
  } else {
    const auto& entry = frame.times->entries(of.task);
    lines << GanttTexts::tr("%1 (%2)").arg(QString::fromStdString(entry.task()),
                                           QString::fromStdString(entry.solution()));
    took = entry.seconds();
    begin += secondsBefore(frame, of.task);
  }
  lines << GanttTexts::tr("begins at %1 s").arg(begin, 0, 'f', 4);
  lines << GanttTexts::tr("takes %1").arg(millisecondsText(took));
  if (frame.period > 0) {
    lines.back() += GanttTexts::tr(", %1 % of the period of %2")
                        .arg(100 * took / frame.period, 0, 'f', 1)
                        .arg(millisecondsText(frame.period));
  }
  if (frame.overruns())
    lines << GanttTexts::tr("The frame overruns by %1.").arg(millisecondsText(frame.seconds - frame.period));
  return lines.join(QLatin1Char('\n'));
}

void paintGantt(QPainter& painter, const GanttLook& look, const QPalette& palette) {
  const GanttSheet sheet{painter, look, palette};
  painter.fillRect(QRectF({}, QSizeF(look.size)), sheet.base());
  if (look.lanes.empty()) return;
  paintGanttRuler(sheet);
  for (std::size_t lane = 0; lane < look.lanes.size(); ++lane) {
    paintGanttLane(sheet, lane);
    paintGanttName(sheet, lane);
    const double bottom = std::round(ganttLaneRect(look, lane).bottom()) - 0.5;
    painter.setPen(sheet.line());
    painter.drawLine(QPointF(0, bottom), QPointF(look.size.width(), bottom));
  }
  const double x = std::round(look.scale.x(look.shown)) + 0.5;
  if (x < look.scale.left || x > look.size.width()) return;
  painter.setPen(QPen(palette.color(QPalette::Highlight), 1));
  painter.drawLine(QPointF(x, 0), QPointF(x, look.size.height()));
}

}  // namespace widgets
