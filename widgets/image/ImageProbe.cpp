// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageProbe.h"

#include <QCoreApplication>
#include <QTransform>

#include "foxglove/Image.pb.h"

namespace widgets {
namespace {

using foxglove::ImageAnnotations;

QString pixelText(const foxglove::Point2& point) {
  return QStringLiteral("(%1, %2)").arg(point.x(), 0, 'f', 1).arg(point.y(), 0, 'f', 1);
}

int pointsOf(const ImageAnnotations& drawing) {
  int count = drawing.circles_size() + drawing.texts_size();
  for (const auto& points : drawing.points()) count += points.points_size();
  return count;
}

/// The parts of one drawing that are painted at a place.
class PartsAt {
 public:
  PartsAt(const QTransform& toWidget, const QPointF& at) : toWidget_(toWidget), at_(at) {}

  bool isPainted(const ImageAnnotations& drawing) const {
    return paintsAt(at_, [&](QPainter& painter) { paintAnnotations(painter, drawing, toWidget_); });
  }

  QStringList values(const ImageAnnotations& drawing) const {
    QStringList values;
    for (const auto& text : drawing.texts()) {
      ImageAnnotations part;
      *part.add_texts() = text;
      if (values.size() < kMaxTipValues && isPainted(part)) values << QString::fromStdString(text.text());
    }
    for (const auto& circle : drawing.circles()) {
      ImageAnnotations part;
      *part.add_circles() = circle;
      if (values.size() < kMaxTipValues && isPainted(part))
        values << QCoreApplication::translate("DrawingTip", "circle at %1, diameter %2")
                      .arg(pixelText(circle.position()))
                      .arg(circle.diameter(), 0, 'f', 1);
    }
    for (const auto& points : drawing.points()) {
      ImageAnnotations part;
      *part.add_points() = points;
      if (values.size() < kMaxTipValues && isPainted(part)) values << nearest(points);
    }
    return values;
  }

 private:
  QString nearest(const foxglove::PointsAnnotation& points) const {
    const foxglove::Point2* found = nullptr;
    double distance = 0;
    for (const auto& point : points.points()) {
      const QPointF by = toWidget_.map(QPointF(point.x(), point.y())) - at_;
      const double other = QPointF::dotProduct(by, by);
      if (found != nullptr && !(other < distance)) continue;
      found = &point;
      distance = other;
    }
    return found == nullptr ? QString()
                            : QCoreApplication::translate("DrawingTip", "point %1").arg(pixelText(*found));
  }

  QTransform toWidget_;
  QPointF at_;
};

}  // namespace

std::vector<DrawingHit> drawingsAt(const ImagePicture& picture, const ImageViewport& viewport,
                                   const QSizeF& widget, const QPointF& at) {
  std::vector<DrawingHit> hits;
  if (picture.pixels.isNull()) return hits;
  const PartsAt parts(drawingsToWidget(picture, viewport, widget), at);
  int examined = 0;
  for (auto drawing = picture.drawings.rbegin(); drawing != picture.drawings.rend(); ++drawing) {
    examined += pointsOf(*drawing->annotations);
    if (examined > kMaxTipPoints || hits.size() >= kMaxTipDrawings) break;
    if (drawing->id.isEmpty() || !parts.isPainted(*drawing->annotations)) continue;
    hits.push_back({drawing->id, drawing->robot, parts.values(*drawing->annotations)});
  }
  return hits;
}

}  // namespace widgets
