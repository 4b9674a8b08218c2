// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <QTransform>

namespace widgets {

/// Which part of an image a widget shows and how large. A plain value; all functions are pure.
///
/// Image coordinates in pixels, (0, 0) is the upper left corner of the upper left pixel; widget coordinates
/// in Qt's logical pixels.
struct ImageViewport {
  static constexpr double kMinimumZoom = 0.1, kMaximumZoom = 64;

  bool fit = true;  ///< the whole image, as large as it fits; then zoom and center mean nothing
  double zoom = 1;  ///< logical pixels of the widget for a pixel of the image
  QPointF center;   ///< in the image, shown in the middle of the widget

  bool operator==(const ImageViewport&) const = default;
};

/// The zoom that is shown: of a viewport that fits, what fits.
double shownZoom(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget);
/// From image to widget coordinates.
QTransform imageToWidget(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget);
/// Enlarged by `factor`; what is at `at` (widget) stays there.
ImageViewport zoomed(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget, double factor,
                     const QPointF& at);
/// Moved with the mouse, by widget pixels. The image's centre can not leave the widget by more than half of
/// it.
ImageViewport panned(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget,
                     const QPointF& by);

}  // namespace widgets
