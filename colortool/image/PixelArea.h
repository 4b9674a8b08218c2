// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/image/ColorImage.h"

namespace colortool {

/// Consecutive pixels of one row of an image, from `begin` to `end`, half-open.
struct PixelRun {
  int y = 0;
  int begin = 0;
  int end = 0;
  bool operator==(const PixelRun&) const = default;
};

/// A set of pixels of an image: runs from top to bottom, then left to right, that neither overlap nor touch.
using PixelArea = std::vector<PixelRun>;

/// A point of an image in pixels; the center of the upper left pixel is (0, 0).
struct ImagePoint {
  double x = 0;
  double y = 0;
  bool operator==(const ImagePoint&) const = default;
};

// The areas that drawing tools cover in an image of `width` x `height`. Pure functions; what lies outside the
// image is left out.

/// All pixels whose center lies within `radius` pixels of the polyline through `points` (a disc for a single
/// point).
PixelArea brushArea(int width, int height, std::span<const ImagePoint> points, double radius);
/// Like brushArea(), but only pixels with a color similar to those along the line, for a brush that is wider
/// than the painted thing. `tolerance` is the maximum difference to the nearest of these pixels, in values of
/// a channel with Y weighted by 0.5.
PixelArea carefulBrushArea(const ColorImage& image, std::span<const ImagePoint> points, double radius,
                           double tolerance);
/// The rectangle between two opposite corners in any order, both inclusive.
PixelArea rectangleArea(int width, int height, ImagePoint corner, ImagePoint opposite);
/// All pixels whose center lies inside a closed polygon (even-odd rule).
PixelArea polygonArea(int width, int height, std::span<const ImagePoint> corners);

/// Options of the magic wand, wandArea().
struct WandOptions {
  /// Maximum difference of a pixel's color from the mean of the pixels selected so far, in values of a
  /// channel with Y weighted by 0.5.
  double tolerance = 16;
  /// A larger step between neighboring pixels is an edge, which the area does not cross.
  double edge = 24;
  /// The area stops growing at this size.
  int mostPixels = 200'000;
  bool operator==(const WandOptions&) const = default;
};
/// The connected area of similar color around a pixel: grows outwards from it and stops at edges.
PixelArea wandArea(const ColorImage& image, int x, int y, const WandOptions& options = {});

/// The connected area of equal class around a pixel of an image of classes (kMono8).
PixelArea spotArea(const robotlink::ImageView& classes, int x, int y);

/// The union of two areas.
PixelArea united(const PixelArea& a, const PixelArea& b);
/// The pixels of `a` that are not in `b`.
PixelArea without(const PixelArea& a, const PixelArea& b);
std::size_t pixelCount(const PixelArea& area);
/// Whether (x, y) is in the area.
bool contains(const PixelArea& area, int x, int y);
/// A segment of the outline of an area, from (x0, y0) to (x1, y1): sides of pixels that no other pixel of the
/// area shares, joined where they are collinear. Coordinates are corners of pixels; the upper left corner of
/// the upper left pixel is (0, 0).
struct PixelEdge {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool operator==(const PixelEdge&) const = default;
};
/// All segments of the outline, the vertical ones first.
std::vector<PixelEdge> outline(const PixelArea& area);
/// Whether the runs satisfy the rules of PixelArea and lie inside an image of this size.
bool isValid(const PixelArea& area, int width, int height);

}  // namespace colortool
