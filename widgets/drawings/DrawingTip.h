// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QString>
#include <QStringList>
#include <functional>
#include <string>
#include <vector>

class QHelpEvent;
class QPainter;
class QWidget;

// Makes the tooltip for the drawings under the cursor. GUI thread.
namespace widgets {

/// A drawing under the cursor.
struct DrawingHit {
  /// The id in DrawingsModel: "image/ball-percept/circle", or "stream/" and a path.
  QString id;
  /// The robot that made the drawing; empty for a stream.
  std::string robot;
  /// The texts and values of its parts under the cursor.
  QStringList values;
};

/// At most this many drawings, and values of each, are named; the topmost ones.
inline constexpr int kMaxTipDrawings = 4, kMaxTipValues = 4;
/// Points and corners of drawings that are examined for one tip; drawings below are left out.
inline constexpr int kMaxTipPoints = 200000;

/// Whether what `paint` paints, in the coordinates of a widget, is within 4 pixels of a place. Costs as
/// much as painting it into a picture of 9 x 9 pixels.
bool paintsAt(const QPointF& at, const std::function<void(QPainter&)>& paint);

/// The text of a tooltip, as rich text in which data of robots is escaped: for each drawing its name,
/// its source, and its values. Empty without drawings.
QString drawingTip(const std::vector<DrawingHit>& hits);
/// Shows the tip until the mouse moves away; false, without a tip, if there are no drawings.
bool showDrawingTip(QWidget& widget, const QHelpEvent& event, const std::vector<DrawingHit>& hits);

}  // namespace widgets
