// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "modules/perception/CameraView.h"
#include "robotlink/base/Image.h"

namespace modules {

/// A point where green turns into white or white into green, at the edge of a line or the foot of a wall.
struct LinePoint {
  /// Pixels.
  robotlink::Vector2 inImage = robotlink::Vector2::Zero();
  /// The position on the ground, m.
  robotlink::Vector2 inRobot = robotlink::Vector2::Zero();
  /// The direction of the edge in the robot's frame, from -pi/2 to pi/2, rad; NaN if the image does not show
  /// it.
  double direction = 0;
};

/// Finds edges of lines on scan lines along columns and rows of the image, below the horizon (Röfer, Jüngel:
/// Vision-based fast and reactive Monte-Carlo localization, ICRA 2003).
///
/// Green and white are told apart by Cb and Cr relative to Y, which depend on the brightness and the color of
/// the light much less than a color table, and by the jump in Y. The place of an edge is where Y crosses the
/// mean of both sides; its direction is perpendicular to the gradient of Y. Only some thousand pixels are
/// read. Buffers are reused; one thread at a time.
class FieldLineScanner {
 public:
  struct Options {
    /// Distance between scan lines along columns and along rows, pixels.
    int columnSpacing = 8, rowSpacing = 10;
    /// Minimum difference in Y of white and green.
    int contrast = 30;
    /// The distance of Cr of green below the middle, as a fraction of Y.
    double greenness = 0.25;
    /// The maximum distance of Cb and Cr of white from the middle, as a fraction of Y.
    double whiteness = 0.25;
    /// The number of pixels of other colors that may be between green and white.
    int maximumGap = 3;
    /// Points nearer than this are on the robot's own body, m.
    double minimumDistance = 0.2;
    /// Meters.
    double maximumDistance = 2.5;
    int maximumPoints = 60;
  };
  explicit FieldLineScanner(const Options& options) : options_(options) {}
  void setOptions(const Options& options) { options_ = options; }

  /// `image` must be kYuyv. Points of columns come first, from left to right, then those of rows; of too many
  /// points some are left out evenly. Valid until the next call.
  const std::vector<LinePoint>& find(const robotlink::ImageView& image, const CameraView& view);

 private:
  enum class Surface { kOther, kGreen, kWhite };
  /// A place in the image, pixels.
  struct Pixel {
    int x = 0, y = 0;
  };
  Surface surfaceOf(robotlink::YCbCr color) const;
  /// Reads `count` pixels from a place on, in steps of one pixel.
  void scan(const robotlink::ImageView& image, const CameraView& view, Pixel start, Pixel step, int count);
  /// Adds the edge between two pixels of a scan line.
  void addEdge(const robotlink::ImageView& image, const CameraView& view, Pixel from, Pixel to);
  /// The direction on the ground of the edge at a pixel; NaN if there is none.
  static double direction(const robotlink::ImageView& image, const CameraView& view,
                          const robotlink::Vector2& at);

  Options options_;
  /// The options as they are compared with pixels: fractions in units of 1/64.
  int greenness_ = 0, whiteness_ = 0;
  std::vector<LinePoint> points_;
};

}  // namespace modules
