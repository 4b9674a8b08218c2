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

// Paints the map of a building from above, with a cached picture. Coordinates of maps are meters in the
// field's frame.
namespace widgets {

/// Everything that a map covers with a margin of half a meter, in m; top() is the smallest y. Linear in the
/// size of the map.
QRectF mapExtent(const robotcontrol::GroundMap& map);
/// Paints lines and points of the map in `color` into `image`; `fieldToPixels` maps to its pixels. Points are
/// as large as their distance in a wall, so that a wall looks solid at each scale; those outside of the image
/// cost next to nothing.
void paintWalls(QImage& image, const robotcontrol::GroundMap& map, const QTransform& fieldToPixels,
                const QColor& color);
/// Paints goals, homes and docks with their names, and forbidden lines and areas. `highlighted`: index of the
/// place under the cursor; -1: none.
void paintPlaces(QPainter& painter, const robotcontrol::GroundMap& map, const QTransform& fieldToWidget,
                 const QPalette& palette, int highlighted);
/// Index of the nearest place (goal, home or dock) within `tolerance` pixels; -1: none.
int placeAt(const robotcontrol::GroundMap& map, const QTransform& fieldToWidget, const QPointF& at,
            double tolerance);

/// A map as the ground of a view. Its walls are painted into a cached picture, which is renewed when size,
/// transform or color change. Shares the map. GUI thread.
class MapGround {
 public:
  explicit MapGround(std::shared_ptr<const robotcontrol::GroundMap> map);
  const robotcontrol::GroundMap& map() const { return *map_; }
  /// See mapExtent().
  const QRectF& extent() const { return extent_; }
  /// Fills the whole widget. `widget`: its size in logical pixels; `ratio`: device pixels per logical pixel;
  /// `highlighted` as in paintPlaces().
  void paint(QPainter& painter, const QSize& widget, const QTransform& fieldToWidget, const QPalette& palette,
             double ratio, int highlighted) const;

 private:
  std::shared_ptr<const robotcontrol::GroundMap> map_;
  QRectF extent_;
  /// The cached picture of the walls, and what it was painted for.
  mutable QImage walls_;
  mutable QTransform paintedFor_;
  mutable QRgb color_ = 0;
};

}  // namespace widgets
