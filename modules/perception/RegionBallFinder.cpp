// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/RegionBallFinder.h"

#include <algorithm>
#include <cmath>

namespace modules {
namespace {

using colortool::Region;
using robotlink::Vector2;

/// The radius of a circle of which a segment with this chord and height is visible.
double radiusOfSegment(double chord, double height) {
  return height >= 0.5 * chord ? 0.5 * chord : (0.25 * chord * chord + height * height) / (2 * height);
}

struct Cut {
  bool left, top, right, bottom;
  int count() const { return left + top + right + bottom; }
};

/// The disc of a region with one side beyond the border of the image.
BallDisc cutDisc(const Region& region, const Cut& cut) {
  const bool sideways = cut.left || cut.right;
  const double chord = sideways ? region.height() : region.width();
  const double seen = sideways ? region.width() : region.height();
  const double radius = std::max(radiusOfSegment(chord, seen), 0.5 * seen);
  Vector2 center(0.5 * (region.left + region.right), 0.5 * (region.top + region.bottom));
  if (cut.left) center.x() = region.right - radius;
  if (cut.right) center.x() = region.left + radius;
  if (cut.top) center.y() = region.bottom - radius;
  if (cut.bottom) center.y() = region.top + radius;
  return {center, radius, seen >= radius ? 1.0 : 0.35 * radius + 1};
}

/// A disc cut by two or more borders; only a bound of its size is known.
BallDisc cornerDisc(const Region& region, const Cut& cut) {
  const double radius = 0.6 * std::max(region.width(), region.height());
  Vector2 center(0.5 * (region.left + region.right), 0.5 * (region.top + region.bottom));
  if (cut.left != cut.right) center.x() = cut.left ? region.right - radius : region.left + radius;
  if (cut.top != cut.bottom) center.y() = cut.top ? region.bottom - radius : region.top + radius;
  return {center, radius, 0.5 * radius + 1};
}

}  // namespace

BallDisc RegionBallFinder::discOf(const Region& region, const CameraView& view) const {
  const Cut cut{region.left <= 0, region.top <= 0, region.right >= view.width, region.bottom >= view.height};
  if (cut.count() == 1) return cutDisc(region, cut);
  if (cut.count() > 1) return cornerDisc(region, cut);
  const double larger = std::max(region.width(), region.height());
  const double smaller = std::min(region.width(), region.height());
  // Noise alone may remove a row of a small region.
  if (larger > options_.maximumStretch * smaller + 1.5) return {};
  const double radius = 0.5 * larger;
  // Shadow hides the lower side of a ball, never the upper one.
  const double y =
      region.height() < region.width() ? region.top + radius : 0.5 * (region.top + region.bottom);
  return {Vector2(0.5 * (region.left + region.right), y), radius, 0.5};
}

BallObservation RegionBallFinder::find(std::span<const Region> regions, const CameraView& view) const {
  BallObservation best;
  double bestScore = 0;
  for (const Region& region : regions) {
    if (region.area < options_.minimumArea) continue;
    const double fill =
        static_cast<double>(region.area) / (robotlink::kPi / 4 * region.width() * region.height());
    const BallDisc disc = discOf(region, view);
    if (disc.radius <= 0 || fill < options_.minimumFill) continue;
    auto ball = geometry_.locate(disc, view);
    if (!ball) continue;
    ball->confidence *= std::min(1.0, fill) * std::min(1.0, 0.4 + region.area / 40.0);
    const double score = ball->confidence * std::sqrt(static_cast<double>(region.area));
    if (score > bestScore) {
      bestScore = score;
      best = *ball;
    }
  }
  return best;
}

}  // namespace modules
