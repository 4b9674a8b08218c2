// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modules/perception/CameraView.h"
#include "modules/perception/FieldLandmarks.h"

namespace modules {

/// Pixels; left and top inclusive, right and bottom exclusive.
struct ImageBox {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  robotlink::Vector2 center() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
};

/// A landmark as one image shows it.
struct LandmarkObservation {
  std::size_t landmark = 0;  ///< index into the landmarks that the finder was given
  double bearing = 0;        ///< rad, from the robot's x-axis, counter-clockwise
  double distance = 0;       ///< m, on the ground, from the robot's origin
  ImageBox box;
  double confidence = 0;  ///< 0 to 1
};

/// From the box of a landmark's colours in the image to its bearing and distance, and whether it can be there
/// at all.
///
/// The distance follows from the height of a beacon's two bands or of a goal, or from the width where the
/// height is cut off by the image's border. The middle must then be at its true height above the ground,
/// within what a walking body leaves uncertain.
class LandmarkGeometry {
 public:
  struct Options {
    double minimumHeight = 4;     ///< pixels
    double maximumDistance = 6;   ///< m
    double tiltTolerance = 0.09;  ///< rad, of the camera's elevation
  };
  LandmarkGeometry(const robotlink::FieldDescription& field, const Options& options);

  /// `box` of a beacon: both bands. None if the landmark cannot look so.
  std::optional<LandmarkObservation> locate(const FieldLandmark& landmark, const ImageBox& box,
                                            const CameraView& view) const;

 private:
  struct Size {
    double width, height, middle;  ///< m; `middle`: height of the box's middle above the ground
  };
  Size sizeOf(FieldLandmark::Kind kind) const {
    return kind == FieldLandmark::Kind::kBeacon ? beacon_ : goal_;
  }

  Size beacon_, goal_;
  Options options_;
};

}  // namespace modules
