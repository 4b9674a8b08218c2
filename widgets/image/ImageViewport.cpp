// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageViewport.h"

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

/// The same viewport with explicit zoom and center.
ImageViewport unfitted(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget) {
  if (!viewport.fit) return viewport;
  return {false, shownZoom(viewport, image, widget), QPointF(image.width() / 2, image.height() / 2)};
}

QPointF clampedCenter(const QPointF& center, const QSizeF& image) {
  return {std::clamp(center.x(), 0.0, image.width()), std::clamp(center.y(), 0.0, image.height())};
}

}  // namespace

double shownZoom(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget) {
  if (!viewport.fit || image.isEmpty()) return viewport.zoom;
  const double fitting = std::min(widget.width() / image.width(), widget.height() / image.height());
  return std::clamp(fitting, ImageViewport::kMinZoom, ImageViewport::kMaxZoom);
}

QTransform imageToWidget(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget) {
  const ImageViewport shown = unfitted(viewport, image, widget);
  // Aligned to whole pixels, so that the pixels of the image are equally large.
  const double left = std::round(widget.width() / 2 - shown.center.x() * shown.zoom);
  const double top = std::round(widget.height() / 2 - shown.center.y() * shown.zoom);
  return {shown.zoom, 0, 0, shown.zoom, left, top};
}

ImageViewport zoomed(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget, double factor,
                     const QPointF& at) {
  ImageViewport result = unfitted(viewport, image, widget);
  const QPointF fixed = imageToWidget(viewport, image, widget).inverted().map(at);
  result.zoom = std::clamp(result.zoom * factor, ImageViewport::kMinZoom, ImageViewport::kMaxZoom);
  const QPointF middle(widget.width() / 2, widget.height() / 2);
  result.center = clampedCenter(fixed + (middle - at) / result.zoom, image);
  return result;
}

ImageViewport panned(const ImageViewport& viewport, const QSizeF& image, const QSizeF& widget,
                     const QPointF& by) {
  ImageViewport result = unfitted(viewport, image, widget);
  result.center = clampedCenter(result.center - by / result.zoom, image);
  return result;
}

}  // namespace widgets
