// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldPainter.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QtMath>
#include <algorithm>
#include <cmath>

#include "robotlink/config/FieldDescription.h"

namespace widgets {
namespace {

using robotlink::FieldDescription;

constexpr double kNumberMargin = 0.12;  // m around everything

QColor named(const FieldDescription& field, const std::string& name) {
  const auto* color = field.color(name);
  return color != nullptr ? QColor(color->r, color->g, color->b) : QColor(Qt::gray);
}

QRectF centered(double length, double width) {
  return {-length / 2, -width / 2, length, width};
}

/// The carpet without the triangles that fill its corners.
QPainterPath surface(const FieldDescription& field) {
  const double x = field.length / 2, y = field.width / 2, side = field.cornerTriangleSide;
  QPainterPath path;
  path.moveTo(x - side, y);
  for (const QPointF& corner :
       {QPointF(-x + side, y), QPointF(-x, y - side), QPointF(-x, -y + side), QPointF(-x + side, -y),
        QPointF(x - side, -y), QPointF(x, -y + side), QPointF(x, y - side)}) {
    path.lineTo(corner);
  }
  path.closeSubpath();
  return path;
}

void paintGround(QPainter& painter, const FieldDescription& field) {
  const double walls = 2 * field.wallThickness;
  const std::string& edge = walls > 0 ? field.wallColor : field.surfaceColor;
  painter.setPen(QPen(named(field, field.surroundingsColor).darker(140), 0));
  painter.setBrush(named(field, edge));
  painter.drawRect(centered(field.length + walls, field.width + walls));
  painter.setPen(QPen(named(field, edge).darker(150), 0));
  painter.setBrush(named(field, field.surfaceColor));
  painter.drawPath(surface(field));
}

/// Lines are part of the areas that they enclose.
void paintLines(QPainter& painter, const FieldDescription& field) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(
      QPen(named(field, field.lineColor), field.lineWidth, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
  const double x = field.goalLineX(), y = field.touchLineY(), inset = field.lineWidth / 2;
  if (field.hasBoundary()) painter.drawRect(centered(2 * (x - inset), 2 * (y - inset)));
  painter.drawLine(QLineF(0, -y, 0, y));
  const double radius = field.centerCircleDiameter / 2;
  painter.drawEllipse(QPointF(), radius, radius);
  const double depth = field.penaltyAreaLength, half = field.penaltyAreaWidth / 2 - inset;
  for (const double side : {-1.0, 1.0}) {
    const double front = side * (x - depth + inset);
    painter.drawPolyline(QPolygonF({{side * x, half}, {front, half}, {front, -half}, {side * x, -half}}));
    painter.drawLine(
        QLineF(side * (x - inset), field.goalWidth / 2, side * (x - inset), -field.goalWidth / 2));
  }
}

void paintGoal(QPainter& painter, const FieldDescription& field, const FieldDescription::Goal& goal) {
  const QColor color = named(field, goal.color);
  const double back = goal.x + (goal.x < 0 ? -field.goalDepth : field.goalDepth);
  const QRectF box =
      QRectF(QPointF(goal.x, -field.goalWidth / 2), QPointF(back, field.goalWidth / 2)).normalized();
  painter.setPen(QPen(color.darker(150), 0));
  painter.setBrush(color);
  painter.drawRect(box);
  // The inside of a goal, into which one looks down, is a little darker.
  painter.setPen(Qt::NoPen);
  painter.setBrush(color.darker(118));
  constexpr double kThickness = 0.02;
  const double inward = goal.x < 0 ? kThickness : -kThickness;
  painter.drawRect(
      QRectF(QPointF(goal.x, box.top() + kThickness), QPointF(back + inward, box.bottom() - kThickness))
          .normalized());
}

/// From above only the upper band is visible, so the lower one is drawn as a ring around it.
void paintBeacon(QPainter& painter, const FieldDescription& field, const FieldDescription::Beacon& beacon) {
  const QPointF at(beacon.position.x(), beacon.position.y());
  const QColor bottom = named(field, beacon.bottomColor);
  painter.setPen(QPen(bottom.darker(170), 0));
  painter.setBrush(bottom);
  painter.drawEllipse(at, field.beaconRadius, field.beaconRadius);
  painter.setPen(Qt::NoPen);
  painter.setBrush(named(field, beacon.topColor));
  painter.drawEllipse(at, 0.58 * field.beaconRadius, 0.58 * field.beaconRadius);
}

}  // namespace

QSizeF fieldExtent(const FieldDescription& field) {
  const double goals = std::max(field.goalDepth, field.wallThickness);
  double length = field.length / 2 + goals, width = field.width / 2 + field.wallThickness;
  for (const auto& beacon : field.beacons) {
    length = std::max(length, std::abs(beacon.position.x()) + field.beaconRadius);
    width = std::max(width, std::abs(beacon.position.y()) + field.beaconRadius);
  }
  return {2 * (length + kNumberMargin), 2 * (width + kNumberMargin)};
}

void paintField(QPainter& painter, const FieldDescription& field, const QTransform& fieldToWidget) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setTransform(fieldToWidget, true);
  paintGround(painter, field);
  paintLines(painter, field);
  for (const auto& goal : field.goals) paintGoal(painter, field, goal);
  for (const auto& beacon : field.beacons) paintBeacon(painter, field, beacon);
  painter.restore();
}

void paintGroundGrid(QPainter& painter, const QSizeF& widget, const QTransform& fieldToWidget,
                     const QPalette& palette) {
  constexpr double kStep = 0.5;
  const QRectF seen = fieldToWidget.inverted().mapRect(QRectF(QPointF(), widget));
  QColor color = palette.color(QPalette::WindowText);
  color.setAlphaF(0.12);
  painter.setPen(QPen(color, 1));
  for (int i = qCeil(seen.left() / kStep); i <= qFloor(seen.right() / kStep); ++i) {
    const double x = i * kStep;
    painter.drawLine(fieldToWidget.map(QLineF(x, seen.top(), x, seen.bottom())));
  }
  for (int i = qCeil(seen.top() / kStep); i <= qFloor(seen.bottom() / kStep); ++i) {
    const double y = i * kStep;
    painter.drawLine(fieldToWidget.map(QLineF(seen.left(), y, seen.right(), y)));
  }
  color.setAlphaF(0.4);
  painter.setPen(QPen(color, 1));
  painter.drawLine(fieldToWidget.map(QLineF(seen.left(), 0, seen.right(), 0)));
  painter.drawLine(fieldToWidget.map(QLineF(0, seen.top(), 0, seen.bottom())));
}

}  // namespace widgets
