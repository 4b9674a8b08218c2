// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/localization/FieldEdgeMap.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace modules {

using robotlink::FieldDescription;
using robotlink::kPi;
using robotlink::Vector2;

namespace {

/// The distance by which the map extends beyond the surface, m.
constexpr double kEdgeMargin = 0.1;
/// The resolution of the distances, m.
constexpr double kUnit = 0.002;
/// The difference that a direction may have from that of an edge, rad.
constexpr double kSimilar = kPi / 6;

/// The difference of two directions of lines, which are the same after half a turn; from 0 to pi/2.
double between(double a, double b) {
  return std::abs(std::remainder(a - b, kPi));
}

}  // namespace

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
