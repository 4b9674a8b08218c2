// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <QTransform>

namespace widgets {

/// The part of an image that a widget shows, and its zoom. A plain value; all functions are pure.
///
/// Image coordinates are pixels with (0, 0) at the upper left corner of the upper left pixel; widget
/// coordinates are Qt's logical pixels.
struct ImageViewport {
  /// Limits of the zoom.
  static constexpr double kMinZoom = 0.1, kMaxZoom = 64;

  /// Whether the whole image is shown as large as possible; zoom and center are not used then.
  bool fit = true;
  /// Logical pixels of the widget per image pixel.
  double zoom = 1;
  /// The image point in the middle of the widget.
  QPointF center;

  bool operator==(const ImageViewport&) const = default;
};

/// The zoom in use: the viewport's, or that which fits.
double shownZoom(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget);
/// From image to widget coordinates.
QTransform imageToWidget(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget);
/// Zoomed by `factor`, within the limits; what is at `at` (widget) stays there.
ImageViewport zoomed(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget, double factor,
                     const QPointF& at);
/// Moved by widget pixels. The middle of the widget always shows a point of the image.
ImageViewport panned(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget,
                     const QPointF& by);

}  // namespace widgets
