// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/lines/FieldLineScanner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace modules {

using robotlink::ImageView;
using robotlink::Vector2;
using robotlink::YCbCr;

namespace {

/// The distance below the horizon at which scan lines begin, pixels: ground farther away is of no use.
constexpr int kBelowHorizon = 4;
/// The smallest gradient of Y that has a direction, for each pixel.
constexpr double kMinGradient = 12;

int lumaAt(const ImageView& image, int x, int y) {
  return image.row(y)[2 * x];
}

}  // namespace

FieldLineScanner::Surface FieldLineScanner::surfaceOf(YCbCr color) const {
  const int y = color.y, cb = color.cb - 128, cr = color.cr - 128;
  if (-64 * cr > greenness_ * y && 8 * cb < y) return Surface::kGreen;
  const int limit = whiteness_ * y;
  const bool gray = 64 * std::abs(cb) < limit && 64 * std::abs(cr) < limit;
  return gray ? Surface::kWhite : Surface::kOther;
}

double FieldLineScanner::direction(const ImageView& image, const CameraView& view, const Vector2& at) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const int x = static_cast<int>(at.x()), y = static_cast<int>(at.y());
  if (x < 1 || y < 1 || x + 1 >= image.width || y + 1 >= image.height) return kUnknown;
  const auto luma = [&](int dx, int dy) { return lumaAt(image, x + dx, y + dy); };
  // Sobel's operator.
  const int right = luma(1, -1) + 2 * luma(1, 0) + luma(1, 1) - luma(-1, -1) - 2 * luma(-1, 0) - luma(-1, 1);
  const int down = luma(-1, 1) + 2 * luma(0, 1) + luma(1, 1) - luma(-1, -1) - 2 * luma(0, -1) - luma(1, -1);
  const Vector2 gradient(right / 8.0, down / 8.0);
  if (gradient.norm() < kMinGradient) return kUnknown;
  const Vector2 along = Vector2(-gradient.y(), gradient.x()).normalized();
  const auto before = view.onPlane(at - along, 0), after = view.onPlane(at + along, 0);
  if (!before || !after) return kUnknown;
  const Vector2 onGround = *after - *before;
  return std::remainder(std::atan2(onGround.y(), onGround.x()), robotlink::kPi);
}

void FieldLineScanner::addEdge(const ImageView& image, const CameraView& view, Pixel from, Pixel to) {
  const int first = lumaAt(image, from.x, from.y), last = lumaAt(image, to.x, to.y);
  if (std::abs(last - first) < options_.contrast) return;
  // The edge is where Y crosses the mean of both sides.
  const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
  const Pixel step{(to.x - from.x) / steps, (to.y - from.y) / steps};
  const double mean = 0.5 * (first + last);
  double before = first, crossing = 0.5 * steps;
  for (int i = 1; i <= steps; ++i) {
    const double now = lumaAt(image, from.x + i * step.x, from.y + i * step.y);
    if ((before - mean) * (now - mean) <= 0 && now != before) {
      crossing = i - 1 + (mean - before) / (now - before);
      break;
    }
    before = now;
  }
  const Vector2 at(from.x + 0.5 + crossing * step.x, from.y + 0.5 + crossing * step.y);
  const auto onGround = view.onPlane(at, 0);
  if (!onGround) return;
  const double distance = onGround->norm();
  if (distance < options_.minimumDistance || distance > options_.maximumDistance) return;
  points_.push_back({at, *onGround, direction(image, view, at)});
}

void FieldLineScanner::scan(const ImageView& image, const CameraView& view, Pixel start, Pixel step,
                            int count) {
  Surface last = Surface::kOther;
  Pixel lastAt;
  int gap = 0;
  for (int i = 0; i < count; ++i) {
    const Pixel at{start.x + i * step.x, start.y + i * step.y};
    const Surface now = surfaceOf(robotlink::yuyvPixel(image, at.x, at.y));
    if (now == Surface::kOther) {
      ++gap;
      continue;
    }
    if (last != Surface::kOther && now != last && gap <= options_.maximumGap)
      addEdge(image, view, lastAt, at);
    last = now;
    lastAt = at;
    gap = 0;
  }
}

const std::vector<LinePoint>& FieldLineScanner::find(const ImageView& image, const CameraView& view) {
  points_.clear();
  if (image.empty() || image.format != robotlink::PixelFormat::kYuyv) return points_;
  greenness_ = static_cast<int>(64 * options_.greenness);
  whiteness_ = static_cast<int>(64 * options_.whiteness);
  const int columns = std::max(1, options_.columnSpacing), rows = std::max(1, options_.rowSpacing);
  const auto top = [&](int x) -> std::optional<int> {
    const auto horizon = view.horizonRow(x + 0.5);
    if (!horizon || std::abs(*horizon) > 10.0 * image.height) return std::nullopt;
    return std::clamp(static_cast<int>(*horizon) + kBelowHorizon, 0, image.height);
  };
  for (int x = columns / 2; x < image.width; x += columns)
    if (const auto first = top(x)) scan(image, view, {x, image.height - 1}, {0, -1}, image.height - *first);
  const auto left = top(0), right = top(image.width - 1);
  if (left && right) {
    for (int y = image.height - 1 - rows / 2; y >= std::max(*left, *right); y -= rows)
      scan(image, view, {0, y}, {1, 0}, image.width);
  }
  const auto limit = static_cast<std::size_t>(std::max(1, options_.maximumPoints));
  if (points_.size() > limit) {
    for (std::size_t i = 0; i < limit; ++i) points_[i] = points_[i * points_.size() / limit];
    points_.resize(limit);
  }
  return points_;
}

}  // namespace modules
