// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "robotlink/base/Random.h"

namespace modules {

/// The places of a map at which a robot can be: far enough from walls, and inside of the building. Inside are
/// walls on at least three of four sides; and no way as wide as the robot leads there from beyond the map,
/// unless one leads to the map's home, too: maps of real buildings have gaps. Immutable.
class FreeSpace {
 public:
  /// `clearance`: m, that the robot's middle needs.
  FreeSpace(const DistanceMap& distances, const robotlink::GroundMap& map, double clearance);

  bool empty() const { return cells_.empty(); }
  double area() const;  ///< m^2
  bool contains(const robotlink::Vector2& place) const;
  /// Evenly distributed, with any heading. Not if it is empty.
  robotlink::Pose2 draw(robotlink::Random& random) const;

 private:
  GridFrame frame_;
  std::vector<std::uint8_t> inside_;  // by cell
  std::vector<std::uint32_t> cells_;  // indices of those inside
};

}  // namespace modules
