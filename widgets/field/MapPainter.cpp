// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/MapPainter.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <algorithm>
#include <cmath>

#include "robotcontrol/Driving.pb.h"
#include "widgets/Theme.h"
#include "widgets/field/FieldViewport.h"

namespace widgets {
namespace {

using robotcontrol::GroundMap;
using Place = GroundMap::Place;

constexpr double kMapMargin = 0.5;     // m around everything
constexpr double kPointsApart = 0.02;  // m between the points of a wall
constexpr double kNamesFrom = 4;       // pixels for a meter: below that names would only cover each other
constexpr int kSmallestPoint = 2;      // pixels: fewer would make walls gray

/// NaN and infinite numbers may be in foreign files.
bool isFinite(double x, double y) {
  return std::isfinite(x) && std::isfinite(y);
}

class Bounds {
 public:
  void add(double x, double y) {
    if (!isFinite(x, y)) return;
    low_ = {std::min(low_.x(), x), std::min(low_.y(), y)};
    high_ = {std::max(high_.x(), x), std::max(high_.y(), y)};
  }
  bool empty() const { return low_.x() > high_.x(); }
  QRectF rect() const { return {low_, high_}; }

 private:
  QPointF low_{1e300, 1e300}, high_{-1e300, -1e300};
};

bool isSpot(const Place& place) {
  return place.kind() != Place::FORBIDDEN_LINE && place.kind() != Place::FORBIDDEN_AREA;
}

void paintMapPoints(QImage& image, const GroundMap& map, const QTransform& toPixels, QRgb color) {
  const int side =
      std::clamp(static_cast<int>(std::lround(kPointsApart * scaleOf(toPixels))), kSmallestPoint, 64);
  const double half = side / 2.0;
  const int width = image.width(), height = image.height();
  const int perLine = image.bytesPerLine() / 4;
  auto* pixels = reinterpret_cast<QRgb*>(image.bits());
  for (int i = 0; i + 1 < map.points_size(); i += 2) {
    const double x = map.points(i), y = map.points(i + 1);
    const double left = toPixels.m11() * x + toPixels.m21() * y + toPixels.dx() - half;
    const double top = toPixels.m12() * x + toPixels.m22() * y + toPixels.dy() - half;
    if (!(left > -side && top > -side && left < width && top < height)) continue;
    const int column = static_cast<int>(std::floor(left)), row = static_cast<int>(std::floor(top));
    const int first = std::max(0, column), last = std::min(width, column + side);
    for (int line = std::max(0, row); line < std::min(height, row + side); ++line)
      std::fill(pixels + line * perLine + first, pixels + line * perLine + std::max(first, last), color);
  }
}

void paintForbidden(QPainter& painter, const Place& place, const QTransform& toWidget,
                    const QPalette& palette) {
  const QColor warning = colorOf(Meaning::kWarning, palette);
  const auto& extent = place.extent();
  if (!isFinite(extent.x1() + extent.x2(), extent.y1() + extent.y2())) return;
  painter.setPen(QPen(warning, 2, Qt::DashLine, Qt::FlatCap));
  if (place.kind() == Place::FORBIDDEN_LINE) {
    painter.drawLine(toWidget.map(QLineF(extent.x1(), extent.y1(), extent.x2(), extent.y2())));
    return;
  }
  QTransform turned = toWidget;
  turned.rotateRadians(place.pose().heading());
  QColor area = warning;
  area.setAlphaF(0.4);
  painter.setBrush(QBrush(area, Qt::BDiagPattern));
  const QRectF corners =
      QRectF(QPointF(extent.x1(), extent.y1()), QPointF(extent.x2(), extent.y2())).normalized();
  painter.drawPolygon(turned.map(QPolygonF(corners)));
  painter.setBrush(Qt::NoBrush);
}

QString placeLabel(const Place& place) {
  if (!place.name().empty()) return QString::fromStdString(place.name());
  if (place.kind() == Place::HOME) return QObject::tr("Home", "place of a map");
  if (place.kind() == Place::DOCK) return QObject::tr("Dock", "place of a map");
  return {};
}

void paintSign(QPainter& painter, const Place& place, const QPointF& at, const QTransform& toWidget) {
  if (place.kind() == Place::HOME) {
    const QPolygonF house({at + QPointF(-5, 5), at + QPointF(-5, -1), at + QPointF(0, -6),
                           at + QPointF(5, -1), at + QPointF(5, 5)});
    painter.drawPolygon(house);
  } else if (place.kind() == Place::DOCK) {
    painter.drawRect(QRectF(at - QPointF(5, 5), QSizeF(10, 10)));
  } else {
    painter.drawEllipse(at, 4, 4);
  }
  if (!place.has_heading()) return;
  const double heading = place.pose().heading();
  const QPointF ahead =
      toWidget.map(QPointF(place.pose().x() + std::cos(heading), place.pose().y() + std::sin(heading))) - at;
  painter.drawLine(at, at + ahead * (14 / std::max(1e-9, std::hypot(ahead.x(), ahead.y()))));
}

void paintSpot(QPainter& painter, const Place& place, const QTransform& toWidget, const QPalette& palette,
               bool highlighted) {
  const QPointF at = toWidget.map(QPointF(place.pose().x(), place.pose().y()));
  if (!isFinite(at.x(), at.y())) return;
  const QColor color = colorOf(place.kind() == Place::GOAL ? Meaning::kNote : Meaning::kMuted, palette);
  QColor area = color;
  area.setAlphaF(highlighted ? 0.7 : 0.25);
  painter.setPen(QPen(color, highlighted ? 3 : 1.6));
  painter.setBrush(area);
  paintSign(painter, place, at, toWidget);
  if (scaleOf(toWidget) < kNamesFrom && !highlighted) return;
  QFont font = painter.font();
  font.setPixelSize(11);
  font.setBold(highlighted);
  painter.setFont(font);
  painter.setPen(highlighted ? palette.color(QPalette::Text) : color);
  painter.drawText(at + QPointF(9, 4), placeLabel(place));
}

}  // namespace

QRectF mapExtent(const GroundMap& map) {
  Bounds bounds;
  for (const auto& line : map.lines()) {
    bounds.add(line.x1(), line.y1());
    bounds.add(line.x2(), line.y2());
  }
  for (int i = 0; i + 1 < map.points_size(); i += 2) bounds.add(map.points(i), map.points(i + 1));
  if (bounds.empty()) {
    for (const auto& place : map.places()) bounds.add(place.pose().x(), place.pose().y());
  }
  const QRectF rect = bounds.empty() ? QRectF(-5, -5, 10, 10) : bounds.rect();
  return rect.adjusted(-kMapMargin, -kMapMargin, kMapMargin, kMapMargin);
}

void paintWalls(QImage& image, const GroundMap& map, const QTransform& toPixels, const QColor& color) {
  paintMapPoints(image, map, toPixels, qPremultiply(color.rgba()));
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(
      QPen(color, std::clamp(kPointsApart * scaleOf(toPixels), 2.0, 8.0), Qt::SolidLine, Qt::RoundCap));
  const QRectF seen(-8, -8, image.width() + 16, image.height() + 16);
  for (const auto& line : map.lines()) {
    if (!isFinite(line.x1() + line.x2(), line.y1() + line.y2())) continue;
    const QLineF mapped = toPixels.map(QLineF(line.x1(), line.y1(), line.x2(), line.y2()));
    // A line along an axis has no area, so QRectF::intersects() needs a margin.
    const QRectF box = QRectF(mapped.p1(), mapped.p2()).normalized().adjusted(-1, -1, 1, 1);
    if (box.intersects(seen)) painter.drawLine(mapped);
  }
}

void paintPlaces(QPainter& painter, const GroundMap& map, const QTransform& toWidget, const QPalette& palette,
                 int highlighted) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Place& place : map.places()) {
    if (!isSpot(place)) paintForbidden(painter, place, toWidget, palette);
  }
  for (int i = 0; i < map.places_size(); ++i) {
    if (isSpot(map.places(i))) paintSpot(painter, map.places(i), toWidget, palette, i == highlighted);
  }
  painter.restore();
}

int placeAt(const GroundMap& map, const QTransform& toWidget, const QPointF& at, double tolerance) {
  int nearest = -1;
  for (int i = 0; i < map.places_size(); ++i) {
    const Place& place = map.places(i);
    if (!isSpot(place)) continue;
    const QPointF off = toWidget.map(QPointF(place.pose().x(), place.pose().y())) - at;
    const double distance = std::hypot(off.x(), off.y());
    if (!(distance <= tolerance)) continue;
    tolerance = distance;
    nearest = i;
  }
  return nearest;
}

MapGround::MapGround(std::shared_ptr<const GroundMap> map)
    : map_(std::move(map)), extent_(mapExtent(*map_)) {}

void MapGround::paint(QPainter& painter, const QSize& widget, const QTransform& toWidget,
                      const QPalette& palette, double ratio, int highlighted) const {
  painter.fillRect(QRect(QPoint(), widget), palette.color(QPalette::Base));
  const QColor color = mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.15);
  const QSize pixels = (QSizeF(widget) * ratio).toSize();
  if (walls_.size() != pixels || paintedFor_ != toWidget || color_ != color.rgba()) {
    if (walls_.size() != pixels) walls_ = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
    walls_.setDevicePixelRatio(1);
    walls_.fill(Qt::transparent);
    paintWalls(walls_, *map_, toWidget * QTransform::fromScale(ratio, ratio), color);
    walls_.setDevicePixelRatio(ratio);
    paintedFor_ = toWidget;
    color_ = color.rgba();
  }
  if (!walls_.isNull()) painter.drawImage(QPointF(), walls_);
  paintPlaces(painter, *map_, toWidget, palette, highlighted);
}

}  // namespace widgets
