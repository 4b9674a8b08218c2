// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modules/perception/CameraView.h"

namespace modules {

/// A ball as one image shows it.
struct BallObservation {
  bool seen = false;
  robotlink::Vector2 centerInImage = robotlink::Vector2::Zero();    ///< pixels
  double radiusInImage = 0;                                         ///< pixels
  robotlink::Vector2 positionInRobot = robotlink::Vector2::Zero();  ///< m, on the ground
  double confidence = 0;                                            ///< 0 to 1
};

/// A disc in the image that may be the ball.
struct BallDisc {
  robotlink::Vector2 center = robotlink::Vector2::Zero();  ///< pixels
  double radius = 0;                                       ///< pixels
  /// Standard deviation of the radius, pixels; large where too little of the edge is seen.
  double radiusDeviation = 0.6;
};

/// From the disc of the ball in the image to its place on the ground, and whether it can be there at all.
///
/// Two measurements are weighed by their variances: where the ray through the centre meets the level plane at
/// the height of the ball's middle (good near by, bad far off), and the distance that follows from the radius
/// (the reverse, and useless where the ball is cut off). They must agree within what the posture of a walking
/// body leaves uncertain; orange things in the air, on shirts or much larger than a ball fail there.
class BallGeometry {
 public:
  struct Options {
    double ballRadius = 0.042;     ///< m
    double maximumDistance = 5.0;  ///< m
    double tiltDeviation = 0.03;   ///< rad, of the camera's elevation
    double gate = 3;               ///< standard deviations that the two measurements may differ
  };
  explicit BallGeometry(const Options& options) : options_(options) {}

  /// None if no ball can look so. `confidence` of the result tells how well the two measurements agree.
  std::optional<BallObservation> locate(const BallDisc& disc, const CameraView& view) const;
  /// Pixels of the radius of a ball with its middle at this place.
  double radiusAt(const robotlink::Vector2& positionInRobot, const CameraView& view) const;

 private:
  /// Middle of the ball that has this size in the image.
  robotlink::Vector3 middleBySize(const BallDisc& disc, const CameraView& view) const;

  Options options_;
};

}  // namespace modules
