// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

#include "robotlink/base/Geometry.h"

namespace widgets {

/// The part of the ground that a widget shows from above, its scale and its rotation. A plain value; all
/// functions are pure.
///
/// Ground coordinates are meters in the field's frame (x to the right of an unrotated picture, y up); widget
/// coordinates are Qt's logical pixels, y down.
struct FieldViewport {
  /// Limits of the scale, pixels per meter.
  static constexpr double kMinScale = 1, kMaxScale = 5000;

  /// Whether the whole ground is shown as large as possible; scale and center are not used then.
  bool fit = true;
  /// Logical pixels per meter.
  double scale = 100;
  /// The point in the middle of the widget.
  robotlink::Vector2 center = robotlink::Vector2::Zero();
  /// Rotation of the picture in quarter turns, 0 to 3, counterclockwise.
  int quarterTurns = 0;

  bool operator==(const FieldViewport&) const = default;
};

/// From ground to widget coordinates. `extent`: what a fitted viewport shows, in m; its top() is the smallest
/// y.
QTransform fieldToWidget(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget);
/// The scale in use: the viewport's, or that which fits.
double shownScale(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget);
/// Pixels for a meter.
double scaleOf(const QTransform& fieldToPixels);
robotlink::Vector2 groundAt(const QTransform& fieldToWidget, const QPointF& at);
/// Scaled by `factor`, within the limits; the ground at `at` (widget) stays there.
FieldViewport zoomed(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget, double factor,
                     const QPointF& at);
/// Moved by widget pixels; the center stays within 20 m of the extent.
FieldViewport panned(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget,
                     const QPointF& by);

}  // namespace widgets
