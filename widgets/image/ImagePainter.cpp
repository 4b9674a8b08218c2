// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImagePainter.h"

#include <QPainter>
#include <QPolygonF>
#include <QtMath>
#include <algorithm>

#include "foxglove/Image.pb.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/drawings/MessageColors.h"
#include "widgets/drawings/MessageFonts.h"

namespace widgets {
namespace {

using foxglove::PointsAnnotation;

constexpr double kGridZoom = 12;  // from this zoom on there is room for lines between pixels

QPointF qPoint(const foxglove::Point2& point) {
  return {point.x(), point.y()};
}

QPen screenPen(const foxglove::Color& color, double thickness, Qt::PenStyle style) {
  QPen pen(qColor(color), std::max(1.0, thickness), style, Qt::RoundCap, Qt::RoundJoin);
  if (color.a() <= 0) pen.setStyle(Qt::NoPen);
  return pen;
}

QBrush fillBrush(const foxglove::Color& color) {
  return color.a() > 0 ? QBrush(qColor(color)) : QBrush(Qt::NoBrush);
}

void paintCircle(QPainter& painter, const foxglove::CircleAnnotation& circle, const QTransform& toWidget,
                 Qt::PenStyle style) {
  painter.setPen(screenPen(circle.outline_color(), circle.thickness(), style));
  painter.setBrush(fillBrush(circle.fill_color()));
  const double radius = circle.diameter() / 2 * toWidget.m11();
  painter.drawEllipse(toWidget.map(qPoint(circle.position())), radius, radius);
}

/// The color of the i-th point or segment: its own if there is one for each, else the common one.
const foxglove::Color& pointColorOf(const PointsAnnotation& points, int i) {
  return i < points.outline_colors_size() ? points.outline_colors(i) : points.outline_color();
}

void paintDots(QPainter& painter, const PointsAnnotation& points, const QPolygonF& at) {
  const double radius = std::max(1.0, points.thickness()) / 2;
  painter.setPen(Qt::NoPen);
  for (int i = 0; i < at.size(); ++i) {
    painter.setBrush(qColor(pointColorOf(points, i)));
    painter.drawEllipse(at[i], radius, radius);
  }
}

void paintSegments(QPainter& painter, const PointsAnnotation& points, const QPolygonF& at,
                   Qt::PenStyle style) {
  const bool strip = points.type() == PointsAnnotation::LINE_STRIP;
  for (int i = 0, segment = 0; i + 1 < at.size(); i += strip ? 1 : 2, ++segment) {
    painter.setPen(screenPen(pointColorOf(points, segment), points.thickness(), style));
    painter.drawLine(at[i], at[i + 1]);
  }
}

void paintPoints(QPainter& painter, const PointsAnnotation& points, const QTransform& toWidget,
                 Qt::PenStyle style) {
  QPolygonF at;
  for (const auto& point : points.points()) at << toWidget.map(qPoint(point));
  switch (points.type()) {
    case PointsAnnotation::POINTS:
      paintDots(painter, points, at);
      break;
    case PointsAnnotation::LINE_LOOP:
      painter.setPen(screenPen(points.outline_color(), points.thickness(), style));
      painter.setBrush(fillBrush(points.fill_color()));
      painter.drawPolygon(at);
      break;
    case PointsAnnotation::LINE_STRIP:
    case PointsAnnotation::LINE_LIST:
      paintSegments(painter, points, at, style);
      break;
    default:
      break;
  }
}

void paintText(QPainter& painter, const foxglove::TextAnnotation& text, const QTransform& toWidget) {
  QFont font = painter.font();
  font.setPixelSize(fontPixels(text.font_size()));
  painter.setFont(font);
  const QString string = QString::fromStdString(text.text());
  const QPointF at = toWidget.map(qPoint(text.position()));
  if (text.background_color().a() > 0) {
    const QRectF box = QFontMetricsF(font).boundingRect(string).translated(at).adjusted(-2, -1, 2, 1);
    painter.fillRect(box, qColor(text.background_color()));
  }
  painter.setPen(qColor(text.text_color()));
  painter.drawText(at, string);
}

void paintGrid(QPainter& painter, const QRectF& visible, const QTransform& toWidget) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(QColor(128, 128, 128, 90), 1));
  for (int x = qFloor(visible.left()); x <= visible.right(); ++x) {
    painter.drawLine(toWidget.map(QPointF(x, visible.top())), toWidget.map(QPointF(x, visible.bottom())));
  }
  for (int y = qFloor(visible.top()); y <= visible.bottom(); ++y) {
    painter.drawLine(toWidget.map(QPointF(visible.left(), y)), toWidget.map(QPointF(visible.right(), y)));
  }
}

void paintPixels(QPainter& painter, const QImage& pixels, const QRectF& widget, const QTransform& toWidget) {
  const double zoom = toWidget.m11();
  painter.setRenderHint(QPainter::SmoothPixmapTransform, zoom < 1);
  painter.drawImage(toWidget.mapRect(QRectF(pixels.rect())), pixels);
  if (zoom < kGridZoom) return;
  paintGrid(painter, toWidget.inverted().mapRect(widget).intersected(QRectF(pixels.rect())), toWidget);
}

}  // namespace

void paintAnnotations(QPainter& painter, const foxglove::ImageAnnotations& drawing,
                      const QTransform& imageToWidget, Qt::PenStyle style) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& circle : drawing.circles()) paintCircle(painter, circle, imageToWidget, style);
  for (const auto& points : drawing.points()) paintPoints(painter, points, imageToWidget, style);
  for (const auto& text : drawing.texts()) paintText(painter, text, imageToWidget);
  painter.restore();
}

QTransform drawingsToWidget(const ImagePicture& picture, const ImageViewport& viewport,
                            const QSizeF& widget) {
  QTransform toPixels;
  if (!picture.drawnOn.isEmpty())
    toPixels.scale(static_cast<double>(picture.pixels.width()) / picture.drawnOn.width(),
                   static_cast<double>(picture.pixels.height()) / picture.drawnOn.height());
  return toPixels * imageToWidget(viewport, picture.pixels.size(), widget);
}

void paintPicture(QPainter& painter, const QSizeF& widget, const ImagePicture& picture,
                  const ImageViewport& viewport) {
  if (picture.pixels.isNull()) return;
  const QTransform toWidget = imageToWidget(viewport, picture.pixels.size(), widget);
  painter.save();
  painter.setClipRect(QRectF(QPointF(), widget), Qt::IntersectClip);
  paintPixels(painter, picture.pixels, QRectF(QPointF(), widget), toWidget);
  const QTransform drawingsIn = drawingsToWidget(picture, viewport, widget);
  for (const ImagePicture::Drawing& drawing : picture.drawings) {
    painter.setOpacity(drawingOpacity(drawing.id, drawing.old));
    paintAnnotations(painter, *drawing.annotations, drawingsIn,
                     isDrawnInShadow(drawing.id) ? Qt::DashLine : Qt::SolidLine);
  }
  painter.restore();
}

void paintCaption(QPainter& painter, const QRectF& pane, const QString& text) {
  if (text.isEmpty()) return;
  painter.save();
  const QFontMetricsF metrics(painter.font());
  const double width = std::max(0.0, pane.width() - 20);
  QStringList words = text.split(QLatin1Char(' '));
  for (QString& word : words) word = metrics.elidedText(word, Qt::ElideMiddle, width);
  constexpr int kFlags = Qt::AlignLeft | Qt::TextWordWrap;
  const QString shown = words.join(QLatin1Char(' '));
  QRectF box = metrics.boundingRect(QRectF(0, 0, width, pane.height()), kFlags, shown);
  box.moveTopLeft(pane.topLeft() + QPointF(9, 6));
  painter.setClipRect(pane, Qt::IntersectClip);
  painter.fillRect(box.adjusted(-5, -2, 5, 2), QColor(0, 0, 0, 170));
  painter.setPen(Qt::white);
  painter.drawText(box, kFlags, shown);
  painter.restore();
}

}  // namespace widgets
