// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneOverlay.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/drawings/MessageFonts.h"
#include "widgets/scene/render/SceneFrame.h"

namespace widgets {
namespace {

using robotlink::Vector3;

double pixelSize(const SceneLabel& label, const QSizeF& widget, const SceneCamera& camera) {
  if (label.size > 0) return label.size;
  const double distance = std::max(0.05, (label.inField - camera.position()).norm());
  return -label.size * widget.height() / 2 / std::tan(camera.verticalAngle / 2) / distance;
}

void paintPlate(QPainter& painter, const QPointF& at, const SceneLabel& label) {
  QRectF box = QFontMetricsF(painter.font()).boundingRect(label.text).adjusted(-5, -1, 5, 1);
  box.moveCenter(at);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 135));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(label.color);
  painter.drawText(box, Qt::AlignCenter, label.text);
}

/// Paints a label with a dark rim, so that the text is legible on every color.
void paintPlain(QPainter& painter, const QPointF& at, const SceneLabel& label) {
  QPainterPath path;
  path.addText(at, painter.font(), label.text);
  const QColor rim(0, 0, 0, 150 * label.color.alpha() / 255);
  painter.strokePath(path, QPen(rim, 2.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, label.color);
}

}  // namespace

void paintLabels(QPainter& painter, const QSizeF& widget, const SceneCamera& camera,
                 const std::vector<SceneLabel>& labels) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const SceneLabel& label : labels) {
    const auto at = camera.project(widget, label.inField);
    const double size = pixelSize(label, widget, camera);
    if (!at || !(size >= 4)) continue;
    QFont font = painter.font();
    font.setPixelSize(fontPixels(size));
    painter.setFont(font);
    label.boxed ? paintPlate(painter, *at, label) : paintPlain(painter, *at, label);
  }
  painter.restore();
}

void paintAxes(QPainter& painter, const QSizeF& widget, const SceneCamera& camera) {
  constexpr double kLength = 24;
  const QPointF origin(36, widget.height() - 36);
  const Eigen::Matrix3d toCamera = camera.view().block<3, 3>(0, 0);
  const std::array<QColor, 3> colors{QColor(222, 70, 60), QColor(70, 170, 80), QColor(80, 140, 235)};
  std::array<int, 3> order{0, 1, 2};
  // The axis that points toward the viewer is painted last.
  std::ranges::sort(order, {}, [&](int axis) { return toCamera(2, axis); });
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(11);
  font.setBold(true);
  painter.setFont(font);
  for (const int axis : order) {
    const QPointF direction(toCamera(0, axis), -toCamera(1, axis));
    painter.setPen(QPen(colors[static_cast<std::size_t>(axis)], 2.2, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(origin, origin + kLength * direction);
    if (std::hypot(direction.x(), direction.y()) < 0.25) continue;
    QRectF box(0, 0, 14, 14);
    box.moveCenter(origin + (kLength + 8) * direction);
    painter.drawText(box, Qt::AlignCenter, QString(QLatin1Char("xyz"[axis])));
  }
  painter.restore();
}

}  // namespace widgets
