// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneProbe.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <optional>

#include "widgets/field/GroundProbe.h"

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

constexpr double kProbeReach = 5, kTextReach = 14;  // pixels

Vector3 unpacked(const std::array<float, 3>& v) {
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// Looks for the parts of one drawing.
class PartsInScene {
 public:
  PartsInScene(const SceneBody& body, const SceneCamera& camera, const QSizeF& widget, const QPointF& at)
      : body_(body), camera_(camera), widget_(widget), at_(at) {}

  /// The values of the parts at the place; empty: there are none.
  QStringList values() const {
    QStringList values;
    for (const SceneText& text : body_.shape->texts) {
      const auto shown = camera_.project(widget_, body_.inField * text.position);
      if (values.size() < kMaxTipValues && shown && distance(*shown) <= kTextReach)
        values << QString::fromStdString(text.text);
    }
    auto place = onMeshes();
    if (!place) place = onLines();
    if (place) values << QCoreApplication::translate("DrawingTip", "at %1").arg(worldPlaceText(*place));
    return values;
  }

 private:
  double distance(const QPointF& shown) const { return std::hypot(shown.x() - at_.x(), shown.y() - at_.y()); }

  std::optional<Vector3> onMeshes() const {
    const Ray ray = camera_.ray(widget_, at_);
    const Pose3 fieldInBody = body_.inField.inverse();
    const Ray inBody{fieldInBody * ray.origin, fieldInBody.linear() * ray.direction};
    std::optional<double> nearest;
    for (const SceneMesh* mesh : {&body_.shape->opaque, &body_.shape->translucent}) {
      const auto hit = distanceTo(*mesh, inBody);
      if (hit && (!nearest || *hit < *nearest)) nearest = hit;
    }
    return nearest ? std::optional<Vector3>(ray.at(*nearest)) : std::nullopt;
  }

  /// The nearer end of the segment that is nearest in the picture.
  std::optional<Vector3> onLines() const {
    double nearest = kProbeReach;
    std::optional<Vector3> found;
    for (const auto& segment : body_.shape->lines.segments) {
      const Vector3 from = body_.inField * unpacked(segment.from), to = body_.inField * unpacked(segment.to);
      const auto a = camera_.project(widget_, from), b = camera_.project(widget_, to);
      if (!a || !b) continue;
      const QPointF along = *b - *a;
      const double length = QPointF::dotProduct(along, along);
      const double share =
          length > 0 ? std::clamp(QPointF::dotProduct(at_ - *a, along) / length, 0.0, 1.0) : 0.0;
      const double off = distance(*a + share * along);
      if (!(off <= nearest)) continue;
      nearest = off;
      found = share < 0.5 ? from : to;
    }
    return found;
  }

  const SceneBody& body_;
  const SceneCamera& camera_;
  QSizeF widget_;
  QPointF at_;
};

}  // namespace

std::vector<DrawingHit> drawingsAt(const std::vector<SceneBody>& drawings, const SceneCamera& camera,
                                   const QSizeF& widget, const QPointF& at) {
  std::vector<DrawingHit> hits;
  std::size_t examined = 0;
  for (auto body = drawings.rbegin(); body != drawings.rend(); ++body) {
    if (body->drawing.id.isEmpty()) continue;
    examined += body->shape->opaque.indices.size() + body->shape->translucent.indices.size() +
                body->shape->lines.segments.size() + body->shape->texts.size();
    if (examined > kMaxTipPoints || hits.size() >= kMaxTipDrawings) break;
    const QStringList values = PartsInScene(*body, camera, widget, at).values();
    if (!values.isEmpty())
      hits.push_back({body->drawing.id, body->drawing.robot, body->drawing.values + values});
  }
  return hits;
}

}  // namespace widgets
