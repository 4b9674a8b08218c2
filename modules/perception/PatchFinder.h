// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "colortool/Regions.h"
#include "modules/perception/CameraView.h"

namespace modules {

/// Another robot as one image shows it.
struct RobotObservation {
  int teamClass = 0;                                                ///< colour class of its team's patches
  robotlink::Vector2 positionInRobot = robotlink::Vector2::Zero();  ///< m
  double confidence = 0;                                            ///< 0 to 1
  int area = 0;                                                     ///< pixels of its patches
};

/// Finds other robots by the patches of their team's colour.
///
/// The distance of a patch follows from the height that patches are at on a body. findPatches() takes every
/// patch for itself; findClusters() takes patches that are less than a robot's length apart for one robot, at
/// their mean weighted by area.
class PatchFinder {
 public:
  struct Options {
    int minimumArea = 12;           ///< pixels, of a patch
    double patchHeight = 0.13;      ///< m
    double minimumDistance = 0.25;  ///< m: nearer patches are the robot's own
    double maximumDistance = 3;     ///< m
    double robotLength = 0.3;       ///< m
  };
  explicit PatchFinder(const Options& options) : options_(options) {}

  std::vector<RobotObservation> findPatches(std::span<const colortool::Region> regions,
                                            std::span<const int> teamClasses, const CameraView& view) const;
  std::vector<RobotObservation> findClusters(std::span<const colortool::Region> regions,
                                             std::span<const int> teamClasses, const CameraView& view) const;

 private:
  Options options_;
};

}  // namespace modules
