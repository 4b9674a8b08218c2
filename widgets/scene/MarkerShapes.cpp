// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/MarkerShapes.h"

#include <algorithm>

#include "widgets/scene/render/MeshBuilder.h"

namespace widgets {
namespace {

using robotlink::Pose3;
using robotlink::Vector3;

constexpr double kShortestArrow = 1e-4;  // m

}  // namespace

Pose3 poseAlong(const Vector3& at, const Vector3& direction) {
  Pose3 pose = Pose3::Identity();
  pose.translation() = at;
  if (direction.allFinite() && direction.norm() > 1e-9)
    pose.linear() = robotlink::rotationFromZAxis(direction);
  return pose;
}

void addMarkerArrow(SceneShape& shape, const Vector3& from, const Vector3& to, double radius,
                    MarkerColor color) {
  const Vector3 along = to - from;
  if (!from.allFinite() || !to.allFinite() || along.norm() < kShortestArrow) return;
  const double length = along.norm(), head = std::min(length, 6 * radius), shaft = length - head;
  const Pose3 start = poseAlong(from, along);
  const auto at = [&](double height) { return Pose3(start * Eigen::Translation3d(0, 0, height)); };
  MeshBuilder builder(shape.opaque);
  if (shaft > 0) builder.cylinder(at(shaft / 2), {2 * radius, 2 * radius, shaft}, 1, 1, color);
  builder.cylinder(at(shaft + head / 2), {5 * radius, 5 * radius, head}, 1, 0, color);
}

void addMarkerLine(SceneShape& shape, const Vector3& from, const Vector3& to, MarkerColor color,
                   float pixels) {
  if (from.allFinite() && to.allFinite())
    shape.lines.segments.push_back({packed(from), packed(to), color, pixels});
}

void addMarkerPoint(SceneShape& shape, const Vector3& at, MarkerColor color, float pixels) {
  addMarkerLine(shape, at, at, color, pixels);
}

void addMarkerAxes(SceneShape& shape, double length) {
  constexpr std::array<MarkerColor, 3> kColors{{{222, 70, 60, 255}, {70, 170, 80, 255}, {80, 140, 235, 255}}};
  for (int axis = 0; axis < 3; ++axis)
    addMarkerArrow(shape, Vector3::Zero(), length * Vector3::Unit(axis), length / 24,
                   kColors[static_cast<std::size_t>(axis)]);
}

}  // namespace widgets
