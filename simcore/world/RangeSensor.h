// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "simcore/world/PortInfo.h"

namespace simcore {

/// A sensor that measures how far it is to what is drawn (shadow or not), but for its own robot. It measures
/// along the x-axis of its frame, y to the left, and all its rays lie in the plane of x and y. A plain value:
/// readings are worked out when they are asked for, by Simulation::measure().
///
/// A sonar yields one reading: the nearest echo in its cone. A surface that a ray meets at more than
/// `mostIncidence` to its normal reflects the sound away. A laser yields one reading for each of its
/// directions.
struct RangeSensor {
  enum class Kind : std::uint8_t { kSonar, kLaser };
  PortInfo info;  ///< "p3at1/sonar3" {}, "p3at1/laser" {181}; type "range", unit "m"
  Kind kind = Kind::kSonar;
  double minimum = 0;  ///< m; what is nearer is measured as this
  double maximum = 0;  ///< m; the reading where there is nothing
  double noise = 0;    ///< standard deviation, m
  int readings = 1;
  double startAngle = 0,
         endAngle = 0;      ///< laser: of its first and last reading, rad, counter-clockwise from the x-axis
  double openingAngle = 0;  ///< sonar: of its whole cone, rad
  double mostIncidence = robotlink::kPi / 2;  ///< sonar: rad; pi / 2 is no loss
  robotlink::Duration period{};               ///< between measurements; 0: whenever somebody asks
  int body = 0;                               ///< index in RenderScene::bodies
  robotlink::Pose3 sensorInBody = robotlink::Pose3::Identity();
};

}  // namespace simcore
