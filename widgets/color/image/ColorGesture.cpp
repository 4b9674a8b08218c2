// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorGesture.h"

#include <algorithm>
#include <cmath>

namespace widgets {

using colortool::ColorImage;
using colortool::ImagePoint;

bool isLive(ColorTool tool) {
  return tool == ColorTool::kPoint || tool == ColorTool::kBrush || tool == ColorTool::kWand ||
         tool == ColorTool::kEraser;
}

const char* toolName(ColorTool tool) {
  switch (tool) {
    case ColorTool::kPoint:
      return "point";
    case ColorTool::kBrush:
      return "brush";
    case ColorTool::kRectangle:
      return "rectangle";
    case ColorTool::kLasso:
      return "lasso";
    case ColorTool::kWand:
      return "wand";
    case ColorTool::kEraser:
      return "eraser";
    case ColorTool::kSelect:
      return "select";
    case ColorTool::kMove:
      break;
  }
  return "move";
}

ColorGesture::ColorGesture(const ColorImage& image, Options options, ImagePoint at)
    : options_(options), way_{at} {
  touch(image);
}

void ColorGesture::moveTo(const ColorImage& image, ImagePoint at) {
  if (at == way_.back()) return;
  const bool corners = options_.tool == ColorTool::kRectangle;
  const bool oneOnly = options_.tool == ColorTool::kPoint || options_.tool == ColorTool::kWand;
  if (oneOnly) return;
  if (corners && way_.size() == 2)
    way_.back() = at;
  else
    way_.push_back(at);
  touch(image);
}

void ColorGesture::touch(const ColorImage& image) {
  const int width = image.width, height = image.height;
  switch (options_.tool) {
    case ColorTool::kPoint:
      area_ = colortool::brushArea(width, height, way_, 0.5);
      break;
    case ColorTool::kBrush:
    case ColorTool::kEraser:
      area_ = colortool::united(area_, touchedLast(image));
      break;
    case ColorTool::kRectangle:
      area_ = colortool::rectangleArea(width, height, way_.front(), way_.back());
      break;
    case ColorTool::kLasso:
    case ColorTool::kSelect:
      area_ = colortool::polygonArea(width, height, way_);
      break;
    case ColorTool::kWand:
      area_ = colortool::wandArea(image, static_cast<int>(std::lround(way_[0].x)),
                                  static_cast<int>(std::lround(way_[0].y)), options_.wand);
      break;
    case ColorTool::kMove:
      break;
  }
}

/// Only the last piece of the way touches something new.
colortool::PixelArea ColorGesture::touchedLast(const ColorImage& image) {
  if (options_.careful && options_.tool == ColorTool::kBrush) {
    if (snapped_) return snapped_->moveTo(image, way_.back());
    snapped_.emplace(image, way_.back(), options_.radius, options_.tolerance);
    return snapped_->begin(image);
  }
  const std::size_t last = std::min<std::size_t>(way_.size(), 2);
  const std::span piece(way_.end() - static_cast<std::ptrdiff_t>(last), way_.end());
  return colortool::brushArea(image.width, image.height, piece, options_.radius);
}

}  // namespace widgets
