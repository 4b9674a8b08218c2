// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "robotlink/base/Geometry.h"

namespace modules {

/// How far a robot of some width could drive straight in each direction from where it stands: the obstacles
/// around it as a polar histogram. Sector i looks along its middle, `angleOf(i)`, counter-clockwise from the
/// front.
class PolarView {
 public:
  static constexpr int kSectors = 72;
  static constexpr double kSector = 2 * robotlink::kPi / kSectors;

  /// `points`: in the robot's frame; `halfWidth`: m, of the way that must be free; `reach`: m, beyond which
  /// nothing counts.
  PolarView(std::span<const robotlink::Vector2> points, double halfWidth, double reach);

  /// m, from the robot's middle to what is first in the way.
  double free(int sector) const { return free_[static_cast<std::size_t>(wrapped(sector))]; }
  double freeAt(double angle) const { return free(sectorOf(angle)); }
  /// The least of the sectors within `half` of an angle.
  double freeAbout(double angle, double half) const;
  double reach() const { return reach_; }

  static int wrapped(int sector) { return (sector % kSectors + kSectors) % kSectors; }
  static int sectorOf(double angle) { return wrapped(static_cast<int>(std::lround(angle / kSector))); }
  static double angleOf(int sector) { return robotlink::normalizedAngle(wrapped(sector) * kSector); }

 private:
  double reach_;
  std::array<double, kSectors> free_;
};

}  // namespace modules
