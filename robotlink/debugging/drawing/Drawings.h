// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/base/Image.h"

namespace foxglove {
class ImageAnnotations;
class SceneEntity;
}  // namespace foxglove

namespace robotlink {

/// A color with opacity.
struct Color {
  // 0 is transparent, 1 opaque.
  Rgb rgb;
  double alpha = 1;
};

/// Colors that are easy to tell apart on a field, for drawings.
namespace colors {
inline constexpr Color kRed{{220, 40, 40}}, kGreen{{40, 180, 60}}, kBlue{{40, 90, 230}},
    kYellow{{240, 210, 40}}, kOrange{{250, 130, 20}}, kPink{{250, 90, 170}}, kSkyBlue{{90, 200, 240}},
    kWhite{{255, 255, 255}}, kBlack{{0, 0, 0}}, kGray{{128, 128, 128}};
}  // namespace colors

/// Draws in the plane of an image: pixels, (0, 0) is the upper left corner, y points down; line widths are in
/// pixels of the screen. It refers to a message of the current frame: do not keep it. Shapes with a
/// coordinate that is not finite are ignored. Ellipses become loops of 32 points, arrows lines; `time` is
/// that of the image drawn on.
class ImageDrawing {
 public:
  explicit ImageDrawing(foxglove::ImageAnnotations& to, Instant time = {}) : to_(to), time_(time) {}
  void line(const Vector2& from, const Vector2& to, Color color, double width = 1);
  void arrow(const Vector2& from, const Vector2& to, Color color, double width = 1);
  void circle(const Vector2& center, double radius, Color color, double width = 1, Color fill = {{}, 0});
  /// `angle` is that of the first axis to the image's x-axis, rad, clockwise as seen.
  void ellipse(const Vector2& center, const Vector2& radii, double angle, Color color, double width = 1);
  void polygon(std::span<const Vector2> corners, Color color, double width = 1, Color fill = {{}, 0});
  void rectangle(const Vector2& upperLeft, const Vector2& lowerRight, Color color, double width = 1);
  /// `size` is the dot's diameter in pixels of the screen.
  void dot(const Vector2& at, Color color, double size = 3);
  /// `at` is the lower left corner of the text.
  void text(const Vector2& at, const std::string& text, Color color, double size = 10);

 private:
  foxglove::ImageAnnotations& to_;
  Instant time_;
};

/// Draws in a frame of the world (field or robot), in meters. The same drawing is shown in the Field view
/// from above and in the Scene view in 3-D. Line widths are in pixels of the screen. It refers to a message
/// of the current frame: do not keep it. Shapes with a coordinate that is not finite are ignored. Circles and
/// ellipses become loops of 32 points, fills triangles; flat shapes lie 5 mm above the ground so that the
/// ground does not hide them.
class SceneDrawing {
 public:
  explicit SceneDrawing(foxglove::SceneEntity& to) : to_(to) {}
  static constexpr double kGroundHeight = 0.005;
  // Flat shapes on the ground.
  void line(const Vector2& from, const Vector2& to, Color color, double width = 1);
  void arrow(const Vector2& from, const Vector2& to, Color color, double width = 1);
  void circle(const Vector2& center, double radius, Color color, double width = 1, Color fill = {{}, 0});
  void ellipse(const Vector2& center, const Vector2& radii, double angle, Color color, double width = 1);
  void polygon(std::span<const Vector2> corners, Color color, double width = 1, Color fill = {{}, 0});
  void dot(const Vector2& at, Color color, double diameter = 0.03);
  void pose(const Pose2& pose, Color color, double length = 0.2);
  /// A pose of many, such as a particle: a filled triangle that points ahead, in a twelfth of pose()'s
  /// bytes.
  void dart(const Pose2& pose, Color color, double length = 0.1);
  void text(const Vector2& at, const std::string& text, Color color, double size = 12);
  // Shapes in space.
  void line(const Vector3& from, const Vector3& to, Color color, double width = 1);
  void sphere(const Vector3& center, double radius, Color color);
  void box(const Pose3& boxInFrame, const Vector3& size, Color color);
  void axes(const Pose3& poseInFrame, double length);

 private:
  foxglove::SceneEntity& to_;
};

}  // namespace robotlink
