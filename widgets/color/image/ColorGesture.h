// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "colortool/image/PixelArea.h"
#include "colortool/training/SnappedWay.h"

namespace widgets {

/// The mouse tools of the color image.
enum class ColorTool : std::uint8_t {
  /// The pixel that is clicked.
  kPoint,
  /// All pixels within a radius of the mouse's path.
  kBrush,
  /// The rectangle between press and release.
  kRectangle,
  /// The inside of the mouse's path.
  kLasso,
  /// The connected area of similar color around the pixel that is clicked.
  kWand,
  /// Removes strokes along the mouse's path.
  kEraser,
  /// Selects the colors inside of the mouse's path, for all views.
  kSelect,
  /// Pans the image.
  kMove,
};

/// Whether samples change while the mouse moves; if not, when the button is released.
bool isLive(ColorTool tool);
/// Returns the name of the tool as strokes in samples have it: "brush".
const char* toolName(ColorTool tool);

/// The area that a tool touches between press and release of the mouse button. Points are image coordinates
/// as in colortool::ImagePoint. Independent of Qt; a plain value.
class ColorGesture {
 public:
  /// The settings of the tool.
  struct Options {
    ColorTool tool = ColorTool::kBrush;
    double radius = 3;  ///< of brush and eraser, pixels
    /// The brush stays on what it is led along where the mouse slips off a thin line, and leaves out what
    /// has another color than that.
    bool careful = false;
    /// Color tolerance of the careful brush, see colortool::carefulBrushArea().
    double tolerance = 24;
    colortool::WandOptions wand;
  };
  /// The button was pressed at `at`. All calls must get the same image.
  ColorGesture(const colortool::ColorImage& image, Options options, colortool::ImagePoint at);

  /// The mouse was moved; ignored by kPoint and kWand.
  void moveTo(const colortool::ColorImage& image, colortool::ImagePoint at);
  ColorTool tool() const { return options_.tool; }
  /// The pixels touched so far.
  const colortool::PixelArea& area() const { return area_; }
  /// The mouse's path so far; of a rectangle two corners.

 private:
  /// Adds what the last point of the path touches.
  void touch(const colortool::ColorImage& image);
  colortool::PixelArea touchedLast(const colortool::ColorImage& image);

  Options options_;
  std::vector<colortool::ImagePoint> way_;
  std::optional<colortool::SnappedWay> snapped_;  ///< of the careful brush
  colortool::PixelArea area_;
};

}  // namespace widgets
