// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modules/perception/CameraView.h"

namespace modules {

/// The ball as seen in one image.
struct BallObservation {
  bool seen = false;
  /// Pixels.
  robotlink::Vector2 centerInImage = robotlink::Vector2::Zero();
  /// Pixels.
  double radiusInImage = 0;
  /// The position on the ground, m.
  robotlink::Vector2 positionInRobot = robotlink::Vector2::Zero();
  /// From 0 to 1.
  double confidence = 0;
};

/// A disc in the image that may be the ball.
struct BallDisc {
  /// Pixels.
  robotlink::Vector2 center = robotlink::Vector2::Zero();
  /// Pixels.
  double radius = 0;
  /// Standard deviation of the radius, pixels; large if too little of the edge is visible.
  double radiusDeviation = 0.6;
};

/// Computes the position of the ball on the ground from its disc in the image, and whether a ball can be
/// there at all.
///
/// Two measurements are combined by their variances: the intersection of the ray through the center with the
/// horizontal plane at the height of the ball's center (accurate if near, inaccurate if far), and the
/// distance that follows from the radius (the reverse, and useless if the ball is cut off). They must agree
/// within the uncertainty of a walking body's posture; orange objects in the air, on shirts, or much larger
/// than a ball are rejected by that.
class BallGeometry {
 public:
  struct Options {
    /// Meters.
    double ballRadius = 0.042;
    /// Meters.
    double maximumDistance = 5.0;
    /// Standard deviation of the camera's elevation, rad.
    double tiltDeviation = 0.03;
    /// The number of standard deviations by which the two measurements may differ.
    double gate = 3;
  };
  explicit BallGeometry(const Options& options) : options_(options) {}

  /// Empty if the disc cannot be a ball. The confidence of the result is how well the two measurements agree.
  std::optional<BallObservation> locate(const BallDisc& disc, const CameraView& view) const;

 private:
  /// The center of a ball of this size in the image.
  robotlink::Vector3 middleBySize(const BallDisc& disc, const CameraView& view) const;

  Options options_;
};

}  // namespace modules
