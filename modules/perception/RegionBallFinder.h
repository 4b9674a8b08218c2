// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "colortool/Regions.h"
#include "modules/perception/BallGeometry.h"

namespace modules {

/// Finds the ball among the regions of its colour, by shape, size and place.
///
/// Where the image's border cuts a region, the disc follows from the chord and the height of what is seen.
/// The region whose place, shape and size fit best wins; among equals the largest.
class RegionBallFinder {
 public:
  struct Options {
    int minimumArea = 6;          ///< pixels
    double minimumFill = 0.5;     ///< share of the disc that must have the colour
    double maximumStretch = 1.8;  ///< of width and height, where nothing is cut off
    BallGeometry::Options geometry;
  };
  explicit RegionBallFinder(const Options& options) : options_(options), geometry_(options.geometry) {}

  BallObservation find(std::span<const colortool::Region> regions, const CameraView& view) const;

  /// The disc behind a region; radius 0 if its shape is not that of a ball.
  BallDisc discOf(const colortool::Region& region, const CameraView& view) const;

 private:
  Options options_;
  BallGeometry geometry_;
};

}  // namespace modules
