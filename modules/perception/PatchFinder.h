// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "colortool/image/Regions.h"
#include "modules/perception/CameraView.h"

namespace modules {

/// Another robot, seen in one image.
struct RobotObservation {
  /// Color class of its team's patches.
  int teamClass = 0;
  /// Meters.
  robotlink::Vector2 positionInRobot = robotlink::Vector2::Zero();
  /// From 0 to 1.
  double confidence = 0;
  /// Area of its patches, pixels.
  int area = 0;
};

/// Finds other robots by the patches of their team's color.
///
/// The distance of a patch follows from the height of patches on a body. findPatches() takes each patch as a
/// robot; findClusters() combines patches less than a robot's length apart into one robot, at their mean
/// position weighted by area. Immutable; any thread.
class PatchFinder {
 public:
  struct Options {
    /// Minimum size of a patch, pixels.
    int minimumArea = 12;
    /// Height above the ground, m.
    double patchHeight = 0.13;
    /// Nearer patches are those of the robot itself, m.
    double minimumDistance = 0.25;
    /// Meters.
    double maximumDistance = 3;
    /// Meters.
    double robotLength = 0.3;
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
