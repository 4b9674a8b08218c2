// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/RadarCanvas.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/Sentence.h"
#include "widgets/field/GroundDrawing.h"
#include "widgets/field/GroundProbe.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {

RadarCanvas::RadarCanvas(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("radarCanvas"));
  setAccessibleName(tr("Radar"));
  setToolTip(
      tr("The robot's surroundings. Blue: sonars, older ones paler; "
         "orange: laser; red: pressed bumpers and stalled wheels; "
         "green: where it drives in the next second. Wheel: zoom"));
  setToolTipDuration(5000);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumSize(120, 120);
}

void RadarCanvas::show(RadarReadings readings, std::vector<WorldDrawing> drawings, const QString& hint) {
  readings_ = std::move(readings);
  drawings_ = std::move(drawings);
  hint_ = hint;
  update();
}

RadarLook RadarCanvas::look() const {
  RadarLook look = look_;
  look.size = size();
  return look;
}

void RadarCanvas::setRange(double meters) {
  const double range = std::clamp(meters, RadarLook::kMinRange, RadarLook::kMaxRange);
  if (range == look_.range) return;
  look_.range = range;
  update();
  Q_EMIT lookChanged();
}

void RadarCanvas::setNorthUp(bool northUp) {
  look_.northUp = northUp;
  update();
  Q_EMIT lookChanged();
}

void RadarCanvas::paintContents(QPainter& painter) const {
  paintRadar(painter, readings_, look(), palette());
  const QTransform toWidget = robotToWidget(look(), readings_.heading);
  paintFromAbove(painter, drawings_, toWidget);
}

QImage RadarCanvas::rendered() const {
  return paintedPicture(*this, [this](QPainter& painter) { paintContents(painter); });
}

bool RadarCanvas::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  const auto hits = drawingsAt(drawings_, robotToWidget(look(), readings_.heading), QPointF(help.pos()));
  return showDrawingTip(*this, help, hits) || QWidget::event(event);
}

void RadarCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  paintContents(painter);
  if (!hint_.isEmpty()) paintSentence(painter, *this, hint_, SentencePlace::kMiddle);
}

void RadarCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPointF at = robotToWidget(look(), readings_.heading).inverted().map(event->localPos());
  Q_EMIT cursorMoved(std::hypot(at.x(), at.y()), std::atan2(at.y(), at.x()), true);
}

void RadarCanvas::wheelEvent(QWheelEvent* event) {
  zoomBy(std::pow(1.2, event->angleDelta().y() / 120.0));
  event->accept();
}

void RadarCanvas::leaveEvent(QEvent*) {
  Q_EMIT cursorMoved(0, 0, false);
}

}  // namespace widgets
