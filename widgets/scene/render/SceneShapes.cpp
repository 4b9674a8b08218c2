// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/render/SceneShapes.h"

#include <algorithm>
#include <cmath>

#include "foxglove/Scene.pb.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/scene/render/MeshBuilder.h"

namespace widgets {
namespace {

using foxglove::LinePrimitive;
using robotlink::Pose3;
using robotlink::Vector3;
using Color = MeshBuilder::Color;

Color rgba(const foxglove::Color& color) {
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::min(std::max(0.0, value), 1.0) * 255));
  };
  return {channel(color.r()), channel(color.g()), channel(color.b()), channel(color.a())};
}

SceneMesh& meshFor(SceneShape& shape, Color color) {
  return color[3] == 255 ? shape.opaque : shape.translucent;
}

void addTriangles(SceneShape& shape, const foxglove::TriangleListPrimitive& list) {
  const Pose3 pose = robotlink::pose3(list.pose());
  const bool indexed = list.indices_size() > 0;
  const int count = indexed ? list.indices_size() : list.points_size();
  std::vector<Vector3> corners[2];
  std::vector<Color> colors[2];
  for (int i = 0; i + 2 < count; i += 3) {
    std::array<int, 3> at{};
    for (int k = 0; k < 3; ++k)
      at[static_cast<std::size_t>(k)] = indexed ? static_cast<int>(list.indices(i + k)) : i + k;
    if (std::ranges::any_of(at, [&](int point) { return point < 0 || point >= list.points_size(); }))
      continue;
    const Color color = rgba(at[0] < list.colors_size() ? list.colors(at[0]) : list.color());
    const std::size_t kind = color[3] == 255 ? 0 : 1;
    for (const int point : at) {
      const auto& p = list.points(point);
      corners[kind].push_back(pose * Vector3(p.x(), p.y(), p.z()));
    }
    colors[kind].push_back(color);
  }
  MeshBuilder(shape.opaque).triangles(corners[0], colors[0]);
  MeshBuilder(shape.translucent).triangles(corners[1], colors[1]);
}

void addArrow(SceneShape& shape, const foxglove::ArrowPrimitive& arrow) {
  // Cylinders are along z, arrows along x.
  Pose3 alongX = robotlink::pose3(arrow.pose());
  alongX.rotate(Eigen::AngleAxisd(robotlink::kPi / 2, Vector3::UnitY()));
  const Color color = rgba(arrow.color());
  MeshBuilder builder(meshFor(shape, color));
  const auto add = [&](double from, double length, double diameter, double topScale) {
    Pose3 pose = alongX;
    pose.translate(Vector3(0, 0, from + length / 2));
    builder.cylinder(pose, {diameter, diameter, length}, 1, topScale, color);
  };
  add(0, arrow.shaft_length(), arrow.shaft_diameter(), 1);
  add(arrow.shaft_length(), arrow.head_length(), arrow.head_diameter(), 0);
}

void addLines(SceneShape& shape, const LinePrimitive& lines) {
  const Pose3 pose = robotlink::pose3(lines.pose());
  std::vector<int> order;
  for (const auto index : lines.indices()) order.push_back(static_cast<int>(index));
  for (int i = 0; lines.indices_size() == 0 && i < lines.points_size(); ++i) order.push_back(i);
  std::erase_if(order, [&](int i) { return i < 0 || i >= lines.points_size(); });
  if (lines.type() == LinePrimitive::LINE_LOOP && !order.empty()) order.push_back(order.front());
  const std::size_t step = lines.type() == LinePrimitive::LINE_LIST ? 2 : 1;
  const auto thickness = static_cast<float>(lines.thickness());
  const auto point = [&](int i) {
    return packed(Vector3(pose * Vector3(lines.points(i).x(), lines.points(i).y(), lines.points(i).z())));
  };
  for (std::size_t i = 0; i + 1 < order.size(); i += step) {
    const auto& color = order[i] < lines.colors_size() ? lines.colors(order[i]) : lines.color();
    shape.lines.segments.push_back({point(order[i]), point(order[i + 1]), rgba(color),
                                    lines.scale_invariant() ? std::max(1.F, thickness) : -thickness});
  }
}

}  // namespace

SceneShape shapeOf(const foxglove::SceneEntity& entity) {
  SceneShape shape;
  for (const auto& cube : entity.cubes()) {
    const Color color = rgba(cube.color());
    MeshBuilder(meshFor(shape, color))
        .box(robotlink::pose3(cube.pose()), robotlink::vector3(cube.size()), color);
  }
  for (const auto& sphere : entity.spheres()) {
    const Color color = rgba(sphere.color());
    MeshBuilder(meshFor(shape, color))
        .sphere(robotlink::pose3(sphere.pose()), robotlink::vector3(sphere.size()), color);
  }
  for (const auto& cylinder : entity.cylinders()) {
    const Color color = rgba(cylinder.color());
    // Both zero means that neither was set.
    const bool unset = cylinder.bottom_scale() == 0 && cylinder.top_scale() == 0;
    MeshBuilder(meshFor(shape, color))
        .cylinder(robotlink::pose3(cylinder.pose()), robotlink::vector3(cylinder.size()),
                  unset ? 1 : cylinder.bottom_scale(), unset ? 1 : cylinder.top_scale(), color);
  }
  for (const auto& list : entity.triangles()) addTriangles(shape, list);
  for (const auto& arrow : entity.arrows()) addArrow(shape, arrow);
  for (const auto& lines : entity.lines()) addLines(shape, lines);
  for (const auto& text : entity.texts()) {
    shape.texts.push_back({robotlink::pose3(text.pose()).translation(), text.text(), rgba(text.color()),
                           text.scale_invariant() ? text.font_size() : -text.font_size()});
  }
  return shape;
}

}  // namespace widgets
