// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "simcore/world/PortInfo.h"
#include "simcore/world/SensorErrors.h"

namespace simcore {

/// A sensor that measures distances to everything that is drawn, except for its own robot. It measures along
/// the x-axis of its frame; y points to the left, and all rays lie in the x-y plane. A plain value: readings
/// are computed on demand by Simulation::measure().
///
/// A sonar has one reading: the nearest echo in its cone. A surface that a ray meets at more than
/// `mostIncidence` to its normal reflects the sound away. A laser has one reading for each of its directions.
struct RangeSensor {
  enum class Kind : std::uint8_t { kSonar, kLaser };
  /// "p3at1/sonar3" with shape {}, "p3at1/laser" with shape {181}; type "range", unit "m".
  PortInfo info;
  Kind kind = Kind::kSonar;
  double minimum = 0;  ///< m; smaller distances are reported as this
  double maximum = 0;  ///< m; the reading if there is nothing
  /// Errors of distances, m, where there is an echo. White noise and rounding are for each reading of its
  /// own, bias and drift for all together.
  SensorErrors errors;
  /// 1 for a sonar.
  int readings = 1;
  /// Laser only: angles of the first and the last reading, rad, counterclockwise from the x-axis.
  double startAngle = 0, endAngle = 0;
  /// Sonar only: the full cone, rad.
  double openingAngle = 0;
  /// Sonar only: rad; with pi / 2 every surface gives an echo.
  double mostIncidence = robotlink::kPi / 2;
  /// The time between measurements; 0: on demand.
  robotlink::Duration period{};
  /// Index in RenderScene::bodies.
  int body = 0;
  robotlink::Pose3 sensorInBody = robotlink::Pose3::Identity();
};

}  // namespace simcore
