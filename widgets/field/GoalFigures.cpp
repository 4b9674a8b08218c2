// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/GoalFigures.h"

#include <QPainter>
#include <QPalette>
#include <QPolygonF>
#include <cmath>

#include "widgets/Theme.h"

namespace widgets {
namespace {

using robotlink::Pose2;

/// A flag whose foot is the goal or, with a heading, an arrow along it.
void paintFlag(QPainter& painter, const Pose2& pose, bool anyHeading, const QColor& color,
               const QTransform& toWidget) {
  const QPointF at = toWidget.map(QPointF(pose.x, pose.y));
  painter.setPen(QPen(color, 2));
  painter.setBrush(color);
  painter.drawPolygon(QPolygonF({at + QPointF(0, -20), at + QPointF(13, -15), at + QPointF(0, -10)}));
  painter.drawLine(at, at + QPointF(0, -20));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(at, 6, 6);
  if (anyHeading) return;
  const QPointF ahead =
      toWidget.map(QPointF(pose.x + std::cos(pose.heading), pose.y + std::sin(pose.heading))) - at;
  const QPointF along = ahead / std::max(1e-9, std::hypot(ahead.x(), ahead.y()));
  const QPointF across(-along.y(), along.x());
  painter.setBrush(color);
  painter.drawLine(at + along * 6, at + along * 22);
  painter.drawPolygon(
      QPolygonF({at + along * 30, at + along * 21 + across * 5, at + along * 21 - across * 5}));
}

void paintLabel(QPainter& painter, const QPointF& at, const QString& text, const QColor& color,
                const QPalette& palette) {
  if (text.isEmpty()) return;
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
  QRectF box = QFontMetricsF(font).boundingRect(text).adjusted(-4, -1, 4, 1);
  box.moveTopLeft(at + QPointF(10, 6));
  QColor plate = palette.color(QPalette::Base);
  plate.setAlphaF(0.85);
  painter.setPen(Qt::NoPen);
  painter.setBrush(plate);
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(color);
  painter.drawText(box, Qt::AlignCenter, text);
}

void paintAim(QPainter& painter, const DriveAim& aim, const QTransform& toWidget, const QPalette& palette) {
  const QColor color = aim.blocked ? colorOf(Meaning::kBad, palette) : aim.color;
  QPolygonF path;
  for (const auto& point : aim.path) path << toWidget.map(QPointF(point.x(), point.y()));
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 2.5, Qt::DotLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(path);
  paintFlag(painter, aim.goal, aim.anyHeading, color, toWidget);
  const QString name = aim.name.isEmpty() ? QString::fromStdString(aim.robot) : aim.name;
  const QString reason = aim.reason.isEmpty() ? QObject::tr("no way") : aim.reason;
  paintLabel(
      painter, toWidget.map(QPointF(aim.goal.x, aim.goal.y)),
      aim.blocked ? QObject::tr("%1: %2", "goal, why it cannot be reached").arg(name, reason) : aim.name,
      color, palette);
}

}  // namespace

void paintGoals(QPainter& painter, const GoalFigures& goals, const QTransform& toWidget,
                const QPalette& palette) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const DriveAim& aim : goals.aims) paintAim(painter, aim, toWidget, palette);
  if (goals.wanted)
    paintFlag(painter, goals.wanted->pose, goals.wanted->anyHeading, colorOf(Meaning::kGood, palette),
              toWidget);
  painter.restore();
}

}  // namespace widgets
