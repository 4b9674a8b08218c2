// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QRectF>
#include <QTransform>
#include <memory>

#include "robotlink/base/Geometry.h"

class QPainter;
class QPalette;
namespace robotcontrol {
class GroundMap;
}

namespace widgets {

// Pure functions that paint the map of a building from above.

/// What a map covers, in metres, with a margin; its top is where y is least. Walks through all of the map.
QRectF mapExtent(const robotcontrol::GroundMap& map);
/// Lines and points, in `color`, into `image`, whose pixels `fieldToPixels` leads to. Points of walls are as
/// large as they are apart from each other, so that a wall looks like one at each scale; what is not seen
/// costs next to nothing.
void paintWalls(QImage& image, const robotcontrol::GroundMap& map, const QTransform& fieldToPixels,
                const QColor& color);
/// Goals, homes, docks with their names, forbidden lines and areas. `highlighted`: the place under the
/// cursor; -1: none.
void paintPlaces(QPainter& painter, const robotcontrol::GroundMap& map, const QTransform& fieldToWidget,
                 const QPalette& palette, int highlighted);
/// The place (goal, home or dock) within `tolerance` pixels; -1: none.
int placeAt(const robotcontrol::GroundMap& map, const QTransform& fieldToWidget, const QPointF& at,
            double tolerance);

/// A map as a ground: its walls are painted once for each view on it and kept as a picture. Shares the map.
/// GUI thread.
class MapGround {
 public:
  explicit MapGround(std::shared_ptr<const robotcontrol::GroundMap> map);
  const robotcontrol::GroundMap& map() const { return *map_; }
  const std::shared_ptr<const robotcontrol::GroundMap>& shared() const { return map_; }
  const QRectF& extent() const { return extent_; }
  /// Fills all of `widget`, given in logical pixels; `ratio`: how many pixels of the device there are for one
  /// of them.
  void paint(QPainter& painter, const QSize& widget, const QTransform& fieldToWidget, const QPalette& palette,
             double ratio, int highlighted) const;

 private:
  std::shared_ptr<const robotcontrol::GroundMap> map_;
  QRectF extent_;
  // What the picture was painted for.
  mutable QImage walls_;
  mutable QTransform paintedFor_;
  mutable QRgb color_ = 0;
};

}  // namespace widgets
