// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <QTransform>

#include "robotlink/base/Geometry.h"

namespace widgets {

/// Which part of the ground a widget shows from above, how large and how turned. A plain value; all functions
/// are pure.
///
/// Ground coordinates in metres in the field's frame (x to the right of an unturned picture, y up); widget
/// coordinates in Qt's logical pixels.
struct FieldViewport {
  static constexpr double kMinimumScale = 1, kMaximumScale = 5000;

  bool fit = true;     ///< all of the ground, as large as it fits; then scale and center mean nothing
  double scale = 100;  ///< logical pixels for a metre
  robotlink::Vector2 center = robotlink::Vector2::Zero();  ///< shown in the middle of the widget
  int quarterTurns = 0;                                    ///< counter-clockwise, 0 to 3

  bool operator==(const FieldViewport&) const = default;
};

/// `extent`: what of the ground shall be seen in a viewport that fits, in metres; its top is where y is
/// least.
QTransform fieldToWidget(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget);
double shownScale(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget);
/// Pixels for a metre.
double scaleOf(const QTransform& fieldToPixels);
robotlink::Vector2 groundAt(const QTransform& fieldToWidget, const QPointF& at);
/// Enlarged by `factor`; what is at `at` (widget) stays there.
FieldViewport zoomed(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget, double factor,
                     const QPointF& at);
/// Moved with the mouse, by widget pixels.
FieldViewport panned(const FieldViewport& viewport, const QRectF& extent, const QSizeF& widget,
                     const QPointF& by);

}  // namespace widgets
