// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"
#include "simcore/world/PortInfo.h"

namespace simcore {

/// A shape that a controller draws into views of the world. A plain value; the world's frame, m.
struct DrawnShape {
  enum class Kind : std::uint8_t { kLine, kSphere, kBox, kText };
  Kind kind = Kind::kLine;
  /// A line has its points, the others have one point: the center.
  std::vector<robotlink::Vector3> points = {};
  /// A box has its edges along the axes; for a sphere x is the diameter, of a line the thickness, of a text
  /// the height.
  robotlink::Vector3 size = {0.01, 0.01, 0.01};
  robotlink::Rgb color = {255, 200, 0};
  std::string text = {};
};

/// A view that a controller adds: it looks like a sensor, with a path, a type, a shape, a unit and a range.
/// The controller may change its contents at any time, but not its size or its kind.
struct ControllerOutput {
  enum class Kind : std::uint8_t { kValues, kImage, kDrawing };
  /// More shapes in a drawing, or more points in one of them, are an error of the controller.
  static constexpr std::size_t kMaxShapes = 1000, kMaxPoints = 10'000, kMaxText = 1000;

  PortInfo info;
  Kind kind = Kind::kValues;
  /// The values; their number follows from the shape.
  std::vector<double> values = {};
  /// RGB or gray, of the size that the shape says.
  robotlink::Image image = {};
  std::vector<DrawnShape> shapes = {};

  /// Returns the problem with the contents; empty if they are valid.
  std::string problem() const;
};

}  // namespace simcore
