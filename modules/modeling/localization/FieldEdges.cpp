// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/localization/FieldEdges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace modules {

using robotlink::FieldDescription;
using robotlink::kPi;
using robotlink::Vector2;

namespace {

/// How far the map extends beyond the surface, m.
constexpr double kEdgeMargin = 0.1;
/// The resolution of the distances, m.
constexpr double kUnit = 0.002;
/// How far a direction may be from that of an edge, rad.
constexpr double kSimilar = kPi / 6;
constexpr int kCircleSides = 16;

/// The difference of two directions of lines, which are the same after half a turn; from 0 to pi/2.
double between(double a, double b) {
  return std::abs(std::remainder(a - b, kPi));
}

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

FieldEdgeMap::FieldEdgeMap(const FieldDescription& field)
    : edges_(fieldEdges(field)),
      originX_(-0.5 * field.length - kEdgeMargin),
      originY_(-0.5 * field.width - kEdgeMargin),
      columns_(static_cast<int>(std::ceil((field.length + 2 * kEdgeMargin) / kCell))),
      rows_(static_cast<int>(std::ceil((field.width + 2 * kEdgeMargin) / kCell))),
      cells_(static_cast<std::size_t>(kClasses + 1) * static_cast<std::size_t>(columns_) *
                 static_cast<std::size_t>(rows_),
             255) {
  const auto size = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  for (const FieldEdge& edge : edges_) {
    std::array<bool, kClasses + 1> in{};
    in[kClasses] = true;
    for (int i = 0; i < kClasses; ++i)
      in[static_cast<std::size_t>(i)] = between(edge.direction(), i * kPi / kClasses) < kSimilar;
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const Vector2 center(originX_ + (column + 0.5) * kCell, originY_ + (row + 0.5) * kCell);
        const double distance = (edge.nearest(center) - center).norm();
        const auto value = static_cast<std::uint8_t>(std::min(255.0, distance / kUnit));
        const auto cell = static_cast<std::size_t>(row * columns_ + column);
        for (std::size_t i = 0; i < in.size(); ++i)
          if (in[i]) cells_[i * size + cell] = std::min(cells_[i * size + cell], value);
      }
    }
  }
}

int FieldEdgeMap::classOf(double direction) {
  if (!std::isfinite(direction)) return kClasses;
  const int nearest = static_cast<int>(std::lround(direction * kClasses / kPi)) % kClasses;
  return nearest < 0 ? nearest + kClasses : nearest;
}

double FieldEdgeMap::distance(const Vector2& point, double direction) const {
  const double x = (point.x() - originX_) / kCell, y = (point.y() - originY_) / kCell;
  if (!(x >= 0 && y >= 0 && x < columns_ && y < rows_)) return kMaximum;
  const auto cell = static_cast<std::size_t>(static_cast<int>(y) * columns_ + static_cast<int>(x));
  const auto size = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  return kUnit * cells_[static_cast<std::size_t>(classOf(direction)) * size + cell];
}

std::optional<FieldEdge> FieldEdgeMap::nearestEdge(const Vector2& point, double direction) const {
  std::optional<FieldEdge> best;
  double nearest = kMaximum;
  for (const FieldEdge& edge : edges_) {
    if (std::isfinite(direction) && between(edge.direction(), direction) >= kSimilar) continue;
    const double distance = (edge.nearest(point) - point).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = edge;
  }
  return best;
}

}  // namespace modules
