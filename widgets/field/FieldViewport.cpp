// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/field/FieldViewport.h"

#include <algorithm>

namespace widgets {
namespace {

using robotlink::Vector2;

constexpr double kFarthest = 20;  // the center stays within this distance from the extent, m

FieldViewport unfittedField(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget) {
  if (!viewport.fit) return viewport;
  return {false,
          shownScale(viewport, extent, widget),
          {extent.center().x(), extent.center().y()},
          viewport.quarterTurns};
}

Vector2 nearTo(const QRectF& extent, const Vector2& place) {
  const QRectF room = extent.adjusted(-kFarthest, -kFarthest, kFarthest, kFarthest);
  return {std::clamp(place.x(), room.left(), room.right()), std::clamp(place.y(), room.top(), room.bottom())};
}

}  // namespace

double shownScale(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget) {
  if (!viewport.fit || extent.isEmpty()) return viewport.scale;
  const QSizeF turned = viewport.quarterTurns % 2 == 0 ? extent.size() : extent.size().transposed();
  const double fitting = std::min(widget.width() / turned.width(), widget.height() / turned.height());
  return std::clamp(fitting, FieldViewport::kMinScale, FieldViewport::kMaxScale);
}

QTransform fieldToWidget(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget) {
  const FieldViewport shown = unfittedField(viewport, extent, widget);
  QTransform transform;
  transform.translate(widget.width() / 2, widget.height() / 2);
  transform.scale(shown.scale, -shown.scale);
  transform.rotate(90 * shown.quarterTurns);
  transform.translate(-shown.center.x(), -shown.center.y());
  return transform;
}

double scaleOf(const QTransform& fieldToPixels) {
  return std::hypot(fieldToPixels.m11(), fieldToPixels.m12());
}

Vector2 groundAt(const QTransform& fieldToWidget, const QPointF& at) {
  const QPointF ground = fieldToWidget.inverted().map(at);
  return {ground.x(), ground.y()};
}

FieldViewport zoomed(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget, double factor,
                     const QPointF& at) {
  FieldViewport result = unfittedField(viewport, extent, widget);
  const Vector2 before = groundAt(fieldToWidget(viewport, extent, widget), at);
  result.scale = std::clamp(result.scale * factor, FieldViewport::kMinScale, FieldViewport::kMaxScale);
  const Vector2 after = groundAt(fieldToWidget(result, extent, widget), at);
  result.center = nearTo(extent, result.center + before - after);
  return result;
}

FieldViewport panned(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget,
                     const QPointF& by) {
  FieldViewport result = unfittedField(viewport, extent, widget);
  const QTransform transform = fieldToWidget(viewport, extent, widget);
  const Vector2 moved = groundAt(transform, by) - groundAt(transform, {0, 0});
  result.center = nearTo(extent, result.center - moved);
  return result;
}

}  // namespace widgets
