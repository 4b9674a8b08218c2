// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <QStringList>
#include <vector>

class QPainter;
class QPalette;
class QSizeF;

// Measurements in a picture: the distance of two points, or the angle at the second of three. Pure
// functions. Points are in the picture's own coordinates: pixels of an image, meters of a field.
namespace widgets {

/// A measurement in words.
struct MeasureText {
  /// The text next to each segment from a point to the next.
  QStringList segments;
  /// The text at the second of three points; empty with fewer.
  QString angle;
  /// All of it in one line, to be read and copied.
  QString line;
};

/// The angle at the second of three points between the segments to the others, rad, 0 to pi; 0 if two points
/// are the same.
double angleAt(const std::vector<QPointF>& points);
/// The direction from one point to another, degrees counterclockwise from the x-axis, (-180, 180]. `yDown`:
/// the y-axis points down, as in images.
double directionDeg(const QPointF& from, const QPointF& to, bool yDown);

/// Paints points, segments and their texts over a picture. `points` are in the painter's coordinates;
/// `widget`: the size within which the texts stay.
void paintMeasurement(QPainter& painter, const std::vector<QPointF>& points, const MeasureText& text,
                      const QSizeF& widget, const QPalette& palette);

}  // namespace widgets
