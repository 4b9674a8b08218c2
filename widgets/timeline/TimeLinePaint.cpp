// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/TimeLinePaint.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "widgets/Theme.h"

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;
using Lane = TimeLineLayout::Lane;

namespace {

constexpr double kLaneMargin = 6;

/// The arguments of the functions below.
struct Canvas {
  QPainter& painter;
  const TimeLineLook& look;
  const QPalette& palette;

  QColor text() const { return palette.color(QPalette::Text); }
  QColor base() const { return palette.color(QPalette::Base); }
  QColor muted() const { return colorOf(Meaning::kMuted, palette); }
  QColor line() const { return mixed(base(), text(), 0.15); }
  QString elided(const QString& of, double width, Qt::TextElideMode mode = Qt::ElideRight) const {
    return painter.fontMetrics().elidedText(of, mode, static_cast<int>(width));
  }
  QRectF plot(const QRectF& lane) const { return lane.adjusted(look.gutter, 0, 0, 0); }
};

void paintRuler(const Canvas& canvas, const TimeLineLayout& layout) {
  QPainter& painter = canvas.painter;
  painter.fillRect(QRectF(0, 0, canvas.look.size.width(), layout.ruler.height()),
                   canvas.palette.color(QPalette::Window));
  if (canvas.look.end <= canvas.look.begin) return;  // no log is open
  const double label = painter.fontMetrics().horizontalAdvance(QStringLiteral("0000.0000")) + 16;
  const AxisMarks marks = axisMarks(canvas.look.scale, label, canvas.look.origin),
                  fine = axisMarks(canvas.look.scale, label / 6, canvas.look.origin);
  painter.setClipRect(layout.ruler);
  painter.setPen(canvas.line());
  for (Instant time = fine.first; canvas.look.scale.x(time) < layout.ruler.right(); time += fine.step) {
    const double x = std::round(canvas.look.scale.x(time)) + 0.5;
    painter.drawLine(QPointF(x, layout.ruler.bottom() - 5), QPointF(x, layout.ruler.bottom()));
  }
  for (Instant time = marks.first - marks.step; canvas.look.scale.x(time) < layout.ruler.right();
       time += marks.step) {
    const double x = std::round(canvas.look.scale.x(time)) + 0.5;
    painter.setPen(canvas.muted());
    painter.drawLine(QPointF(x, layout.ruler.bottom() - 10), QPointF(x, layout.ruler.bottom()));
    painter.setPen(canvas.palette.color(QPalette::WindowText));
    painter.drawText(QRectF(x + 3, 1, label, layout.ruler.height() - 8), Qt::AlignLeft | Qt::AlignVCenter,
                     timeText(time - canvas.look.origin, marks.step));
  }
  painter.setClipping(false);
  painter.setPen(canvas.muted());
  painter.drawText(QRectF(kLaneMargin, 0, canvas.look.gutter - 2 * kLaneMargin, layout.ruler.height()),
                   Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("s"));
}

QColor markColor(const TimeMark& mark, const QPalette& palette) {
  if (mark.level >= LogEntry::Level::kError) return colorOf(Meaning::kBad, palette);
  return colorOf(mark.level == LogEntry::Level::kWarning ? Meaning::kWarning : Meaning::kNote, palette);
}

/// Paints texts as pins at the top of the ruler, and what a search found as bars at its bottom.
void paintMarks(const Canvas& canvas, const TimeLineLayout& layout) {
  constexpr double kPin = 5, kBar = 4;
  QPainter& painter = canvas.painter;
  painter.setClipRect(layout.ruler);
  const auto seen = [&](const std::vector<TimeMark>& marks, const auto& paint) {
    double painted = -1;
    for (const TimeMark& mark : marks) {
      const double left = std::round(canvas.look.scale.x(mark.from)), right = canvas.look.scale.x(mark.to);
      if (right < layout.ruler.left() || left > layout.ruler.right() || right <= painted) continue;
      paint(mark, left, std::max(left + 2, std::round(right)));
      painted = std::max(left, right);
    }
  };
  if (canvas.look.texts) {
    seen(*canvas.look.texts, [&](const TimeMark& mark, double left, double) {
      painter.fillRect(QRectF(left - 2, layout.ruler.top(), kPin, kPin), markColor(mark, canvas.palette));
      painter.fillRect(QRectF(left, layout.ruler.top(), 1, layout.ruler.height()),
                       markColor(mark, canvas.palette));
    });
  }
  if (canvas.look.hits) {
    const QColor color = colorOf(Meaning::kGood, canvas.palette);
    seen(*canvas.look.hits, [&](const TimeMark&, double left, double right) {
      painter.fillRect(QRectF(left, layout.ruler.bottom() - kBar, right - left, kBar), color);
      painter.fillRect(QRectF(left, layout.ruler.bottom() - 3 * kBar, 1, 3 * kBar), color);
    });
  }
  painter.setClipping(false);
}

void paintBookmark(const Canvas& canvas, const TimeLineBand& band, const logplayer::Bookmark& bookmark,
                   const Lane& lane) {
  QPainter& painter = canvas.painter;
  const QRectF rect = bookmarkRect(band, bookmark, canvas.look, lane.rect, QFontMetricsF(painter.font()));
  const bool chosen = canvas.look.bookmark == std::pair(lane.band, bookmark.id);
  const QColor color =
      chosen ? canvas.palette.color(QPalette::Highlight) : colorOf(Meaning::kNote, canvas.palette);
  QColor fill = mixed(canvas.base(), color, chosen ? 1 : 0.22);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath flag;
  flag.addRoundedRect(rect, 3, 3);
  painter.fillPath(flag, fill);
  if (bookmark.to > bookmark.from) {
    const double to = canvas.look.scale.x(bookmark.to + band.offset);
    painter.fillRect(QRectF(rect.left(), rect.bottom() - 2, to - rect.left(), 2), color);
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(QRectF(rect.left(), rect.top(), 2, lane.rect.bottom() - rect.top()), color);
  painter.setPen(chosen ? canvas.palette.color(QPalette::HighlightedText) : canvas.text());
  const QRectF text = rect.adjusted(kLaneMargin, 0, -2, 0);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                   canvas.elided(QString::fromStdString(bookmark.text), text.width()));
}

/// Shades the times in which nothing was received, with the words for it where there is room.
void paintGaps(const Canvas& canvas, const TimeLineBand& band, const QRectF& plot) {
  QPainter& painter = canvas.painter;
  const QColor warning = colorOf(Meaning::kWarning, canvas.palette);
  for (const robotlink::LineGap& gap : band.gaps) {
    const double from = std::max(plot.left(), canvas.look.scale.x(gap.from));
    // A gap that lasts has no end that the session knows.
    const double to = gap.to ? std::min(plot.right(), canvas.look.scale.x(*gap.to)) : plot.right();
    if (to < plot.left() || from > plot.right()) continue;
    const QRectF rect(from, plot.top(), std::max(2.0, to - from), plot.height());
    painter.fillRect(rect, mixed(canvas.base(), warning, 0.35));
    painter.fillRect(QRectF(rect.left(), rect.bottom() - 2, rect.width(), 2), warning);
    painter.setPen(canvas.text());
    const QRectF text = rect.adjusted(kLaneMargin, 0, -kLaneMargin, 0);
    const QString length =
        timeText(gap.to.value_or(canvas.look.end) - gap.from, std::chrono::milliseconds(100));
    painter.drawText(
        text, Qt::AlignLeft | Qt::AlignVCenter,
        canvas.elided(QCoreApplication::translate("TimeLine", "nothing for %1 s").arg(length), text.width()));
  }
}

/// Shows what is kept of a live robot's messages: in memory, on disk, or no longer.
void paintKept(const Canvas& canvas, const TimeLineBand& band, const QRectF& plot) {
  if (band.kept.empty()) return;
  QPainter& painter = canvas.painter;
  const auto fill = [&](Instant from, Instant to, const QBrush& brush) {
    const double left = std::max(plot.left(), canvas.look.scale.x(from));
    const double right = std::min(plot.right(), canvas.look.scale.x(to));
    if (right > left) painter.fillRect(QRectF(left, plot.top() + 3, right - left, plot.height() - 6), brush);
  };
  fill(canvas.look.begin, canvas.look.end,
       QBrush(mixed(canvas.base(), canvas.text(), 0.35), Qt::BDiagPattern));
  const QColor color = curveColor(0, canvas.palette);
  for (const robotlink::Stretch& kept : band.kept) {
    fill(kept.from, kept.to, canvas.base());
    fill(kept.from, std::min(kept.to, band.inMemory), mixed(canvas.base(), color, 0.25));
    fill(std::max(kept.from, band.inMemory), kept.to, mixed(canvas.base(), color, 0.5));
  }
}

/// Names a band; those of logs can be collapsed.
void paintHeader(const Canvas& canvas, const TimeLineBand& band, const Lane& lane) {
  QPainter& painter = canvas.painter;
  painter.fillRect(lane.rect, mixed(canvas.base(), canvas.text(), 0.06));
  paintKept(canvas, band, canvas.plot(lane.rect));
  paintGaps(canvas, band, canvas.plot(lane.rect));
  const QPointF middle = collapseRect(lane.rect).center();
  QPainterPath triangle;
  triangle.addPolygon(band.collapsed ? QPolygonF(QVector<QPointF>{{-2, -4}, {3, 0}, {-2, 4}})
                                     : QPolygonF(QVector<QPointF>{{-4, -2}, {4, -2}, {0, 3}}));
  painter.setRenderHint(QPainter::Antialiasing);
  if (band.log != nullptr) painter.fillPath(triangle.translated(middle), canvas.text());
  painter.setRenderHint(QPainter::Antialiasing, false);
  const QFont plain = painter.font();
  QFont bold = plain;
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(canvas.text());
  QRectF title(22, lane.rect.top(), canvas.look.gutter - 22 - kLaneMargin, lane.rect.height());
  if (band.showsOffset) title.setRight(offsetRect(lane.rect, canvas.look).left());
  painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter,
                   canvas.elided(band.title, title.width(), Qt::ElideMiddle));
  painter.setFont(plain);
  if (band.showsOffset) {
    painter.setPen(canvas.muted());
    const double offset = robotlink::seconds(band.offset);
    painter.drawText(offsetRect(lane.rect, canvas.look), Qt::AlignRight | Qt::AlignVCenter,
                     QStringLiteral("%1%2 s")
                         .arg(offset < 0 ? QString(QChar(0x2212)) : QStringLiteral("+"))
                         .arg(std::abs(offset), 0, 'f', 3));
  }
  const QString note = band.log != nullptr ? band.log->stageText() : QString();
  if (!note.isEmpty()) {
    painter.setPen(canvas.muted());
    painter.drawText(canvas.plot(lane.rect).adjusted(0, 0, -kLaneMargin, 0),
                     Qt::AlignRight | Qt::AlignVCenter, note);
  }
}

/// The thumbnail for this time, or the last one before it while it is being read.
const QImage* thumbnailFor(const TimeLineBand& band, const ThumbnailSlot& slot, Duration reach) {
  auto found = band.thumbnails.upper_bound(slot.time);
  if (found == band.thumbnails.begin()) return nullptr;
  --found;
  return slot.time - found->first <= reach && !found->second.isNull() ? &found->second : nullptr;
}

void paintImages(const Canvas& canvas, const TimeLineBand& band, const Lane& lane) {
  QPainter& painter = canvas.painter;
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF plot = canvas.plot(lane.rect);
  for (const ThumbnailSlot& slot : thumbnailSlots(band, canvas.look)) {
    const QRectF whole(slot.left, plot.top() + 2, slot.right - slot.left, thumbnailHeight());
    const auto width =
        Duration(static_cast<Duration::rep>((slot.right - slot.left) * canvas.look.scale.nsPerPixel));
    const QImage* image = thumbnailFor(band, slot, width);
    if (image == nullptr) {
      painter.fillRect(whole, mixed(canvas.base(), canvas.text(), 0.08));
      continue;
    }
    painter.drawImage(whole, *image);
  }
}

void paintTexts(const Canvas& canvas, const TimeLineBand& band, const Lane& lane) {
  QPainter& painter = canvas.painter;
  const QRectF plot = canvas.plot(lane.rect);
  painter.fillRect(lane.rect, mixed(canvas.base(), canvas.text(), 0.03));
  // Errors are painted last, so that warnings do not cover them.
  for (const bool errors : {false, true}) {
    const QColor color = colorOf(errors ? Meaning::kBad : Meaning::kWarning, canvas.palette);
    for (const LogEntry& entry : *saidOf(band)) {
      if ((entry.level >= LogEntry::Level::kError) != errors) continue;
      const double x = std::round(canvas.look.scale.x(entry.time + band.offset));
      if (x < plot.left() - 1 || x > plot.right()) continue;
      painter.fillRect(QRectF(x - 1, plot.top() + (errors ? 1 : 4), 3, plot.height() - (errors ? 2 : 5)),
                       color);
    }
  }
}

void paintDensity(const Canvas& canvas, const TimeLineBand& band, const LogOverview::Stream& stream,
                  const QRectF& plot, const QColor& color) {
  const int left =
      static_cast<int>(std::max(plot.left(), std::floor(canvas.look.scale.x(stream.first + band.offset))));
  const int right =
      static_cast<int>(std::min(plot.right(), canvas.look.scale.x(stream.last + band.offset) + 1));
  std::vector<std::uint64_t> counts;
  std::uint64_t most = 1;
  for (int x = left; x < right; ++x) {
    const Instant from = canvas.look.scale.time(x) - band.offset,
                  to = canvas.look.scale.time(x + 1) - band.offset;
    counts.push_back(stream.density.between(from, to));
    most = std::max(most, counts.back());
  }
  const double room = plot.height() - 4;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const double share = std::sqrt(static_cast<double>(counts[i]) / static_cast<double>(most));
    const double height = std::max(3.0, std::round(room * (most == 1 ? 0.7 : share)));
    canvas.painter.fillRect(QRectF(left + static_cast<int>(i), plot.bottom() - 2 - height, 1, height), color);
  }
}

void paintStream(const Canvas& canvas, const TimeLineBand& band, const Lane& lane) {
  const LogOverview::Stream* stream = band.log->find(lane.stream);
  if (stream == nullptr) return;
  const bool chosen = canvas.look.stream == std::pair(lane.band, lane.stream);
  if (chosen) {
    canvas.painter.fillRect(lane.rect, mixed(canvas.base(), canvas.palette.color(QPalette::Highlight), 0.18));
  }
  const QColor color = mixed(curveColor(0, canvas.palette), canvas.base(), chosen ? 0 : 0.25);
  paintDensity(canvas, band, *stream, canvas.plot(lane.rect), color);
  canvas.painter.setPen(canvas.line());
  canvas.painter.drawLine(QPointF(lane.rect.left(), lane.rect.bottom() - 0.5),
                          QPointF(lane.rect.right(), lane.rect.bottom() - 0.5));
}

const TimeLineTrack* trackOf(const TimeLineBand& band, const Lane& lane) {
  const auto found = std::ranges::find_if(
      band.tracks, [&](const TimeLineTrack& track) { return track.source.toStdString() == lane.stream; });
  return found == band.tracks.end() ? nullptr : &*found;
}

QString missingText(MissingValues::Why why) {
  switch (why) {
    case MissingValues::Why::kUnread:
      return QCoreApplication::translate("TimeLine", "being read from disk");
    case MissingValues::Why::kTooMany:
      return QCoreApplication::translate("TimeLine", "on disk; look there with the timeline");
    case MissingValues::Why::kLost:
      break;
  }
  return QCoreApplication::translate("TimeLine", "lost, since the disk was too slow");
}

/// Hatches where the track lacks values of the history.
void paintMissing(const Canvas& canvas, const TimeLineTrack& track, const QRectF& plot) {
  const auto x = [&](double seconds) {
    const double at = canvas.look.scale.x(Instant(robotlink::fromSeconds(seconds)));
    return std::clamp(at, plot.left(), plot.right());
  };
  QPainter& painter = canvas.painter;
  for (const MissingValues& missing : track.missing) {
    const QRectF part(QPointF(x(missing.from), plot.top()), QPointF(x(missing.to), plot.bottom()));
    if (part.width() < 1) continue;
    painter.fillRect(part, QBrush(mixed(canvas.base(), canvas.text(), 0.25), Qt::BDiagPattern));
    painter.setPen(canvas.text());
    const QRectF inner = part.adjusted(kLaneMargin, 0, -kLaneMargin, 0);
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter,
                     canvas.elided(missingText(missing.why), inner.width()));
  }
}

/// A curve of the extent of the values in each column of pixels, over the whole height for what is visible.
void paintTrack(const Canvas& canvas, const TimeLineBand& band, const Lane& lane) {
  QPainter& painter = canvas.painter;
  const TimeLineTrack* track = trackOf(band, lane);
  if (track == nullptr) return;
  const QRectF plot = canvas.plot(lane.rect).adjusted(0, 3, 0, -3);
  painter.setPen(canvas.line());
  painter.drawLine(QPointF(lane.rect.left(), lane.rect.bottom() - 0.5),
                   QPointF(lane.rect.right(), lane.rect.bottom() - 0.5));
  painter.setPen(canvas.muted());
  if (track->series == nullptr || track->series->empty()) {
    const QString text =
        track->problem.isEmpty() ? QCoreApplication::translate("TimeLine", "no values here") : track->problem;
    return painter.drawText(plot.adjusted(kLaneMargin, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                            canvas.elided(text, plot.width()));
  }
  paintMissing(canvas, *track, plot);
  const auto seconds = [&](double x) {
    return robotlink::seconds(canvas.look.scale.time(x).time_since_epoch());
  };
  const double from = seconds(plot.left()), to = seconds(plot.right());
  const auto columns =
      track->series->columns(from, to, static_cast<std::size_t>(std::max(1.0, plot.width())));
  robotlink::Series::Extent all;
  for (const auto& column : columns) all.add(column.extent);
  if (all.isEmpty()) return;
  const double range = all.max > all.min ? all.max - all.min : 1;
  const auto y = [&](double value) { return plot.bottom() - (value - all.min) / range * plot.height(); };
  QPolygonF curve;
  for (const auto& column : columns) {
    if (column.extent.isEmpty()) continue;
    const double time = (*track->series)[column.begin].time;
    const double x = plot.left() + (time - from) / (to - from) * plot.width();
    curve << QPointF(x, y(column.extent.min));
    if (column.extent.max > column.extent.min) curve << QPointF(x, y(column.extent.max));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const auto number = static_cast<int>(track - band.tracks.data());
  painter.setPen(QPen(curveColor(number, canvas.palette), 1.2));
  if (curve.size() > 1) painter.drawPolyline(curve);
  if (curve.size() == 1) painter.drawEllipse(curve.front(), 1.5, 1.5);
  painter.setRenderHint(QPainter::Antialiasing, false);
  // The range that the height represents.
  const auto shortNumber = [](double value) { return QString::number(value, 'g', 4); };
  painter.setPen(canvas.muted());
  const QRectF labels(0, lane.rect.top() + 1, canvas.look.gutter - kLaneMargin, lane.rect.height() - 2);
  painter.drawText(
      labels, Qt::AlignRight | Qt::AlignBottom,
      QStringLiteral("%1 … %2 %3").arg(shortNumber(all.min), shortNumber(all.max), track->unit).trimmed());
}

QString laneName(const TimeLineBand& band, const Lane& lane) {
  switch (lane.kind) {
    case TimeLineLayout::Kind::kImages:
      return QCoreApplication::translate("TimeLine", "images");
    case TimeLineLayout::Kind::kTexts: {
      const auto& said = *saidOf(band);
      const auto errors = std::ranges::count_if(
          said, [](const LogEntry& entry) { return entry.level >= LogEntry::Level::kError; });
      const auto warnings = std::ssize(said) - errors;
      return QCoreApplication::translate("TimeLine", "warnings: %1, errors: %2").arg(warnings).arg(errors);
    }
    case TimeLineLayout::Kind::kStream:
    case TimeLineLayout::Kind::kTrack:
      return QString::fromStdString(lane.stream);
    case TimeLineLayout::Kind::kHeader:
      break;
  }
  return {};
}

void paintLane(const Canvas& canvas, const TimeLineBand& band, const Lane& lane, const QRectF& body) {
  QPainter& painter = canvas.painter;
  painter.setClipRect(
      lane.kind == TimeLineLayout::Kind::kHeader ? body : body.adjusted(canvas.look.gutter, 0, 0, 0));
  if (lane.kind == TimeLineLayout::Kind::kHeader) return paintHeader(canvas, band, lane);
  if (lane.kind == TimeLineLayout::Kind::kImages) paintImages(canvas, band, lane);
  if (lane.kind == TimeLineLayout::Kind::kTexts) paintTexts(canvas, band, lane);
  painter.setClipRect(body);
  if (lane.kind == TimeLineLayout::Kind::kStream) paintStream(canvas, band, lane);
  const bool isTrack = lane.kind == TimeLineLayout::Kind::kTrack;
  if (isTrack) paintTrack(canvas, band, lane);
  const bool heading = lane.kind != TimeLineLayout::Kind::kStream && !isTrack;
  // Below the name of a value there is its range.
  const QRectF name(22, lane.rect.top(), canvas.look.gutter - 22 - kLaneMargin,
                    isTrack ? canvas.look.row : lane.rect.height());
  painter.setPen(heading ? canvas.muted() : canvas.text());
  painter.drawText(
      name, Qt::AlignLeft | Qt::AlignVCenter,
      canvas.elided(laneName(band, lane), name.width(), isTrack ? Qt::ElideLeft : Qt::ElideMiddle));
}

/// Dims what is outside of the selected range and outside of all logs.
void paintRange(const Canvas& canvas, const TimeLineLayout& layout) {
  QPainter& painter = canvas.painter;
  const QRectF plot(canvas.look.gutter, 0, layout.ruler.width(), canvas.look.size.height());
  painter.setClipRect(plot);
  QColor dim = canvas.palette.color(QPalette::Window);
  dim.setAlphaF(0.55);
  const double begin = canvas.look.scale.x(canvas.look.begin), end = canvas.look.scale.x(canvas.look.end);
  painter.fillRect(QRectF(plot.left(), layout.body.top(), begin - plot.left(), plot.height())
                       .normalized()
                       .intersected(begin > plot.left() ? plot : QRectF()),
                   dim);
  if (end < plot.right())
    painter.fillRect(QRectF(end, layout.body.top(), plot.right() - end, plot.height()), dim);
  if (canvas.look.range) {
    const double from = canvas.look.scale.x(canvas.look.range->first),
                 to = canvas.look.scale.x(canvas.look.range->second);
    QColor tint = canvas.palette.color(QPalette::Highlight);
    tint.setAlphaF(0.16);
    painter.fillRect(QRectF(from, 0, to - from, plot.height()), tint);
    tint.setAlphaF(1);
    painter.fillRect(QRectF(from, layout.ruler.bottom() - 4, to - from, 4), tint);
    for (const double edge : {from, to})
      painter.fillRect(QRectF(std::round(edge) - 1, 0, 2, plot.height()), tint);
  }
  painter.setClipping(false);
}

}  // namespace

QColor playHeadColor(const QPalette& palette) {
  return isDark(palette) ? QColor(0xff6f61) : QColor(0xd3302f);
}

void paintTimeLine(QPainter& painter, const std::vector<TimeLineBand>& bands, const TimeLineLook& look,
                   const QPalette& palette) {
  const Canvas canvas{painter, look, palette};
  const TimeLineLayout layout = layOut(bands, look);
  painter.fillRect(QRectF(QPointF(), look.size), canvas.base());
  for (const Lane& lane : layout.lanes) {
    if (lane.rect.intersects(layout.body))
      paintLane(canvas, bands[static_cast<std::size_t>(lane.band)], lane, layout.body);
  }
  painter.setClipRect(layout.body);
  painter.setPen(canvas.line());
  painter.drawLine(QPointF(look.gutter - 0.5, 0), QPointF(look.gutter - 0.5, look.size.height()));
  painter.setClipping(false);
  paintRuler(canvas, layout);
  paintMarks(canvas, layout);
  paintRange(canvas, layout);
  for (const Lane& lane : layout.lanes) {
    if (lane.kind != TimeLineLayout::Kind::kHeader || !lane.rect.intersects(layout.body)) continue;
    painter.setClipRect(layout.body.adjusted(look.gutter, 0, 0, 0));
    const TimeLineBand& band = bands[static_cast<std::size_t>(lane.band)];
    for (const auto& bookmark : band.bookmarks) paintBookmark(canvas, band, bookmark, lane);
  }
  painter.setClipping(false);
}

void paintPlayHead(QPainter& painter, const TimeLineLook& look, const QPalette& palette) {
  const double x = std::round(look.scale.x(look.shown)) + 0.5;
  const QColor color = playHeadColor(palette);
  if (x >= look.gutter && x <= look.size.width()) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(color, 1.5));
    painter.drawLine(QPointF(x, 12), QPointF(x, look.size.height()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawPolygon(QPolygonF(QVector<QPointF>{{x - 6, 0}, {x + 6, 0}, {x + 6, 8}, {x, 15}, {x - 6, 8}}));
    painter.setRenderHint(QPainter::Antialiasing, false);
  }
  if (!look.focused) return;
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette.color(QPalette::Highlight), 2));
  painter.drawRect(QRectF(QPointF(1, 1), look.size - QSizeF(2, 2)));
}

}  // namespace widgets
