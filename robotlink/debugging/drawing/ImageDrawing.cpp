// SPDX-License-Identifier: GPL-3.0-or-later
// ImageDrawing of Drawings.h: shapes as foxglove.ImageAnnotations.
#include <google/protobuf/timestamp.pb.h>
#include <array>

#include "foxglove/Image.pb.h"
#include "robotlink/debugging/drawing/Primitives.h"
#include "robotlink/debugging/drawing/Shapes.h"

namespace robotlink {
namespace {

using foxglove::PointsAnnotation;

PointsAnnotation& addPoints(foxglove::ImageAnnotations& to, Instant time, PointsAnnotation::Type type,
                            Color color, double width) {
  PointsAnnotation& points = *to.add_points();
  assign(*points.mutable_timestamp(), time);
  points.set_type(type);
  *points.mutable_outline_color() = packed(color);
  points.set_thickness(width);
  return points;
}

// Returns the last annotation if it has the same style, otherwise a new one, so that a thousand dots of one
// color become one annotation.
PointsAnnotation& points(foxglove::ImageAnnotations& to, Instant time, PointsAnnotation::Type type,
                         Color color, double width) {
  if (to.points_size() > 0) {
    PointsAnnotation& last = *to.mutable_points(to.points_size() - 1);
    if (last.type() == type && last.thickness() == width && same(last.outline_color(), packed(color)))
      return last;
  }
  return addPoints(to, time, type, color, width);
}

void addLoop(foxglove::ImageAnnotations& to, Instant time, std::span<const Vector2> corners, Color color,
             double width, Color fill) {
  PointsAnnotation& loop = addPoints(to, time, PointsAnnotation::LINE_LOOP, color, width);
  if (fill.alpha > 0) *loop.mutable_fill_color() = packed(fill);
  for (const Vector2& corner : corners) assign(*loop.add_points(), corner);
}

}  // namespace

void ImageDrawing::line(const Vector2& from, const Vector2& to, Color color, double width) {
  if (!finite(from, to)) return;
  PointsAnnotation& lines = points(to_, time_, PointsAnnotation::LINE_LIST, color, width);
  assign(*lines.add_points(), from);
  assign(*lines.add_points(), to);
}

void ImageDrawing::arrow(const Vector2& from, const Vector2& to, Color color, double width) {
  if (!finite(from, to)) return;
  const double head = std::min(6 + width, (to - from).norm() / 2);
  const ArrowHead ends = arrowHead(from, to, head);
  line(from, to, color, width);
  line(to, ends.left, color, width);
  line(to, ends.right, color, width);
}

void ImageDrawing::circle(const Vector2& center, double radius, Color color, double width, Color fill) {
  if (!finite(center) || !std::isfinite(radius)) return;
  foxglove::CircleAnnotation& circle = *to_.add_circles();
  assign(*circle.mutable_timestamp(), time_);
  assign(*circle.mutable_position(), center);
  circle.set_diameter(2 * radius);
  circle.set_thickness(width);
  *circle.mutable_outline_color() = packed(color);
  if (fill.alpha > 0) *circle.mutable_fill_color() = packed(fill);
}

void ImageDrawing::ellipse(const Vector2& center, const Vector2& radii, double angle, Color color,
                           double width) {
  if (!finite(center, radii) || !std::isfinite(angle)) return;
  addLoop(to_, time_, ellipsePoints(center, radii, angle), color, width, {{}, 0});
}

void ImageDrawing::polygon(std::span<const Vector2> corners, Color color, double width, Color fill) {
  for (const Vector2& corner : corners) {
    if (!finite(corner)) return;
  }
  if (!corners.empty()) addLoop(to_, time_, corners, color, width, fill);
}

void ImageDrawing::rectangle(const Vector2& upperLeft, const Vector2& lowerRight, Color color, double width) {
  const std::array<Vector2, 4> corners{upperLeft, Vector2(lowerRight.x(), upperLeft.y()), lowerRight,
                                       Vector2(upperLeft.x(), lowerRight.y())};
  polygon(corners, color, width);
}

void ImageDrawing::dot(const Vector2& at, Color color, double size) {
  if (!finite(at)) return;
  assign(*points(to_, time_, PointsAnnotation::POINTS, color, size).add_points(), at);
}

void ImageDrawing::text(const Vector2& at, const std::string& text, Color color, double size) {
  if (!finite(at)) return;
  foxglove::TextAnnotation& annotation = *to_.add_texts();
  assign(*annotation.mutable_timestamp(), time_);
  assign(*annotation.mutable_position(), at);
  annotation.set_text(text);
  annotation.set_font_size(size);
  *annotation.mutable_text_color() = packed(color);
}

}  // namespace robotlink
