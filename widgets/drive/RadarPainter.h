// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSizeF>
#include <QTransform>

class QPainter;
class QPalette;

namespace widgets {

struct RadarReadings;

/// How a radar is looked at. A plain value; logical pixels.
struct RadarLook {
  static constexpr double kLeastRange = 0.5, kGreatestRange = 40;
  QSizeF size;
  double range = 4;      ///< m from the middle to the nearer edges
  bool northUp = false;  ///< up is the map's y; else where the robot looks
  double memory = 2;     ///< s: echoes that are older are gone

  double scale() const;  ///< pixels for a metre
};

/// From the robot's frame to the widget, whose middle is the robot.
QTransform robotToWidget(const RadarLook& look, double heading);
/// Pure: ground with rings, what the sensors tell, the robot with bumpers and stall. What the robot's program
/// drew goes on top, by robotToWidget().
void paintRadar(QPainter& painter, const RadarReadings& readings, const RadarLook& look,
                const QPalette& palette);

}  // namespace widgets
