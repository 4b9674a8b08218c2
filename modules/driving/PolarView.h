// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "robotlink/base/Geometry.h"

namespace modules {

/// A polar histogram of the obstacles around a robot: how far a robot of some width could drive straight in
/// each direction. Sector i is centered at the angle angleOf(i), counterclockwise from the front. A plain
/// value.
class PolarView {
 public:
  /// Sectors of 5 degrees.
  static constexpr int kSectors = 72;
  static constexpr double kSector = 2 * robotlink::kPi / kSectors;

  /// `points` are obstacles in the robot's frame; `halfWidth` is that of the corridor that must be free, m;
  /// what is farther away than `reach`, m, does not count.
  PolarView(std::span<const robotlink::Vector2> points, double halfWidth, double reach);

  /// The free distance in a direction, from the robot's center to the first obstacle, m; at most reach(). Any
  /// sector number or angle is valid.
  double free(int sector) const { return free_[static_cast<std::size_t>(wrapped(sector))]; }
  double freeAt(double angle) const { return free(sectorOf(angle)); }
  /// The minimum over the sectors within `half` of an angle.
  double freeAbout(double angle, double half) const;
  double reach() const { return reach_; }

  /// A sector number in [0, kSectors).
  static int wrapped(int sector) { return (sector % kSectors + kSectors) % kSectors; }
  static int sectorOf(double angle) { return wrapped(static_cast<int>(std::lround(angle / kSector))); }
  static double angleOf(int sector) { return robotlink::normalizedAngle(wrapped(sector) * kSector); }

 private:
  double reach_;
  /// The free distance in each sector, m.
  std::array<double, kSectors> free_;
};

}  // namespace modules
