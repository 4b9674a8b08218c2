// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>
#include <vector>

#include "widgets/image/ImageViewport.h"

class QPainter;
namespace foxglove {
class ImageAnnotations;
}

namespace widgets {

/// What an image view shows: pixels and the drawings on them, lowest first. The drawings belong to somebody
/// else.
struct ImagePicture {
  QImage pixels;
  struct Drawing {
    const foxglove::ImageAnnotations* annotations = nullptr;
    bool old = false;  ///< of an earlier image: painted faded
  };
  std::vector<Drawing> drawings;
};

// Pure functions: they look the same on a widget and on a QImage.

/// The picture in `widget` (at the painter's origin): pixels, from a certain zoom on with a grid between
/// them, and the drawings.
void paintPicture(QPainter& painter, const QSizeF& widget, const ImagePicture& picture,
                  const ImageViewport& viewport);
/// One drawing. Positions are the image's; widths, sizes of points and texts are pixels of the screen,
/// whatever the zoom.
void paintAnnotations(QPainter& painter, const foxglove::ImageAnnotations& drawing,
                      const QTransform& imageToWidget);
/// The whole image with its drawings, `scale` pixels for each of its own.
QImage renderPicture(const ImagePicture& picture, int scale);

}  // namespace widgets
