// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "modules/perception/CameraView.h"
#include "modules/perception/FieldLandmarks.h"

namespace modules {

/// A box in the image, pixels; left and top are inclusive, right and bottom exclusive.
struct ImageBox {
  double left = 0, top = 0, right = 0, bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
  robotlink::Vector2 center() const { return {0.5 * (left + right), 0.5 * (top + bottom)}; }
};

/// A landmark as seen in one image.
struct LandmarkObservation {
  /// Index into the finder's landmarks.
  std::size_t landmark = 0;
  /// From the robot's x-axis, counterclockwise, rad.
  double bearing = 0;
  /// The distance on the ground, from the robot's origin, m.
  double distance = 0;
  ImageBox box;
  /// From 0 to 1.
  double confidence = 0;
};

/// Computes bearing and distance of a landmark from the box of its colors in the image, and whether it can be
/// there at all.
///
/// The distance follows from the height of a beacon's two bands or of a goal, or from the width if the height
/// is cut off by the border of the image. The center must then be at its true height above the ground, within
/// the uncertainty of a walking body, and a goal must reach down to the ground. Immutable; any thread.
class LandmarkGeometry {
 public:
  struct Options {
    /// Pixels.
    double minimumHeight = 4;
    /// Meters.
    double maximumDistance = 6;
    /// Tolerance of the camera's elevation, rad.
    double tiltTolerance = 0.09;
  };
  LandmarkGeometry(const robotlink::FieldDescription& field, const Options& options);

  /// `box` of a beacon contains both bands. Empty if the landmark cannot look like this.
  std::optional<LandmarkObservation> locate(const FieldLandmark& landmark, const ImageBox& box,
                                            const CameraView& view) const;

 private:
  struct Size {
    /// In m; `middle` is the height of the box's center above the ground.
    double width, height, middle;
  };
  Size sizeOf(FieldLandmark::Kind kind) const {
    return kind == FieldLandmark::Kind::kBeacon ? beacon_ : goal_;
  }

  Size beacon_, goal_;
  Options options_;
};

}  // namespace modules
