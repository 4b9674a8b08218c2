// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/GroundProbe.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

#include "foxglove/Scene.pb.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/field/GroundDrawing.h"

namespace widgets {
namespace {

using foxglove::SceneEntity;
using robotlink::Pose3;
using robotlink::Vector3;

int pointsOf(const SceneEntity& entity) {
  int count = entity.cubes_size() + entity.spheres_size() + entity.cylinders_size() + entity.arrows_size() +
              entity.texts_size();
  for (const auto& lines : entity.lines()) count += lines.points_size() + lines.indices_size();
  for (const auto& list : entity.triangles()) count += list.points_size() + list.indices_size();
  return count;
}

/// The parts of one drawing that are painted at a place.
class PartsFromAbove {
 public:
  PartsFromAbove(const Pose3& frameInField, const QTransform& toWidget, const QPointF& at)
      : frame_(frameInField), toWidget_(toWidget), at_(at) {}

  bool isPainted(const SceneEntity& entity) const {
    return paintsAt(at_, [&](QPainter& painter) { paintFromAbove(painter, entity, frame_, toWidget_); });
  }

  QStringList values(const SceneEntity& entity) const {
    QStringList values;
    for (const auto& text : entity.texts()) {
      SceneEntity part;
      *part.add_texts() = text;
      if (values.size() < kMaxTipValues && isPainted(part)) values << QString::fromStdString(text.text());
    }
    addPlaces(entity.spheres(), &SceneEntity::add_spheres, values);
    addPlaces(entity.cylinders(), &SceneEntity::add_cylinders, values);
    addPlaces(entity.cubes(), &SceneEntity::add_cubes, values);
    addPlaces(entity.arrows(), &SceneEntity::add_arrows, values);
    for (const auto& fill : entity.triangles()) {
      SceneEntity part;
      *part.add_triangles() = fill;
      if (values.size() < kMaxTipValues && isPainted(part)) values << center(fill);
    }
    for (const auto& lines : entity.lines()) {
      SceneEntity part;
      *part.add_lines() = lines;
      if (values.size() < kMaxTipValues && isPainted(part)) values << nearest(lines);
    }
    return values;
  }

 private:
  template <typename Parts, typename Part>
  void addPlaces(const Parts& parts, Part* (SceneEntity::*add)(), QStringList& values) const {
    for (const Part& each : parts) {
      SceneEntity part;
      *(part.*add)() = each;
      if (values.size() < kMaxTipValues && isPainted(part))
        values << QCoreApplication::translate("DrawingTip", "at %1")
                      .arg(worldPlaceText(frame_ * robotlink::pose3(each.pose()).translation()));
    }
  }

  /// For filled shapes, such as dots and discs.
  QString center(const foxglove::TriangleListPrimitive& fill) const {
    Vector3 sum = Vector3::Zero();
    for (const auto& point : fill.points()) sum += Vector3(point.x(), point.y(), point.z());
    const Vector3 mean = sum / std::max(1, fill.points_size());
    return QCoreApplication::translate("DrawingTip", "at %1")
        .arg(worldPlaceText(frame_ * (robotlink::pose3(fill.pose()) * mean)));
  }

  QString nearest(const foxglove::LinePrimitive& lines) const {
    const Pose3 inField = frame_ * robotlink::pose3(lines.pose());
    std::optional<Vector3> found;
    double distance = 0;
    for (const auto& point : lines.points()) {
      const Vector3 place = inField * Vector3(point.x(), point.y(), point.z());
      const QPointF by = toWidget_.map(QPointF(place.x(), place.y())) - at_;
      const double other = QPointF::dotProduct(by, by);
      if (found && !(other < distance)) continue;
      found = place;
      distance = other;
    }
    return found ? QCoreApplication::translate("DrawingTip", "point %1").arg(worldPlaceText(*found))
                 : QString();
  }

  const Pose3& frame_;
  const QTransform& toWidget_;
  QPointF at_;
};

}  // namespace

QString worldPlaceText(const Vector3& place) {
  return QStringLiteral("(%1, %2, %3) m")
      .arg(place.x(), 0, 'f', 3)
      .arg(place.y(), 0, 'f', 3)
      .arg(place.z(), 0, 'f', 3);
}

QStringList entityValues(const SceneEntity& entity, const QString& drawing) {
  QStringList values;
  const QString name = QString::fromStdString(entity.id());
  if (!name.isEmpty() && !drawing.endsWith(name)) values << name;
  for (const auto& pair : entity.metadata()) {
    if (values.size() < kMaxTipValues) values << QString::fromStdString(pair.key() + ": " + pair.value());
  }
  return values;
}

std::vector<DrawingHit> drawingsAt(const std::vector<WorldDrawing>& drawings, const QTransform& fieldToWidget,
                                   const QPointF& at) {
  std::vector<DrawingHit> hits;
  int examined = 0;
  for (auto drawing = drawings.rbegin(); drawing != drawings.rend(); ++drawing) {
    examined += pointsOf(*drawing->entity);
    if (examined > kMaxTipPoints || hits.size() >= kMaxTipDrawings) break;
    const PartsFromAbove parts(drawing->frameInField, fieldToWidget, at);
    if (!parts.isPainted(*drawing->entity)) continue;
    hits.push_back({drawing->id, drawing->robot,
                    entityValues(*drawing->entity, drawing->id) + parts.values(*drawing->entity)});
  }
  return hits;
}

}  // namespace widgets
