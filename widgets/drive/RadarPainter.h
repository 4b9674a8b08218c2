// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <QTransform>

class QPainter;
class QPalette;

namespace widgets {

struct RadarReadings;

/// The look of a radar. A plain value; logical pixels.
struct RadarLook {
  /// Limits of the range, m.
  static constexpr double kMinRange = 0.5, kMaxRange = 40;
  /// Size of the widget.
  QSizeF size;
  /// Meters from the middle to the nearer edges.
  double range = 4;
  /// Whether up is the map's y axis; else the robot's x axis.
  bool northUp = false;
  /// Maximum age of echoes that are shown, s.
  double memory = 2;

  /// Pixels per meter.
  double scale() const;
};

/// From the robot's frame to the widget; the robot is in the middle. `heading`: of the robot on the map, used
/// if the look is north-up.
QTransform robotToWidget(const RadarLook& look, double heading);
/// Paints ground with rings, echoes and laser, and the robot with bumpers and stall. Drawings of the robot's
/// program go on top, by robotToWidget(). Pure.
void paintRadar(QPainter& painter, const RadarReadings& readings, const RadarLook& look,
                const QPalette& palette);

}  // namespace widgets
