// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/PolarView.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Vector2;

// A point whose lateral distance from the robot's path is less than this fraction of its distance blocks it,
// however near it is.
constexpr double kNearest = 0.95;

PolarView::PolarView(std::span<const Vector2> points, double halfWidth, double reach) : reach_(reach) {
  free_.fill(reach);
  for (const Vector2& point : points) {
    const double distance = point.norm();
    if (distance > reach + halfWidth) continue;
    const double bearing = std::atan2(point.y(), point.x());
    // A point blocks all directions in which the robot would pass it by less than half its width; if it is
    // nearer than that already, only the directions toward it.
    const double room = std::min(halfWidth, kNearest * distance);
    const double half = distance > 0 ? std::asin(room / distance) : 0;
    const int first = static_cast<int>(std::ceil((bearing - half) / kSector));
    const int last = static_cast<int>(std::floor((bearing + half) / kSector));
    for (int sector = first; sector <= last; ++sector) {
      const double aside = distance * std::sin(sector * kSector - bearing);
      const double ahead = distance * std::cos(sector * kSector - bearing);
      const double until = ahead - std::sqrt(std::max(0.0, room * room - aside * aside));
      double& free = free_[static_cast<std::size_t>(wrapped(sector))];
      free = std::min(free, std::max(0.0, until));
    }
  }
}

double PolarView::freeAbout(double angle, double half) const {
  const int middle = sectorOf(angle), aside = static_cast<int>(half / kSector);
  double least = free(middle);
  for (int i = 1; i <= aside; ++i) least = std::min({least, free(middle - i), free(middle + i)});
  return least;
}

}  // namespace modules
