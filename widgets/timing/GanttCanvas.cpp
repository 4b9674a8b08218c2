// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timing/GanttCanvas.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

using robotlink::Instant;

constexpr double kZoomStep = 1.25;
/// The share of the chart that is behind the shown instant while the chart follows it, so that the last bars
/// are seen whole.
constexpr double kRoomBehind = 0.04;
/// A larger step of the shown instant between two ticks is a jump.
constexpr robotlink::Duration kJump = std::chrono::seconds(1);

}  // namespace

GanttCanvas::GanttCanvas(QWidget* parent) : QWidget(parent) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void GanttCanvas::setFollow(bool follow) {
  if (follows_ == follow) return;
  follows_ = follow;
  isMoved_ = true;
  Q_EMIT followChanged(follow);
}

void GanttCanvas::setSpan(double seconds) {
  span_ = std::clamp(seconds, kMinSpan, kMaxSpan);
  isMoved_ = true;
}

void GanttCanvas::place() {
  look_.size = size();
  look_.scale.left = ganttGutter(look_, QFontMetricsF(font()));
  const double width = std::max(1.0, look_.size.width() - look_.scale.left);
  look_.scale.nsPerPixel = span_ * 1e9 / width;
  if (!follows_) return;
  look_.scale.from = look_.shown - robotlink::fromSeconds(span_ * (1 - kRoomBehind));
}

void GanttCanvas::followTimeline(robotlink::Session& session) {
  const Instant before = std::exchange(look_.shown, session.timeline().shown());
  const bool live = session.timeline().live();
  if (live && !std::exchange(wasLive_, live)) setFollow(true);
  wasLive_ = live;
  if (follows_ || before == look_.shown) return;
  const bool isJump = !live || look_.shown < before || look_.shown > before + kJump;
  const double x = look_.scale.x(look_.shown);
  if (!isJump || pressed_ || (x >= look_.scale.left && x <= look_.size.width())) return;
  look_.scale.from = look_.shown - robotlink::fromSeconds(span_ / 2);
  isMoved_ = true;
}

void GanttCanvas::refresh(robotlink::Session& session, const std::string& robot,
                          const std::map<std::string, double>& periods) {
  const Instant before = look_.shown;
  followTimeline(session);
  look_.origin = session.timeline().origin();
  Contents contents{robot, session.store().generation(), 0};
  for (const auto* stream : streamsOfType(session.store(), robot, "robotcontrol.StopwatchTimes"))
    contents.messages += stream->count + stream->lookedAt;
  if (contents == contents_ && !isMoved_ && before == look_.shown) return;
  contents_ = std::move(contents);
  isMoved_ = false;
  place();
  look_.lanes = robot.empty() ? std::vector<GanttLane>()
                              : ganttLanes(session.store(), robot,
                                           {look_.scale.from, look_.scale.time(look_.size.width())}, periods);
  nameTasks();
  const int height = kGanttRuler + kMinGanttLane * static_cast<int>(look_.lanes.size());
  if (minimumHeight() != height) setMinimumHeight(height);
  place();
  update();
}

void GanttCanvas::nameTasks() {
  for (const GanttLane& lane : look_.lanes) {
    if (lane.frames.empty()) continue;
    for (const auto& entry : lane.frames.back().times->entries()) {
      const bool isKnown = std::ranges::find(look_.tasks, entry.task()) != look_.tasks.end();
      if (!entry.task().empty() && !isKnown) look_.tasks.push_back(entry.task());
    }
  }
}

void GanttCanvas::zoomAt(double x, double factor) {
  const Instant fixed = look_.scale.time(x);
  setSpan(span_ / factor);
  place();
  if (!follows_)
    look_.scale.from = fixed - robotlink::fromSeconds((x - look_.scale.left) * look_.scale.nsPerPixel / 1e9);
  update();
}

void GanttCanvas::zoom(double factor) {
  zoomAt((look_.scale.left + look_.size.width()) / 2, factor);
}

void GanttCanvas::moveBy(double pixels) {
  setFollow(false);
  look_.scale.from -= robotlink::fromSeconds(pixels * look_.scale.nsPerPixel / 1e9);
  isMoved_ = true;
  update();
}

void GanttCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintGantt(painter, look_, palette());
  if (!hasFocus()) return;
  painter.setPen(palette().color(QPalette::Highlight));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void GanttCanvas::resizeEvent(QResizeEvent*) {
  isMoved_ = true;
  place();
}

void GanttCanvas::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return event->ignore();
  pressed_ = dragged_ = event->pos();
  isDragged_ = false;
}

void GanttCanvas::mouseMoveEvent(QMouseEvent* event) {
  if (pressed_) {
    isDragged_ =
        isDragged_ || (event->pos() - *pressed_).manhattanLength() >= QApplication::startDragDistance();
    if (!isDragged_) return;
    moveBy(event->x() - dragged_.x());
    dragged_ = event->pos();
    return;
  }
  const auto hit = ganttHit(look_, event->pos());
  hit ? QToolTip::showText(event->globalPos(), ganttText(look_, *hit), this) : QToolTip::hideText();
}

void GanttCanvas::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressed_) return event->ignore();
  pressed_.reset();
  if (isDragged_ || look_.lanes.empty() || event->x() < look_.scale.left) return;
  const auto hit = ganttHit(look_, event->pos());
  const Instant time = hit ? look_.lanes[hit->lane].frames[hit->frame].time : look_.scale.time(event->x());
  setFollow(false);
  Q_EMIT jumpWanted(time);
}

void GanttCanvas::leaveEvent(QEvent*) {
  QToolTip::hideText();
}

void GanttCanvas::wheelEvent(QWheelEvent* event) {
  zoomAt(event->position().x(), std::pow(kZoomStep, event->angleDelta().y() / 120.0));
  event->accept();
}

void GanttCanvas::keyPressEvent(QKeyEvent* event) {
  const double step = (look_.size.width() - look_.scale.left) / 10;
  switch (event->key()) {
    case Qt::Key_Left:
      return moveBy(step);
    case Qt::Key_Right:
      return moveBy(-step);
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom(kZoomStep);
    case Qt::Key_Minus:
      return zoom(1 / kZoomStep);
    case Qt::Key_F:
      return setFollow(true);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace widgets
