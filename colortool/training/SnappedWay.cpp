// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/SnappedWay.h"

#include <algorithm>
#include <cmath>

namespace colortool {
namespace {

/// The most pixels by which a mouse that follows a line is off; brushes are often much wider.
constexpr double kMaxReach = 6;
/// How much a pixel of the way counts in the mean: colors change slowly along a thing.
constexpr double kNewest = 0.1;
/// Pixels of the way that are farther apart have something else between them.
constexpr double kNeighbors = 1.5;

std::array<double, 3> weighted(const robotlink::YCbCr& color) {
  return {0.5 * color.y, static_cast<double>(color.cb), static_cast<double>(color.cr)};
}
int pixelOf(double coordinate) {
  return static_cast<int>(std::lround(std::clamp(coordinate, -1.0e6, 1.0e6)));
}
double distance(ImagePoint a, ImagePoint b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

SnappedWay::SnappedWay(const ColorImage& image, ImagePoint begin, double radius, double tolerance)
    : radius_(radius), tolerance_(tolerance), mouse_(begin), meant_(begin) {
  outside_ = !image.contains(pixelOf(begin.x), pixelOf(begin.y));
  if (!outside_) mean_ = weighted(image.at(pixelOf(begin.x), pixelOf(begin.y)));
}

bool SnappedWay::isLike(const ColorImage& image, int x, int y) const {
  const Color color = weighted(image.at(x, y));
  return std::hypot(color[0] - mean_[0], color[1] - mean_[1], color[2] - mean_[2]) <= tolerance_;
}

ImagePoint SnappedWay::snapped(const ColorImage& image, ImagePoint at) {
  const int x = pixelOf(at.x), y = pixelOf(at.y);
  const bool inside = image.contains(x, y);
  ImagePoint best = at;
  // The middle of its pixel, since a point between two pixels means both of them.
  if (inside && !outside_ && isLike(image, x, y)) best = {1.0 * x, 1.0 * y};
  if (inside && !outside_ && !isLike(image, x, y)) {
    const double reach = std::min(radius_, kMaxReach);
    double nearest = reach;
    const int far = static_cast<int>(std::floor(reach));
    for (int atY = y - far; atY <= y + far; ++atY) {
      for (int atX = x - far; atX <= x + far; ++atX) {
        const ImagePoint candidate{1.0 * atX, 1.0 * atY};
        const double off = distance(candidate, at);
        if (off >= nearest || !image.contains(atX, atY) || !isLike(image, atX, atY)) continue;
        nearest = off;
        best = candidate;
      }
    }
  }
  const int bestX = pixelOf(best.x), bestY = pixelOf(best.y);
  if (!image.contains(bestX, bestY)) return best;
  const Color color = weighted(image.at(bestX, bestY));
  // A new thing begins here, or the present one continues.
  const double share = outside_ || !isLike(image, bestX, bestY) ? 1 : kNewest;
  for (std::size_t i = 0; i < mean_.size(); ++i) mean_[i] += share * (color[i] - mean_[i]);
  outside_ = false;
  return best;
}

PixelArea SnappedWay::begin(const ColorImage& image) const {
  return carefulBrushArea(image, {&meant_, 1}, radius_, tolerance_);
}

PixelArea SnappedWay::moveTo(const ColorImage& image, ImagePoint to) {
  const double length = distance(mouse_, to);
  const int steps = static_cast<int>(std::ceil(std::min(length, 1.0e5)));
  PixelArea area;
  std::vector<ImagePoint> piece{meant_};
  const auto touchPiece = [&] { area = united(area, carefulBrushArea(image, piece, radius_, tolerance_)); };
  for (int i = 1; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const ImagePoint at{mouse_.x + share * (to.x - mouse_.x), mouse_.y + share * (to.y - mouse_.y)};
    meant_ = snapped(image, at);
    if (distance(meant_, piece.back()) > kNeighbors) {
      touchPiece();
      piece.clear();
    }
    piece.push_back(meant_);
  }
  touchPiece();
  mouse_ = to;
  return area;
}

}  // namespace colortool
