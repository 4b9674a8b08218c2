// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "colortool/image/Regions.h"
#include "modules/perception/BallGeometry.h"
#include "robotlink/base/Image.h"

namespace modules {

/// Finds the ball by its edge: from the center of each region of its color, rays are followed through the
/// image until the color changes. A circle is fitted robustly to these points, so that hidden, cut-off or
/// shaded parts do not matter.
///
/// Colors are compared by Cb and Cr relative to Y, which do not depend on brightness. The circle is the
/// three-point circle with the most inliers, refined by least squares over these (Kasa 1976). Buffers are
/// reused; one thread at a time.
class CircleBallFinder {
 public:
  struct Options {
    /// Minimum size of a region, pixels.
    int minimumArea = 6;
    /// The number of the largest regions to try.
    int candidates = 4;
    /// Rays per region.
    int rays = 24;
    /// A larger difference in Cb / Y and Cr / Y is an edge.
    double colorDifference = 0.3;
    /// The distance of an inlier from the circle, at most, pixels.
    double tolerance = 1.2;
    /// The fraction of edge points.
    double minimumInliers = 0.55;
    BallGeometry::Options geometry;
  };
  /// A point where the color changes, pixels.
  struct EdgePoint {
    robotlink::Vector2 at;
    bool onCircle = false;
  };
  explicit CircleBallFinder(const Options& options) : options_(options), geometry_(options.geometry) {}
  void setOptions(const Options& options) {
    options_ = options;
    geometry_ = BallGeometry(options.geometry);
  }

  /// `image` must be kYuyv; `regions` are those of the ball's color, largest first.
  BallObservation find(const robotlink::ImageView& image, std::span<const colortool::Region> regions,
                       const CameraView& view);
  /// The edge points of the last ball found; for drawings.
  const std::vector<EdgePoint>& edge() const { return foundEdge_; }

 private:
  /// Collects edge points around a region.
  void scanEdge(const robotlink::ImageView& image, const colortool::Region& region);
  /// The circle with the most inliers; empty if there are too few.
  std::optional<BallDisc> fitCircle();
  /// The number of inliers of a circle.
  int countFollowers(const BallDisc& disc) const;
  /// Improves a circle by least squares over its inliers.
  bool refine(BallDisc& disc) const;

  Options options_;
  BallGeometry geometry_;
  std::vector<EdgePoint> edge_;
  std::vector<EdgePoint> foundEdge_;
};

}  // namespace modules
