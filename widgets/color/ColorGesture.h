// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "colortool/PixelArea.h"
#include "colortool/SnappedWay.h"

namespace widgets {

/// What the mouse does in an image of the colour tool.
enum class ColorTool : std::uint8_t {
  kPoint,      ///< the pixel that is clicked
  kBrush,      ///< all along the way of the mouse
  kRectangle,  ///< between press and release
  kLasso,      ///< inside of the way of the mouse
  kWand,       ///< what is of like colour around the pixel that is clicked
  kEraser,     ///< takes strokes away along the way of the mouse
  kSelect,     ///< selects the colours inside of the way of the mouse, for all views
  kMove,       ///< moves the image
};

/// Whether strokes change already while the mouse moves, or when it is released.
bool isLive(ColorTool tool);
/// Returns the name of the tool as strokes in samples have it: "brush".
const char* toolName(ColorTool tool);

/// What a tool touches between press and release of the mouse button. Points in the image as
/// colortool::ImagePoint has them. A plain value, without Qt.
class ColorGesture {
 public:
  struct Options {
    ColorTool tool = ColorTool::kBrush;
    double radius = 3;  ///< of brush and eraser, pixels
    /// The brush stays on what it is led along where the mouse slips off a thin line, and leaves out what
    /// has another color than that.
    bool careful = false;
    double tolerance = 24;  ///< of the careful brush, see carefulBrushArea()
    colortool::WandOptions wand;
  };
  ColorGesture(const colortool::ColorImage& image, Options options, colortool::ImagePoint at);

  void moveTo(const colortool::ColorImage& image, colortool::ImagePoint at);
  ColorTool tool() const { return options_.tool; }
  /// What is touched so far.
  const colortool::PixelArea& area() const { return area_; }
  /// The way so far; of a rectangle its two corners.
  const std::vector<colortool::ImagePoint>& way() const { return way_; }

 private:
  void touch(const colortool::ColorImage& image);
  colortool::PixelArea touchedLast(const colortool::ColorImage& image);

  Options options_;
  std::vector<colortool::ImagePoint> way_;
  std::optional<colortool::SnappedWay> snapped_;  ///< of the careful brush
  colortool::PixelArea area_;
};

}  // namespace widgets
