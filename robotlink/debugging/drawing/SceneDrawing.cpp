// SPDX-License-Identifier: GPL-3.0-or-later
// SceneDrawing of Drawings.h: shapes as primitives of a foxglove.SceneEntity.
#include <array>

#include "foxglove/Scene.pb.h"
#include "robotlink/debugging/drawing/Primitives.h"
#include "robotlink/debugging/drawing/Shapes.h"

namespace robotlink {
namespace {

using foxglove::LinePrimitive;
using foxglove::TriangleListPrimitive;

Vector3 onGround(const Vector2& point) {
  return {point.x(), point.y(), SceneDrawing::kGroundHeight};
}

void add(foxglove::Point3& to, const Vector3& from) {
  to.set_x(from.x());
  to.set_y(from.y());
  to.set_z(from.z());
}

LinePrimitive& addLines(foxglove::SceneEntity& to, LinePrimitive::Type type, Color color, double width) {
  LinePrimitive& lines = *to.add_lines();
  lines.set_type(type);
  assign(*lines.mutable_pose(), Pose3::Identity());
  lines.set_thickness(width);
  lines.set_scale_invariant(true);
  *lines.mutable_color() = packed(color);
  return lines;
}

// Returns the last list of lines if it has the same style, otherwise a new one, so that a thousand lines of
// one color become one primitive.
LinePrimitive& lineList(foxglove::SceneEntity& to, Color color, double width) {
  if (to.lines_size() > 0) {
    LinePrimitive& last = *to.mutable_lines(to.lines_size() - 1);
    if (last.type() == LinePrimitive::LINE_LIST && last.thickness() == width &&
        same(last.color(), packed(color))) {
      return last;
    }
  }
  return addLines(to, LinePrimitive::LINE_LIST, color, width);
}

TriangleListPrimitive& triangleList(foxglove::SceneEntity& to, Color color) {
  if (to.triangles_size() > 0) {
    TriangleListPrimitive& last = *to.mutable_triangles(to.triangles_size() - 1);
    if (same(last.color(), packed(color))) return last;
  }
  TriangleListPrimitive& triangles = *to.add_triangles();
  assign(*triangles.mutable_pose(), Pose3::Identity());
  *triangles.mutable_color() = packed(color);
  return triangles;
}

void addFill(foxglove::SceneEntity& to, std::span<const Vector2> corners, Color fill) {
  const auto triangles = triangulate(corners);
  if (triangles.empty()) return;
  TriangleListPrimitive& list = triangleList(to, fill);
  const auto first = static_cast<std::uint32_t>(list.points_size());
  for (const Vector2& corner : corners) add(*list.add_points(), onGround(corner));
  for (const std::uint32_t corner : triangles) list.add_indices(first + corner);
}

Pose3 alongX(const Pose3& frame, int axis) {
  Pose3 turned = frame;
  if (axis == 1) turned.rotate(Eigen::AngleAxisd(kPi / 2, Vector3::UnitZ()));
  if (axis == 2) turned.rotate(Eigen::AngleAxisd(-kPi / 2, Vector3::UnitY()));
  return turned;
}

}  // namespace

void SceneDrawing::line(const Vector2& from, const Vector2& to, Color color, double width) {
  line(onGround(from), onGround(to), color, width);
}

void SceneDrawing::line(const Vector3& from, const Vector3& to, Color color, double width) {
  if (!finite(from, to)) return;
  LinePrimitive& lines = lineList(to_, color, width);
  add(*lines.add_points(), from);
  add(*lines.add_points(), to);
}

void SceneDrawing::arrow(const Vector2& from, const Vector2& to, Color color, double width) {
  if (!finite(from, to)) return;
  const ArrowHead ends = arrowHead(from, to, std::min(0.06, (to - from).norm() / 3));
  line(from, to, color, width);
  line(to, ends.left, color, width);
  line(to, ends.right, color, width);
}

void SceneDrawing::circle(const Vector2& center, double radius, Color color, double width, Color fill) {
  if (!finite(center) || !std::isfinite(radius)) return;
  polygon(ellipsePoints(center, Vector2(radius, radius), 0), color, width, fill);
}

void SceneDrawing::ellipse(const Vector2& center, const Vector2& radii, double angle, Color color,
                           double width) {
  if (!finite(center, radii) || !std::isfinite(angle)) return;
  polygon(ellipsePoints(center, radii, angle), color, width);
}

void SceneDrawing::polygon(std::span<const Vector2> corners, Color color, double width, Color fill) {
  for (const Vector2& corner : corners) {
    if (!finite(corner)) return;
  }
  if (corners.empty()) return;
  if (fill.alpha > 0) addFill(to_, corners, fill);
  LinePrimitive& loop = addLines(to_, LinePrimitive::LINE_LOOP, color, width);
  for (const Vector2& corner : corners) add(*loop.add_points(), onGround(corner));
}

void SceneDrawing::dot(const Vector2& at, Color color, double diameter) {
  if (!finite(at) || !std::isfinite(diameter)) return;
  constexpr int kCorners = 8;
  std::array<Vector2, kCorners> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * kPi * i / kCorners;
    corners[static_cast<std::size_t>(i)] = at + diameter / 2 * Vector2(std::cos(angle), std::sin(angle));
  }
  addFill(to_, corners, color);
}

void SceneDrawing::pose(const Pose2& pose, Color color, double length) {
  const Vector2 at = pose.translation();
  const Vector2 tip = pose * Vector2(length, 0);
  if (!finite(at, tip)) return;
  circle(at, length / 4, color);
  arrow(at, tip, color);
}

void SceneDrawing::dart(const Pose2& pose, Color color, double length) {
  const std::array<Vector2, 3> corners = {pose * Vector2(length, 0), pose * Vector2(0, length / 4),
                                          pose * Vector2(0, -length / 4)};
  if (finite(corners[0], corners[1])) addFill(to_, corners, color);
}

void SceneDrawing::text(const Vector2& at, const std::string& text, Color color, double size) {
  if (!finite(at)) return;
  foxglove::TextPrimitive& primitive = *to_.add_texts();
  Pose3 pose = Pose3::Identity();
  pose.translation() = onGround(at);
  assign(*primitive.mutable_pose(), pose);
  primitive.set_billboard(true);
  primitive.set_font_size(size);
  primitive.set_scale_invariant(true);
  *primitive.mutable_color() = packed(color);
  primitive.set_text(text);
}

void SceneDrawing::sphere(const Vector3& center, double radius, Color color) {
  if (!finite(center) || !std::isfinite(radius)) return;
  foxglove::SpherePrimitive& sphere = *to_.add_spheres();
  Pose3 pose = Pose3::Identity();
  pose.translation() = center;
  assign(*sphere.mutable_pose(), pose);
  assign(*sphere.mutable_size(), Vector3(Vector3::Constant(2 * radius)));
  *sphere.mutable_color() = packed(color);
}

void SceneDrawing::box(const Pose3& boxInFrame, const Vector3& size, Color color) {
  if (!finite(boxInFrame.matrix(), size)) return;
  foxglove::CubePrimitive& cube = *to_.add_cubes();
  assign(*cube.mutable_pose(), boxInFrame);
  assign(*cube.mutable_size(), size);
  *cube.mutable_color() = packed(color);
}

void SceneDrawing::axes(const Pose3& poseInFrame, double length) {
  if (!finite(poseInFrame.matrix()) || !std::isfinite(length)) return;
  constexpr std::array kAxisColors{colors::kRed, colors::kGreen, colors::kBlue};
  for (int axis = 0; axis < 3; ++axis) {
    foxglove::ArrowPrimitive& arrow = *to_.add_arrows();
    assign(*arrow.mutable_pose(), alongX(poseInFrame, axis));
    arrow.set_shaft_length(0.8 * length);
    arrow.set_shaft_diameter(0.04 * length);
    arrow.set_head_length(0.2 * length);
    arrow.set_head_diameter(0.1 * length);
    *arrow.mutable_color() = packed(kAxisColors[static_cast<std::size_t>(axis)]);
  }
}

}  // namespace robotlink
