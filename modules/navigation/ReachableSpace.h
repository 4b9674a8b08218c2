// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "robotlink/base/Random.h"

namespace modules {

/// The places of a map where a robot can be: with enough clearance, and inside the building. A place is
/// inside if there are walls on at least three of its four sides, and if no way as wide as the robot leads
/// there from outside the map; unless such a way leads to the map's home, too, because maps of real buildings
/// have gaps. Immutable; any thread.
class ReachableSpace {
 public:
  /// `clearance` is the distance from walls that the robot's center needs, m.
  ReachableSpace(const DistanceMap& distances, const robotlink::GroundMap& map, double clearance);

  bool empty() const { return cells_.empty(); }
  /// Square meters.
  double area() const;
  bool contains(const robotlink::Vector2& place) const;
  /// A random pose, uniformly distributed, with any heading. Must not be called if it is empty.
  robotlink::Pose2 draw(robotlink::Random& random) const;

 private:
  GridFrame frame_;
  /// Whether each cell is inside.
  std::vector<std::uint8_t> inside_;
  /// Indices of the cells inside.
  std::vector<std::uint32_t> cells_;
};

}  // namespace modules
