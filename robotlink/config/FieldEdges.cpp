// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/FieldEdges.h"

#include <algorithm>
#include <cmath>

#include "robotlink/config/FieldDescription.h"

namespace robotlink {
namespace {

constexpr int kCircleSides = 16;

/// Adds both edges of a line along its center.
void addLine(std::vector<FieldEdge>& edges, const Vector2& start, const Vector2& end, double width) {
  const Vector2 along = (end - start).normalized();
  const Vector2 across = 0.5 * width * Vector2(-along.y(), along.x());
  edges.push_back({start + across, end + across});
  edges.push_back({start - across, end - across});
}

void addCircle(std::vector<FieldEdge>& edges, double radius) {
  const auto at = [&](int i) {
    const double angle = 2 * kPi * i / kCircleSides;
    return Vector2(radius * std::cos(angle), radius * std::sin(angle));
  };
  for (int i = 0; i < kCircleSides; ++i) edges.push_back({at(i), at(i + 1)});
}

/// The lines and walls at the end of the field in direction `side`, 1 or -1.
void addEnd(std::vector<FieldEdge>& edges, const FieldDescription& field, double side) {
  const double goalLine = side * field.goalLineX(), half = 0.5 * field.lineWidth;
  const double inner = goalLine - side * half;
  if (field.lineWidth > 0 && field.penaltyAreaLength > 0) {
    const double front = goalLine - side * (field.penaltyAreaLength - half);
    const double y = 0.5 * field.penaltyAreaWidth - half;
    addLine(edges, {front, -y}, {front, y}, field.lineWidth);
    addLine(edges, {goalLine, -y}, {front, -y}, field.lineWidth);
    addLine(edges, {goalLine, y}, {front, y}, field.lineWidth);
  }
  if (field.hasBoundary()) {
    addLine(edges, {inner, -field.touchLineY()}, {inner, field.touchLineY()}, field.lineWidth);
  } else if (field.lineWidth > 0) {
    addLine(edges, {inner, -0.5 * field.goalWidth}, {inner, 0.5 * field.goalWidth}, field.lineWidth);
  }
  if (field.wallHeight <= 0) return;
  const double x = side * 0.5 * field.length, y = 0.5 * field.width, corner = field.cornerTriangleSide;
  for (const double flank : {-1.0, 1.0}) {
    edges.push_back({{x, flank * 0.5 * field.goalWidth}, {x, flank * (y - corner)}});
    if (corner > 0) edges.push_back({{x, flank * (y - corner)}, {x - side * corner, flank * y}});
  }
}

}  // namespace

double FieldEdge::direction() const {
  const Vector2 along = end - start;
  return std::remainder(std::atan2(along.y(), along.x()), kPi);
}

Vector2 FieldEdge::nearest(const Vector2& point) const {
  const Vector2 along = end - start;
  const double square = along.squaredNorm();
  const double share = square > 0 ? std::clamp((point - start).dot(along) / square, 0.0, 1.0) : 0;
  return start + share * along;
}

std::vector<FieldEdge> fieldEdges(const FieldDescription& field) {
  std::vector<FieldEdge> edges;
  const double touchLine = field.touchLineY();
  if (field.lineWidth > 0) {
    addLine(edges, {0, -touchLine}, {0, touchLine}, field.lineWidth);
    if (field.centerCircleDiameter > 0) {
      addCircle(edges, 0.5 * (field.centerCircleDiameter + field.lineWidth));
      addCircle(edges, 0.5 * (field.centerCircleDiameter - field.lineWidth));
    }
  }
  for (const double side : {-1.0, 1.0}) {
    addEnd(edges, field, side);
    const double inner = side * (touchLine - 0.5 * field.lineWidth);
    if (field.hasBoundary())
      addLine(edges, {-field.goalLineX(), inner}, {field.goalLineX(), inner}, field.lineWidth);
    if (field.wallHeight > 0) {
      const double x = 0.5 * field.length - field.cornerTriangleSide, y = side * 0.5 * field.width;
      edges.push_back({{-x, y}, {x, y}});
    }
  }
  return edges;
}

}  // namespace robotlink
