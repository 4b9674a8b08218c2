// SPDX-License-Identifier: GPL-3.0-or-later
// paintGizmo() of Gizmo.h.
#include <QPainter>
#include <algorithm>
#include <array>

#include "widgets/scene/gizmo/Gizmo.h"

namespace widgets {
namespace {

const QColor& axisColor(int axis) {
  static const std::array<QColor, 3> kColors{QColor(232, 72, 60), QColor(80, 190, 90), QColor(90, 150, 250)};
  return kColors[static_cast<std::size_t>(axis)];
}

void paintArrow(QPainter& painter, const QPointF& from, const QPointF& to) {
  painter.drawLine(from, to);
  const QLineF line(from, to);
  const QLineF unit = line.unitVector();
  const QPointF along = unit.p2() - unit.p1(), across(-along.y(), along.x());
  painter.drawPolygon(QPolygonF(QVector<QPointF>{to + 9 * along, to + 4.5 * across, to - 4.5 * across}));
}

}  // namespace

void paintGizmo(QPainter& painter, const Gizmo& gizmo, const SceneCamera& camera, const QSizeF& widget,
                GizmoHandle hot) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const GizmoHandle handle : kGizmoHandles) {
    const QPolygonF outline = gizmoOutline(gizmo, handle, camera, widget);
    if (outline.isEmpty()) continue;
    const GizmoAxes of = axesOf(handle);
    QColor color = of.second >= 0 ? axisColor(of.normal()) : axisColor(of.first);
    if (handle == hot) color = QColor(255, 214, 70);
    // A dark rim, so that the handles are seen on every ground.
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 110), of.isTurn ? 3.4 : 5, Qt::SolidLine, Qt::RoundCap));
    if (of.second < 0) painter.drawPolyline(outline);
    painter.setPen(QPen(color, handle == hot ? 3 : 2, Qt::SolidLine, Qt::RoundCap));
    if (of.second >= 0) {
      QColor area = color;
      area.setAlpha(handle == hot ? 190 : 110);
      painter.setBrush(area);
      painter.drawPolygon(outline);
    } else if (of.isTurn) {
      painter.drawPolyline(outline);
    } else {
      painter.setBrush(color);
      paintArrow(painter, outline[0], outline[1]);
    }
  }
  painter.restore();
}

}  // namespace widgets
