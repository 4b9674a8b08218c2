// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>
#include <QString>
#include <string>
#include <vector>

#include "widgets/image/ImageViewport.h"

class QPainter;
namespace foxglove {
class ImageAnnotations;
}

namespace widgets {

/// The contents of an image view: pixels, and drawings on them, lowest first. Drawings are not owned.
struct ImagePicture {
  QImage pixels;
  /// A drawing that belongs to the image.
  struct Drawing {
    /// The annotations; they must outlive the picture.
    const foxglove::ImageAnnotations* annotations = nullptr;
    /// Whether it belongs to an earlier image; painted faded.
    bool old = false;
    /// Its name and its robot, in the form of CurrentDrawing; empty: it is not a robot's drawing.
    QString id = {};
    std::string robot = {};
  };
  std::vector<Drawing> drawings;
  /// The size of the image to which the drawings' coordinates belong, if `pixels` is a scaled one; empty: the
  /// size of `pixels`.
  QSize drawnOn = {};
};

/// Paints the picture into a widget of this size at the painter's origin: pixels, from a certain zoom on with
/// a grid between them, and the drawings. Pure, like the following functions; looks the same on a widget and
/// on a QImage.
void paintPicture(QPainter& painter, const QSizeF& widget, const ImagePicture& picture,
                  const ImageViewport& viewport);
/// From the coordinates of the picture's drawings to a widget of this size. The picture has pixels.
QTransform drawingsToWidget(const ImagePicture& picture, const ImageViewport& viewport, const QSizeF& widget);
/// Paints one drawing. Positions are image coordinates; line widths, point sizes and font sizes are screen
/// pixels at every zoom. `style` is that of lines.
void paintAnnotations(QPainter& painter, const foxglove::ImageAnnotations& drawing,
                      const QTransform& imageToWidget, Qt::PenStyle style = Qt::SolidLine);
/// Paints a text into the upper left corner of a picture's pane, in widget pixels; nothing for an empty one.
/// Where it is too wide it gets several lines, and only words that are wider than the pane are shortened.
void paintCaption(QPainter& painter, const QRectF& pane, const QString& text);

}  // namespace widgets
