// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "robotlink/base/Geometry.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/config/FieldEdges.h"

namespace modules {

using robotlink::FieldEdge;

/// A map of the distances to the nearest edge of a similar direction, so that a point of a line can be
/// compared with a pose at the cost of one look-up (Röfer, Jüngel: Vision-based fast and reactive Monte-Carlo
/// localization, ICRA 2003).
///
/// Directions are sorted into eight classes; an edge is in all classes whose center is within 30 degrees of
/// it. Immutable after its construction, which takes some milliseconds; any thread.
class FieldEdgeMap {
 public:
  /// The side of a cell, m.
  static constexpr double kCell = 0.025;
  /// Distances are bounded by this, and so they are outside of the map, m.
  static constexpr double kMaximum = 0.51;

  explicit FieldEdgeMap(const robotlink::FieldDescription& field);

  /// The distance in m of a point of the field to an edge. `direction` is that of the line at the point in
  /// the field, rad; any edge counts if it is NaN.
  double distance(const robotlink::Vector2& point, double direction) const;
  const std::vector<FieldEdge>& edges() const { return edges_; }
  /// The edge that is nearest to a point and has a similar direction; empty if none is within kMaximum.
  std::optional<FieldEdge> nearestEdge(const robotlink::Vector2& point, double direction) const;

 private:
  static constexpr int kClasses = 8;
  static int classOf(double direction);

  std::vector<FieldEdge> edges_;
  double originX_ = 0, originY_ = 0;
  int columns_ = 0, rows_ = 0;
  /// Distances in units of 2 mm: a map for each class of directions, and one for all.
  std::vector<std::uint8_t> cells_;
};

}  // namespace modules
