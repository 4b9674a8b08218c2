// SPDX-License-Identifier: GPL-3.0-or-later
// The part of TimeLineCanvas that reacts to mouse and keys.
#include <QApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QMouseEvent>
#include <QScrollBar>
#include <QShortcut>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "widgets/timeline/TimeLineCanvas.h"

#include "widgets/Counted.h"
#include "widgets/plots/PlotTreeModel.h"

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;
using Kind = TimeLineLayout::Kind;

namespace {

constexpr double kGrip = 4;  // the distance in pixels from an edge at which it is still grabbed
constexpr double kZoomStep = 1.25;

}  // namespace

Instant TimeLineCanvas::timeAt(const QPointF& point) const {
  return std::clamp(look_.scale.time(point.x()), look_.begin, std::max(look_.begin, look_.end));
}

Instant TimeLineCanvas::snappedTimeAt(const QPointF& point) const {
  const TimeLineLayout all = layout();
  const auto* lane = all.laneAt(point);
  if (lane == nullptr || lane->kind != Kind::kStream) return timeAt(point);
  const TimeLineBand& of = band(lane->band);
  const auto* stream = of.log->find(lane->stream);
  if (stream == nullptr) return timeAt(point);
  const auto reach = Duration(std::llround(kGrip * look_.scale.nsPerPixel));
  return stream->density.snapped(look_.scale.time(point.x()) - of.offset, reach) + of.offset;
}

std::uint64_t TimeLineCanvas::bookmarkAt(const TimeLineLayout::Lane& lane, const QPointF& point) const {
  const TimeLineBand& of = band(lane.band);
  const auto found = std::find_if(of.bookmarks.rbegin(), of.bookmarks.rend(), [&](const auto& bookmark) {
    return bookmarkRect(of, bookmark, look_, lane.rect, QFontMetricsF(font())).contains(point);
  });
  return found == of.bookmarks.rend() ? 0 : found->id;
}

TimeLineCanvas::Hit TimeLineCanvas::hitAt(const QPointF& point, Qt::KeyboardModifiers modifiers) const {
  const TimeLineLayout all = layout();
  const auto* lane = all.laneAt(point);
  if (point.x() < look_.gutter) {
    const bool offset = lane != nullptr && lane->kind == Kind::kHeader && band(lane->band).showsOffset &&
                        offsetRect(lane->rect, look_).contains(point);
    return {offset ? Drag::kOffset : Drag::kNone, lane != nullptr ? lane->band : -1};
  }
  if ((modifiers & Qt::ShiftModifier) != 0) return {Drag::kSelect};
  if (scrubsEverywhere_) return {Drag::kScrub};
  if (lane != nullptr && lane->kind == Kind::kHeader) {
    if (const auto id = bookmarkAt(*lane, point); id != 0) return {Drag::kBookmark, lane->band, id};
  }
  if (look_.range) {
    for (const bool upper : {false, true}) {
      const double edge = look_.scale.x(upper ? look_.range->second : look_.range->first);
      if (std::abs(edge - point.x()) <= kGrip) return {Drag::kRangeEdge, -1, 0, upper};
    }
  }
  const bool scrubs = all.ruler.contains(point) || (lane != nullptr && lane->kind == Kind::kImages);
  return {scrubs ? Drag::kScrub : Drag::kSelect, lane != nullptr ? lane->band : -1};
}

void TimeLineCanvas::pressGutter(const TimeLineLayout::Lane& lane, const QPointF& point) {
  if (lane.kind == Kind::kStream) Q_EMIT streamChosen(lane.band, lane.stream);
  if (lane.kind == Kind::kHeader && collapseRect(lane.rect).contains(point)) {
    Q_EMIT collapseWanted(lane.band, !band(lane.band).collapsed);
  }
}

void TimeLineCanvas::mousePressEvent(QMouseEvent* event) {
  if (bands_.empty()) return;
  const QPointF point = event->localPos();
  pressedAt_ = lastAt_ = point;
  moved_ = false;
  if (event->button() == Qt::MiddleButton) held_ = {Drag::kPan};
  if (event->button() != Qt::LeftButton) return;
  held_ = hitAt(point, event->modifiers());
  const TimeLineLayout all = layout();
  const auto* lane = all.laneAt(point);
  if (point.x() < look_.gutter && lane != nullptr) pressGutter(*lane, point);
  if (held_.drag == Drag::kOffset) heldOffset_ = band(held_.band).offset;
  if (held_.drag == Drag::kBookmark) {
    const auto& bookmarks = band(held_.band).bookmarks;
    heldBookmark_ = *std::find_if(bookmarks.begin(), bookmarks.end(),
                                  [&](const auto& b) { return b.id == held_.bookmark; });
    chooseBookmark(held_.band, held_.bookmark);
  }
  if (held_.drag == Drag::kScrub) {
    look_.shown = all.ruler.contains(point) ? rulerTimeAt(point) : timeAt(point);
    viewport()->update();
    Q_EMIT jumpWanted(look_.shown);
  }
}

void TimeLineCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF point = event->localPos();
  moved_ = moved_ || (point - pressedAt_).manhattanLength() >= kGrip;
  const auto by = Duration(std::llround((point.x() - lastAt_.x()) * look_.scale.nsPerPixel));
  const auto since = Duration(std::llround((point.x() - pressedAt_.x()) * look_.scale.nsPerPixel));
  switch (held_.drag) {
    case Drag::kNone:
      updateCursor(point, event->modifiers());
      break;
    case Drag::kScrub:
      look_.shown = timeAt(point);
      viewport()->update();
      Q_EMIT jumpWanted(look_.shown);
      break;
    case Drag::kPan:
      fitted_ = false;
      setFrom(look_.scale.from - by);
      break;
    case Drag::kSelect:
      if (moved_) look_.range = std::minmax(timeAt(pressedAt_), timeAt(point));
      lookAnew();
      break;
    case Drag::kRangeEdge:
      (held_.upper ? look_.range->second : look_.range->first) = timeAt(point);
      lookAnew();
      break;
    case Drag::kBookmark:
      if (moved_) dragBookmark(point);
      break;
    case Drag::kOffset:
      if (moved_) band(held_.band).offset = heldOffset_ + since;
      lookAnew();
      break;
  }
  lastAt_ = point;
}

void TimeLineCanvas::dragBookmark(const QPointF& point) {
  TimeLineBand& of = band(held_.band);
  const auto by = Duration(std::llround((point.x() - pressedAt_.x()) * look_.scale.nsPerPixel));
  for (auto& bookmark : of.bookmarks) {
    if (bookmark.id != held_.bookmark) continue;
    const auto length = heldBookmark_.to - heldBookmark_.from;
    bookmark.from =
        std::clamp(heldBookmark_.from + by, of.log->begin, std::max(of.log->begin, of.log->end - length));
    bookmark.to = bookmark.from + length;
  }
  lookAnew();
}

void TimeLineCanvas::releaseSelection(const QPointF& point) {
  if (moved_) {
    if (look_.range) Q_EMIT rangeWanted(look_.range->first, look_.range->second);
    return;
  }
  look_.shown = snappedTimeAt(point);
  viewport()->update();
  Q_EMIT jumpWanted(look_.shown);
}

void TimeLineCanvas::mouseReleaseEvent(QMouseEvent* event) {
  const Hit held = held_;
  held_ = {};
  if (held.drag == Drag::kSelect) releaseSelection(event->localPos());
  if (held.drag == Drag::kRangeEdge) {
    const auto [from, to] = std::minmax({look_.range->first, look_.range->second});
    Q_EMIT rangeWanted(from, to);
  }
  if (held.drag == Drag::kOffset && moved_) Q_EMIT offsetWanted(held.band, band(held.band).offset);
  if (held.drag == Drag::kBookmark) {
    if (!moved_) Q_EMIT jumpWanted(heldBookmark_.from + band(held.band).offset);
    for (const auto& bookmark : band(held.band).bookmarks) {
      if (moved_ && bookmark.id == held.bookmark) {
        const logplayer::Bookmark changed = bookmark;  // a copy, since the receiver may replace the bands
        Q_EMIT bookmarkChanged(held.band, changed);
        break;
      }
    }
  }
  updateCursor(event->localPos(), event->modifiers());
}

void TimeLineCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  const QPointF point = event->localPos();
  const TimeLineLayout all = layout();
  const auto* lane = all.laneAt(point);
  if (event->button() != Qt::LeftButton || lane == nullptr) return mousePressEvent(event);
  held_ = {};
  if (lane->kind == Kind::kStream) return Q_EMIT streamChosen(lane->band, lane->stream);
  if (lane->kind != Kind::kHeader) return mousePressEvent(event);
  if (point.x() < look_.gutter) {
    if (band(lane->band).showsOffset && offsetRect(lane->rect, look_).contains(point)) editOffset(lane->band);
    return;
  }
  if (const auto id = bookmarkAt(*lane, point); id != 0) return editBookmark(lane->band, id);
  Q_EMIT bookmarkWanted(lane->band, timeAt(point));
}

void TimeLineCanvas::wheelEvent(QWheelEvent* event) {
  event->accept();
  const QPoint turned = event->angleDelta();
  const double notches = (turned.y() != 0 ? turned.y() : turned.x()) / 120.0;
  if (event->position().x() < look_.gutter) {
    verticalScrollBar()->setValue(verticalScrollBar()->value() -
                                  static_cast<int>(notches * 3 * verticalScrollBar()->singleStep()));
    return;
  }
  fitted_ = false;
  if ((event->modifiers() & Qt::ShiftModifier) != 0 || turned.y() == 0) {
    return setFrom(look_.scale.from - Duration(std::llround(notches * 80 * look_.scale.nsPerPixel)));
  }
  look_.scale.zoomAt(event->position().x(), std::pow(kZoomStep, notches));
  setFrom(look_.scale.from);
}

void TimeLineCanvas::keyPressEvent(QKeyEvent* event) {
  const bool chosen = look_.bookmark.first >= 0 && look_.bookmark.first < static_cast<int>(bands_.size());
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
      return verticalScrollBar()->triggerAction(event->key() == Qt::Key_Up ? QScrollBar::SliderSingleStepSub
                                                                           : QScrollBar::SliderSingleStepAdd);
    case Qt::Key_F2:
      if (chosen) return editBookmark(look_.bookmark.first, look_.bookmark.second);
      break;
    case Qt::Key_Delete:
      if (chosen) return Q_EMIT bookmarkDropped(look_.bookmark.first, look_.bookmark.second);
      break;
    case Qt::Key_Escape:
      if (look_.range) return Q_EMIT rangeDropped();
      break;
    default:
      break;
  }
  event->ignore();  // the view handles the keys of the replay
}

void TimeLineCanvas::editBookmark(int index, std::uint64_t id) {
  const TimeLineLayout all = layout();
  for (const auto& lane : all.lanes) {
    if (lane.kind != Kind::kHeader || lane.band != index) continue;
    for (const auto& bookmark : band(index).bookmarks) {
      if (bookmark.id != id) continue;
      QRectF where = bookmarkRect(band(index), bookmark, look_, lane.rect, QFontMetricsF(font()));
      where.setWidth(std::max(180.0, where.width()));
      where.moveLeft(
          std::clamp(where.left(), look_.gutter, std::max(look_.gutter, look_.size.width() - where.width())));
      openEditor("bookmarkEdit", where.toRect().adjusted(0, -2, 0, 2), QString::fromStdString(bookmark.text),
                 [this, index, changed = bookmark](const QString& text) mutable {
                   changed.text = text.toStdString();
                   Q_EMIT bookmarkChanged(index, changed);
                 });
      return;
    }
  }
}

void TimeLineCanvas::editOffset(int index) {
  const TimeLineLayout all = layout();
  for (const auto& lane : all.lanes) {
    if (lane.kind != Kind::kHeader || lane.band != index) continue;
    openEditor("offsetEdit", offsetRect(lane.rect, look_).toRect(),
               QString::number(robotlink::seconds(band(index).offset), 'f', 3),
               [this, index](const QString& text) {
                 bool ok = false;
                 QString number = text.trimmed();
                 if (number.endsWith(QLatin1Char('s'))) number.chop(1);
                 const double offset = number.replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
                 if (ok && std::abs(offset) < 1e9) Q_EMIT offsetWanted(index, robotlink::fromSeconds(offset));
               });
    return;
  }
}

QLineEdit* TimeLineCanvas::openEditor(const char* name, const QRect& where, const QString& text,
                                      std::function<void(const QString&)> done) {
  auto* edit = new QLineEdit(text, viewport());
  edit->setObjectName(QLatin1String(name));
  edit->setAccessibleName(name == std::string("offsetEdit") ? tr("Offset in seconds")
                                                            : tr("Text of the bookmark"));
  edit->setGeometry(where.width() < 60 ? where.adjusted(where.width() - 80, 0, 0, 0) : where);
  edit->selectAll();
  auto* escape = new QShortcut(QKeySequence(Qt::Key_Escape), edit);
  escape->setContext(Qt::WidgetShortcut);
  const auto close = [this, edit] {
    if (!edit->isVisible()) return;  // closing takes the focus away, which calls this again
    edit->hide();
    edit->deleteLater();
    setFocus();
  };
  connect(escape, &QShortcut::activated, edit, close);
  connect(edit, &QLineEdit::editingFinished, edit, [edit, close, before = text, done = std::move(done)] {
    if (!edit->isVisible()) return;
    const QString now = edit->text();
    close();
    if (now != before) done(now);
  });
  edit->show();
  edit->setFocus();
  return edit;
}

QString TimeLineCanvas::timeToolTip(Instant time) const {
  return tr("%1 s since the beginning (timestamp %2 s)")
      .arg(timeText(time - look_.begin), timeText(time.time_since_epoch()));
}

QString TimeLineCanvas::bookmarkToolTip(const TimeLineBand& of, const logplayer::Bookmark& bookmark) const {
  QString when = timeToolTip(bookmark.from + of.offset);
  if (bookmark.to > bookmark.from) when = tr("%1, for %2 s").arg(when, timeText(bookmark.to - bookmark.from));
  return QStringLiteral("<b>%1</b><br>%2<br>%3")
      .arg(QString::fromStdString(bookmark.text).toHtmlEscaped(), when,
           tr("Click: go there. Drag: move. Double click or F2: edit. Delete: remove."));
}

QString TimeLineCanvas::toolTipAt(const QPointF& point) const {
  const TimeLineLayout all = layout();
  const auto* lane = all.laneAt(point);
  if (all.ruler.contains(point)) {
    if (const QString marks = markToolTip(point.x()); !marks.isEmpty()) return marks;
    if (scrubsEverywhere_)
      return tr("Drag: show an earlier instant in all views. Shift+drag: select a range. Wheel: zoom.");
    return tr("%1<br>Drag: move the playhead. Shift+drag: select a range. Wheel: zoom.")
        .arg(timeToolTip(timeAt(point)));
  }
  if (lane == nullptr) return {};
  const TimeLineBand& of = band(lane->band);
  if (lane->kind == Kind::kHeader) {
    if (const auto id = point.x() < look_.gutter ? 0 : bookmarkAt(*lane, point); id != 0) {
      return bookmarkToolTip(of, *std::find_if(of.bookmarks.begin(), of.bookmarks.end(),
                                               [&](const auto& b) { return b.id == id; }));
    }
    if (const QString gap = point.x() < look_.gutter ? QString() : gapToolTip(of, point); !gap.isEmpty())
      return gap;
    if (of.log == nullptr)
      return point.x() < look_.gutter ? of.title.toHtmlEscaped() : keptToolTip(of, point);
    if (point.x() >= look_.gutter) return tr("Double click: add a bookmark here. Drag: select a range.");
    if (of.showsOffset && offsetRect(lane->rect, look_).contains(point)) {
      return tr("Offset of this log's times. Drag it, or double click and type.");
    }
    return of.log != nullptr ? QString::fromStdString(of.log->file).toHtmlEscaped() : QString();
  }
  if (lane->kind == Kind::kTrack) return trackToolTip(of, lane->stream, timeAt(point));
  if (lane->kind == Kind::kTexts) return saidNear(of, timeAt(point) - of.offset);
  if (lane->kind != Kind::kStream)
    return tr("%1<br>Drag: move the playhead.").arg(timeToolTip(timeAt(point)));
  const auto* stream = of.log->find(lane->stream);
  if (stream == nullptr) return {};
  return QStringLiteral("<b>%1</b><br>%2<br>%3<br>%4")
      .arg(QString::fromStdString(stream->path).toHtmlEscaped(),
           QString::fromStdString(stream->type).toHtmlEscaped(),
           tr("%1, %2 a second")
               .arg(counted(stream->count, tr("1 message"), tr("%1 messages")))
               .arg(stream->rate(), 0, 'f', 1),
           tr("Double click: step the messages of this stream. Drag: select a range."));
}

QString TimeLineCanvas::trackToolTip(const TimeLineBand& of, const std::string& source, Instant time) const {
  for (const TimeLineTrack& track : of.tracks) {
    if (track.source.toStdString() != source) continue;
    const QString name = track.source.toHtmlEscaped();
    const std::size_t after =
        track.series ? track.series->firstAfter(robotlink::seconds(time.time_since_epoch())) : 0;
    if (after == 0) return QStringLiteral("<b>%1</b>").arg(name);
    return QStringLiteral("<b>%1</b><br>%2<br>%3")
        .arg(name,
             tr("%1 %2 at %3 s")
                 .arg((*track.series)[after - 1].value)
                 .arg(track.unit, timeText(time - look_.origin)),
             tr("The context menu removes the curve."));
  }
  return {};
}

QString TimeLineCanvas::gapToolTip(const TimeLineBand& of, const QPointF& point) const {
  const Instant time = timeAt(point);
  const auto reach = Duration(std::llround(kGrip * look_.scale.nsPerPixel));
  for (const robotlink::LineGap& gap : of.gaps) {
    const Instant to = gap.to.value_or(look_.end);
    if (time < gap.from - reach || time > to + reach) continue;
    const QString reason = QString::fromStdString(gap.reason).toHtmlEscaped();
    return tr("Nothing was received from %1 for %2 s, from %3 s on%4")
        .arg(of.title.toHtmlEscaped(), timeText(to - gap.from, std::chrono::milliseconds(100)),
             timeText(gap.from - look_.origin),
             reason.isEmpty() ? QStringLiteral(".") : QStringLiteral(": ") + reason);
  }
  return {};
}

QString TimeLineCanvas::keptToolTip(const TimeLineBand& of, const QPointF& point) const {
  const Instant time = timeAt(point);
  const QString what = tr("%1 s").arg(timeText(time - look_.origin));
  const auto at = std::ranges::find_if(
      of.kept, [&](const robotlink::Stretch& stretch) { return stretch.from <= time && time <= stretch.to; });
  if (at == of.kept.end()) return tr("%1: no longer kept. The context menu sets how much is.").arg(what);
  return time < of.inMemory ? tr("%1, on disk. Click or drag: show it in all views.").arg(what)
                            : tr("%1. Click or drag: show it in all views.").arg(what);
}

QString TimeLineCanvas::saidNear(const TimeLineBand& of, Instant time) const {
  constexpr int kMax = 8;
  const auto reach = Duration(std::llround(kGrip * look_.scale.nsPerPixel));
  QStringList lines;
  for (const LogEntry& entry : *saidOf(of)) {
    if (entry.time < time - reach || entry.time > time + reach) continue;
    if (lines.size() == kMax) {
      lines << tr("…");
      break;
    }
    lines << QStringLiteral("<b>%1 s %2</b> %3: %4")
                 .arg(timeText(entry.time + of.offset - look_.origin), LogModel::levelName(entry.level),
                      entry.source.toHtmlEscaped(), entry.text.toHtmlEscaped());
  }
  return lines.isEmpty() ? tr("Warnings and errors in the messages") : lines.join(QStringLiteral("<br>"));
}

bool TimeLineCanvas::viewportEvent(QEvent* event) {
  const QString type = QString::fromLatin1(PlotTreeModel::kMimeType);
  if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
    auto* drag = static_cast<QDragMoveEvent*>(event);
    drag->setAccepted(drag->mimeData()->hasFormat(type));
    if (drag->isAccepted()) drag->acceptProposedAction();
    return true;
  }
  if (event->type() == QEvent::Drop) {
    auto* drop = static_cast<QDropEvent*>(event);
    drop->acceptProposedAction();
    const QString sources = QString::fromUtf8(drop->mimeData()->data(type));
    Q_EMIT tracksDropped(sources.split(QLatin1Char('\n'), Qt::SkipEmptyParts));
    return true;
  }
  if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), toolTipAt(help->pos()), viewport());
  return true;
}

void TimeLineCanvas::updateCursor(const QPointF& point, Qt::KeyboardModifiers modifiers) {
  switch (bands_.empty() ? Drag::kNone : hitAt(point, modifiers).drag) {
    case Drag::kRangeEdge:
    case Drag::kOffset:
      return viewport()->setCursor(Qt::SplitHCursor);
    case Drag::kBookmark:
    case Drag::kScrub:
      return viewport()->setCursor(Qt::PointingHandCursor);
    default:
      return viewport()->unsetCursor();
  }
}

}  // namespace widgets
