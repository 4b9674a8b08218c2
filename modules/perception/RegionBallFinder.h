// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "colortool/image/Regions.h"
#include "modules/perception/BallGeometry.h"

namespace modules {

/// Finds the ball among the regions of its color, by shape, size and position.
///
/// If the border of the image cuts a region, the disc follows from the chord and the height of the visible
/// part. The region whose position, shape and size fit best wins; among equals the largest. Immutable; any
/// thread.
class RegionBallFinder {
 public:
  struct Options {
    /// Pixels.
    int minimumArea = 6;
    /// The fraction of the disc that must have the color.
    double minimumFill = 0.5;
    /// Ratio of width and height of a region that is not cut off.
    double maximumStretch = 1.8;
    BallGeometry::Options geometry;
  };
  explicit RegionBallFinder(const Options& options) : options_(options), geometry_(options.geometry) {}

  BallObservation find(std::span<const colortool::Region> regions, const CameraView& view) const;

  /// The disc to which a region belongs; its radius is 0 if the shape is not that of a ball.
  BallDisc discOf(const colortool::Region& region, const CameraView& view) const;

 private:
  Options options_;
  BallGeometry geometry_;
};

}  // namespace modules
