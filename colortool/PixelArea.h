// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/ColorImage.h"

namespace colortool {

/// Pixels of one row of an image: from `begin` to `end`, half-open.
struct PixelRun {
  int y = 0;
  int begin = 0;
  int end = 0;
  bool operator==(const PixelRun&) const = default;
};

/// Any pixels of an image: runs from the top row down, from left to right, that neither overlap nor touch.
using PixelArea = std::vector<PixelRun>;

/// A point of an image in pixels; the centre of the upper left pixel is at (0, 0).
struct ImagePoint {
  double x = 0;
  double y = 0;
  bool operator==(const ImagePoint&) const = default;
};

// What tools touch of an image of `width` x `height`. Pure functions; what lies outside is left out.

/// All pixels whose centre is within `radius` of the line through `points` (one point: of a disc).
PixelArea brushArea(int width, int height, std::span<const ImagePoint> points, double radius);
/// The same without what has another color than the pixels along the line: a brush that is wider than what is
/// painted. `tolerance`: how far a color may be from that of the nearest of these pixels, in values of a
/// channel, Y weighing 0.5.
PixelArea carefulBrushArea(const ColorImage& image, std::span<const ImagePoint> points, double radius,
                           double tolerance);
/// Between two corners, both of them inclusive, in any order.
PixelArea rectangleArea(int width, int height, ImagePoint corner, ImagePoint opposite);
/// All pixels whose centre is inside of a closed polygon (even-odd rule).
PixelArea polygonArea(int width, int height, std::span<const ImagePoint> corners);

struct WandOptions {
  /// How far a pixel's colour may be from the mean of what was taken so far, in values of a channel, Y
  /// weighing 0.5.
  double tolerance = 16;
  /// A step between neighbours larger than this is an edge, and not crossed.
  double edge = 24;
  int mostPixels = 200'000;
  bool operator==(const WandOptions&) const = default;
};
/// What is connected with a pixel and of like colour: grows from it in circles, and stops at edges.
PixelArea wandArea(const ColorImage& image, int x, int y, const WandOptions& options = {});

/// What is connected with a pixel and of the same class in an image of classes (kMono8).
PixelArea spotArea(const robotlink::ImageView& classes, int x, int y);

PixelArea united(const PixelArea& a, const PixelArea& b);
/// What of `a` is not in `b`.
PixelArea without(const PixelArea& a, const PixelArea& b);
std::size_t pixelCount(const PixelArea& area);
bool contains(const PixelArea& area, int x, int y);
/// Sides of an area's pixels that other pixels do not share, joined where they are in line: between corners
/// of pixels, that of the upper left pixel at (0, 0).
struct PixelEdge {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool operator==(const PixelEdge&) const = default;
};
std::vector<PixelEdge> outline(const PixelArea& area);
/// Whether the runs are as PixelArea says, and inside of an image of that size.
bool isValid(const PixelArea& area, int width, int height);

}  // namespace colortool
