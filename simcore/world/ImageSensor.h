// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "simcore/world/CameraModel.h"
#include "simcore/world/PortInfo.h"
#include "simcore/world/SensorErrors.h"

namespace simcore {

/// The quantity that an image sensor measures, and the directions of its pixels. All of them look along the
/// x-axis of their frame; y points to the left, z up.
struct ImageGeometry {
  enum class Kind : std::uint8_t {
    /// Depth along the optical axis, m; one channel. Nearer than `nearest`: 0; farther than `farthest`, or
    /// nothing there: infinity.
    kDepth,
    /// The number of the class of what is seen, 0 where there is nothing; one channel. Classes are the colors
    /// of the palette (RenderScene::labels).
    kLabels,
    /// The radiation classes that it senses, one channel each, as a pinhole camera. It sees its own robot.
    kRadiation,
    /// The same by single rays over ranges of two angles, as the eye of an insect does. It does not see its
    /// own robot.
    kFacette,
  };
  Kind kind = Kind::kDepth;
  /// Columns and rows; its angles do not count for facettes.
  CameraModel camera;
  /// Facettes only, rad: the azimuth of the first and of the last column (to the left is positive), and the
  /// elevation of the first (upper) and the last row.
  double azimuthStart = 0, azimuthEnd = 0, elevationStart = 0, elevationEnd = 0;
  // m
  double nearest = 0, farthest = 1000;
  /// The radiation classes of its channels.
  std::vector<std::string> classes;
};

/// A sensor that yields images of numbers, computed on demand by Simulation::measureImage(). A plain value.
struct ImageSensor {
  /// Shape {rows, columns, channels}; type "depth" (m), "labels", "radiation" or "facettes".
  PortInfo info;
  ImageGeometry geometry;
  SensorErrors errors;
  /// The time between images; 0: on demand.
  robotlink::Duration period{};
  /// Index in RenderScene::bodies.
  int body = 0;
  robotlink::Pose3 sensorInBody = robotlink::Pose3::Identity();
  std::size_t values() const {
    return static_cast<std::size_t>(geometry.camera.width) *
           static_cast<std::size_t>(geometry.camera.height) *
           static_cast<std::size_t>(info.shape.empty() ? 1 : info.shape.back());
  }
};

}  // namespace simcore
