// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motions/MotionTimeLine.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "robotlink/base/Geometry.h"
#include "widgets/Controls.h"
#include "widgets/Theme.h"
#include "widgets/motions/MotionBench.h"

namespace widgets {
namespace {

using robotlink::Duration;
using robotlink::JointValue;

constexpr int kFramesMargin = 6, kGrabbedEnd = 5;
constexpr Duration kMinFramesTotal = std::chrono::milliseconds(100),
                   kDurationStep = std::chrono::milliseconds(8);
/// Angles are drawn from the lower to the upper end of what joints reach.
constexpr double kShownAngles = robotlink::radians(150);

/// A round step for the marks of a scale that is `width` pixels for `total`.
Duration frameMarkStep(Duration total, int width) {
  const Duration least = total * 60 / std::max(width, 60);
  Duration step = std::chrono::milliseconds(10);
  for (const int factor : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000, 100'000}) {
    if (step >= least) break;
    step = std::chrono::milliseconds(10) * factor;
  }
  return step;
}

}  // namespace

MotionTimeLine::MotionTimeLine(MotionBench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {
  describe(*this, {"motionTimeLine", tr("Timeline of key frames"), {}});
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  connect(&bench, &MotionBench::changed, this, qOverload<>(&QWidget::update));
  connect(&bench, &MotionBench::lineChanged, this, qOverload<>(&QWidget::update));
}

void MotionTimeLine::setPlayed(std::optional<Duration> time) {
  if (time == played_) return;
  played_ = time;
  update();
}

void MotionTimeLine::setColumn(int column) {
  if (column == column_) return;
  column_ = column;
  update();
}

Duration MotionTimeLine::endOf(int frame) const {
  const auto& place = bench_.frames()[static_cast<std::size_t>(frame)];
  return place.begin + robotlink::keyFrameAt(bench_.motion(), place).duration;
}

Duration MotionTimeLine::total() const {
  if (dragged_ >= 0) return scale_;
  const auto& frames = bench_.frames();
  return frames.empty() ? kMinFramesTotal
                        : std::max(endOf(static_cast<int>(frames.size()) - 1), kMinFramesTotal);
}

double MotionTimeLine::placeOf(Duration time) const {
  return kFramesMargin +
         robotlink::seconds(time) / robotlink::seconds(total()) * (width() - 2 * kFramesMargin);
}

Duration MotionTimeLine::timeAt(int x) const {
  const double share = double(x - kFramesMargin) / std::max(1, width() - 2 * kFramesMargin);
  return robotlink::fromSeconds(std::max(0.0, share) * robotlink::seconds(total()));
}

int MotionTimeLine::timesHeight() const {
  return fontMetrics().height() + 3;
}

int MotionTimeLine::endAt(int x) const {
  for (int frame = static_cast<int>(bench_.frames().size()) - 1; frame >= 0; --frame) {
    if (std::abs(placeOf(endOf(frame)) - x) <= kGrabbedEnd) return frame;
  }
  return -1;
}

int MotionTimeLine::frameAt(int x) const {
  const Duration time = timeAt(x);
  const int count = static_cast<int>(bench_.frames().size());
  for (int frame = 0; frame < count; ++frame) {
    if (time < endOf(frame)) return frame;
  }
  return count - 1;
}

// ---- Painting

void MotionTimeLine::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  if (bench_.frames().empty()) {
    painter.setPen(colorOf(Meaning::kMuted, palette()));
    painter.drawText(rect(), Qt::AlignCenter, bench_.isEmpty() ? QString() : tr("No key frames yet"));
    return;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  paintFrames(painter);
  paintCurves(painter);
  paintTimes(painter);
  if (played_) {
    painter.setPen(QPen(colorOf(Meaning::kWarning, palette()), 2));
    const double x = placeOf(std::min(*played_, total()));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
  }
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(palette().color(QPalette::Highlight));
    painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
  }
}

void MotionTimeLine::paintFrames(QPainter& painter) const {
  const QColor base = palette().color(QPalette::Base);
  const int selected = bench_.frame();
  for (int frame = 0; frame < static_cast<int>(bench_.frames().size()); ++frame) {
    const double begin = placeOf(bench_.frames()[static_cast<std::size_t>(frame)].begin);
    const QRectF block(QPointF(begin, timesHeight()), QPointF(placeOf(endOf(frame)), height() - 2));
    const QColor color = mixed(base, palette().color(QPalette::Text), frame % 2 == 0 ? 0.06 : 0.12);
    painter.fillRect(block,
                     frame == selected ? mixed(base, palette().color(QPalette::Highlight), 0.35) : color);
    painter.setPen(QPen(mixed(base, palette().color(QPalette::Text), 0.5), 1));
    painter.drawLine(block.topRight(), block.bottomRight());
    const QString number = QString::number(frame + 1);
    if (block.width() < fontMetrics().horizontalAdvance(number) + 4) continue;
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(block.adjusted(3, 1, -2, 0), Qt::AlignLeft | Qt::AlignTop, number);
  }
}

void MotionTimeLine::paintCurves(QPainter& painter) const {
  const double top = timesHeight() + 2, low = height() - 4;
  const auto level = [&](double angle) {
    return (top + low) / 2 - std::clamp(angle / kShownAngles, -1.0, 1.0) * (low - top) / 2;
  };
  const int columns = static_cast<int>(bench_.columns().size());
  const auto paint = [&](int column, const QPen& pen) {
    QPolygonF curve;
    for (int frame = 0; frame < static_cast<int>(bench_.frames().size()); ++frame) {
      const auto& key =
          robotlink::keyFrameAt(bench_.motion(), bench_.frames()[static_cast<std::size_t>(frame)]);
      const auto index = static_cast<std::size_t>(column);
      if (index >= key.joints.size() || key.joints[index].kind != JointValue::Kind::kAngle) continue;
      const double end = placeOf(endOf(frame)), begin = placeOf(endOf(frame) - key.duration);
      // Without interpolation, the angle jumps, and then holds.
      if (key.interpolation == 0) curve << QPointF(begin, level(key.joints[index].angle));
      curve << QPointF(end, level(key.joints[index].angle));
    }
    painter.setPen(pen);
    if (curve.size() > 1) painter.drawPolyline(curve);
    if (curve.size() == 1) painter.drawEllipse(curve.front(), 1.5, 1.5);
  };
  for (int column = 0; column < columns; ++column) {
    if (column == column_) continue;
    QColor color = curveColor(column, palette());
    color.setAlphaF(column_ < 0 ? 0.8 : 0.35);
    paint(column, QPen(color, 1));
  }
  if (column_ >= 0 && column_ < columns) paint(column_, QPen(curveColor(column_, palette()), 2.5));
}

void MotionTimeLine::paintTimes(QPainter& painter) const {
  painter.setPen(colorOf(Meaning::kMuted, palette()));
  const Duration step = frameMarkStep(total(), width());
  for (Duration time{}; time <= total(); time += step) {
    const double x = placeOf(time);
    painter.drawLine(QPointF(x, timesHeight() - 3), QPointF(x, timesHeight()));
    const QString text = tr("%1 s").arg(robotlink::seconds(time), 0, 'g', 4);
    const double wide = fontMetrics().horizontalAdvance(text);
    const double left = std::clamp(x - wide / 2, 1.0, std::max(1.0, width() - wide - 1));
    painter.drawText(QPointF(left, fontMetrics().ascent()), text);
  }
}

// ---- The user

bool MotionTimeLine::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && !bench_.frames().empty()) {
    auto* help = static_cast<QHelpEvent*>(event);
    const int frame = frameAt(help->pos().x());
    const auto& place = bench_.frames()[static_cast<std::size_t>(frame)];
    QToolTip::showText(
        help->globalPos(),
        tr("Key frame %1, line %2: from %3 s to %4 s. Drag its end to change how long it takes.")
            .arg(frame + 1)
            .arg(place.line)
            .arg(robotlink::seconds(place.begin), 0, 'f', 3)
            .arg(robotlink::seconds(endOf(frame)), 0, 'f', 3),
        this);
    return true;
  }
  return QWidget::event(event);
}

void MotionTimeLine::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || bench_.frames().empty()) return;
  const int end = endAt(event->pos().x());
  if (end >= 0) {
    scale_ = total();
    dragged_ = end;
    ++drags_;
  }
  bench_.setFrame(end >= 0 ? end : frameAt(event->pos().x()));
}

void MotionTimeLine::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_ < 0 || dragged_ >= static_cast<int>(bench_.frames().size())) {
    setCursor(endAt(event->pos().x()) >= 0 ? Qt::SizeHorCursor : Qt::ArrowCursor);
    return;
  }
  const Duration begin = bench_.frames()[static_cast<std::size_t>(dragged_)].begin;
  const Duration wanted = std::max(timeAt(event->pos().x()) - begin, kDurationStep);
  static_cast<void>(bench_.setDuration(dragged_, wanted, "drag " + std::to_string(drags_)));
}

void MotionTimeLine::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  dragged_ = -1;
  update();
}

void MotionTimeLine::keyPressEvent(QKeyEvent* event) {
  const int by = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  const int selected = bench_.frame();
  if (by == 0 || selected < 0) return QWidget::keyPressEvent(event);
  if (!event->modifiers().testFlag(Qt::ControlModifier)) return bench_.setFrame(selected + by);
  const auto& key =
      robotlink::keyFrameAt(bench_.motion(), bench_.frames()[static_cast<std::size_t>(selected)]);
  static_cast<void>(bench_.setDuration(selected, std::max(key.duration + by * kDurationStep, kDurationStep),
                                       "keys " + std::to_string(selected)));
}

}  // namespace widgets
