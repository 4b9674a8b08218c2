// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/picture/Measurement.h"

#include <QLineF>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kCross = 5;      // pixels from a point to the end of its cross
constexpr int kMeasureFont = 12;  // pixels

/// A text on a box that is legible on any picture.
void paintTag(QPainter& painter, const QPointF& at, const QString& text, const QSizeF& widget) {
  if (text.isEmpty()) return;
  QRectF box = QFontMetricsF(painter.font()).boundingRect(text).adjusted(-5, -2, 5, 2);
  box.moveCenter(at);
  box.moveLeft(std::clamp(box.left(), 2.0, std::max(2.0, widget.width() - box.width() - 2)));
  box.moveTop(std::clamp(box.top(), 2.0, std::max(2.0, widget.height() - box.height() - 2)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(box, 3, 3);
  painter.setPen(Qt::white);
  painter.drawText(box, Qt::AlignCenter, text);
}

/// Lines twice, so that they are seen on light and dark pictures.
template <typename Paint>
void paintOutlined(QPainter& painter, Paint paint) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 170), 4, Qt::SolidLine, Qt::RoundCap));
  paint();
  painter.setPen(QPen(QColor(255, 230, 60), 1.8, Qt::SolidLine, Qt::RoundCap));
  paint();
}

void paintArc(QPainter& painter, const std::vector<QPointF>& points) {
  const QLineF one(points[1], points[0]), other(points[1], points[2]);
  const double radius = std::min({28.0, one.length(), other.length()});
  double span = one.angleTo(other);
  if (span > 180) span -= 360;
  const QRectF circle(points[1] - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
  paintOutlined(painter, [&] {
    painter.drawArc(circle, static_cast<int>(std::lround(one.angle() * 16)),
                    static_cast<int>(std::lround(span * 16)));
  });
}

}  // namespace

double angleAt(const std::vector<QPointF>& points) {
  if (points.size() < 3) return 0;
  const QPointF one = points[0] - points[1], other = points[2] - points[1];
  const double cross = one.x() * other.y() - one.y() * other.x();
  return std::abs(std::atan2(cross, QPointF::dotProduct(one, other)));
}

double directionDeg(const QPointF& from, const QPointF& to, bool yDown) {
  const QPointF by = to - from;
  if (by.isNull()) return 0;
  const double degrees = std::atan2(yDown ? -by.y() : by.y(), by.x()) * 180 / M_PI;
  return degrees <= -180 ? 180 : degrees;
}

void paintMeasurement(QPainter& painter, const std::vector<QPointF>& points, const MeasureText& text,
                      const QSizeF& widget, const QPalette&) {
  if (points.empty()) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  paintOutlined(painter, [&] {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i > 0) painter.drawLine(points[i - 1], points[i]);
      painter.drawLine(points[i] - QPointF(kCross, 0), points[i] + QPointF(kCross, 0));
      painter.drawLine(points[i] - QPointF(0, kCross), points[i] + QPointF(0, kCross));
    }
  });
  if (points.size() > 2) paintArc(painter, points);
  QFont font = painter.font();
  font.setPixelSize(kMeasureFont);
  painter.setFont(font);
  for (int i = 0; i < text.segments.size() && i + 1 < static_cast<int>(points.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const QPointF middle = (points[at] + points[at + 1]) / 2;
    paintTag(painter, middle - QPointF(0, 14), text.segments[i], widget);
  }
  if (points.size() > 2) paintTag(painter, points[1] + QPointF(0, 22), text.angle, widget);
  painter.restore();
}

}  // namespace widgets
