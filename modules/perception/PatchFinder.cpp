// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/PatchFinder.h"

#include <algorithm>

namespace modules {

using colortool::Region;
using robotlink::Vector2;

std::vector<RobotObservation> PatchFinder::findPatches(std::span<const Region> regions,
                                                       std::span<const int> teamClasses,
                                                       const CameraView& view) const {
  std::vector<RobotObservation> found;
  for (const Region& region : regions) {
    const bool ofTeam = std::ranges::find(teamClasses, region.colorClass) != teamClasses.end();
    if (!ofTeam || region.area < options_.minimumArea) continue;
    // Patches nearly as high as the camera give no distance.
    const auto place = view.onPlane(Vector2(region.centerX, region.centerY), options_.patchHeight);
    if (!place || place->norm() < options_.minimumDistance || place->norm() > options_.maximumDistance)
      continue;
    found.push_back({region.colorClass, *place, std::min(1.0, region.area / 100.0), region.area});
  }
  return found;
}

std::vector<RobotObservation> PatchFinder::findClusters(std::span<const Region> regions,
                                                        std::span<const int> teamClasses,
                                                        const CameraView& view) const {
  std::vector<RobotObservation> robots;
  for (const RobotObservation& patch : findPatches(regions, teamClasses, view)) {
    const auto near = std::ranges::find_if(robots, [&](const RobotObservation& robot) {
      return robot.teamClass == patch.teamClass &&
             (robot.positionInRobot - patch.positionInRobot).norm() < options_.robotLength;
    });
    if (near == robots.end()) {
      robots.push_back(patch);
      continue;
    }
    const double share = static_cast<double>(patch.area) / (near->area + patch.area);
    near->positionInRobot += share * (patch.positionInRobot - near->positionInRobot);
    near->area += patch.area;
    near->confidence = std::min(1.0, near->area / 100.0);
  }
  return robots;
}

}  // namespace modules
