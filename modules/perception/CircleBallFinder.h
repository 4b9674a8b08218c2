// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "colortool/Regions.h"
#include "modules/perception/BallGeometry.h"
#include "robotlink/base/Image.h"

namespace modules {

/// Finds the ball by its edge: from the middle of each region of its colour, rays are followed through the
/// image until the colour changes; a circle is fitted to these points, robustly, so that parts which are
/// hidden, cut off or in shadow do not matter.
///
/// Colours are compared by Cb and Cr in proportion to Y, which light leaves alone. The circle comes from the
/// three-point circle with the most followers, then by least squares from those (Kasa 1976). Keeps its
/// memory; one thread at a time.
class CircleBallFinder {
 public:
  struct Options {
    int minimumArea = 6;  ///< pixels, of the regions to begin with
    int candidates = 4;   ///< the largest regions
    int rays = 24;
    double colorDifference = 0.3;  ///< of Cb and Cr divided by Y
    double tolerance = 1.2;        ///< pixels that a point may be off the circle
    double minimumInliers = 0.55;  ///< share of the edge's points
    BallGeometry::Options geometry;
  };
  struct EdgePoint {
    robotlink::Vector2 at;
    bool onCircle = false;
  };
  explicit CircleBallFinder(const Options& options) : options_(options), geometry_(options.geometry) {}
  void setOptions(const Options& options) {
    options_ = options;
    geometry_ = BallGeometry(options.geometry);
  }

  /// `image` must be kYuyv. `regions`: those of the ball's colour, largest first.
  BallObservation find(const robotlink::ImageView& image, std::span<const colortool::Region> regions,
                       const CameraView& view);
  /// The edge points of the last ball that was found.
  const std::vector<EdgePoint>& edge() const { return foundEdge_; }

 private:
  void scanEdge(const robotlink::ImageView& image, const colortool::Region& region);
  std::optional<BallDisc> fitCircle();
  int countFollowers(const BallDisc& disc) const;
  bool refine(BallDisc& disc) const;

  Options options_;
  BallGeometry geometry_;
  std::vector<EdgePoint> edge_;
  std::vector<EdgePoint> foundEdge_;
};

}  // namespace modules
