// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BandLandmarkFinder.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace modules {
namespace {

using colortool::Region;

/// Whether one region is on top of another as the bands of a beacon are.
bool sitsUpon(const Region& top, const Region& bottom) {
  const double width = std::max(top.width(), bottom.width());
  const double gap = bottom.top - top.bottom;
  const double slack = 1.5 + 0.35 * std::min(top.height(), bottom.height());
  return std::abs(gap) <= slack && top.centerY < bottom.centerY &&
         std::abs(top.centerX - bottom.centerX) <= 0.35 * width + 1 &&
         width <= 2.0 * std::min(top.width(), bottom.width()) + 1.5;
}

ImageBox boxOf(const Region& region) {
  return {static_cast<double>(region.left), static_cast<double>(region.top),
          static_cast<double>(region.right), static_cast<double>(region.bottom)};
}

/// The box of both bands. Pixels at the outer edge have mixed colors and belong to the box only in part.
ImageBox united(const Region& a, const Region& b) {
  constexpr double kMixed = 0.3;
  const int top = std::min(a.top, b.top), bottom = std::max(a.bottom, b.bottom);
  const bool cut = top <= 0;
  return {0.5 * (a.left + b.left), cut ? top : top + kMixed, 0.5 * (a.right + b.right), bottom - kMixed};
}

bool inside(const Region& region, const ImageBox& box) {
  return region.centerX > box.left - 1 && region.centerX < box.right + 1 && region.centerY > box.top - 1 &&
         region.centerY < box.bottom + 1;
}

}  // namespace

void BandLandmarkFinder::findBeacon(std::size_t index, std::span<const Region> regions,
                                    const CameraView& view, std::vector<LandmarkObservation>& found) const {
  const FieldLandmark& beacon = landmarks_[index];
  std::optional<LandmarkObservation> best;
  for (const Region& top : regions) {
    if (top.colorClass != beacon.topClass || top.area < options_.minimumBandArea) continue;
    for (const Region& bottom : regions) {
      if (bottom.colorClass != beacon.bottomClass || bottom.area < options_.minimumBandArea) continue;
      if (!sitsUpon(top, bottom)) continue;
      const auto seen = geometry_.locate(beacon, united(top, bottom), view);
      if (seen && (!best || seen->confidence > best->confidence)) best = seen;
    }
  }
  if (!best) return;
  best->landmark = index;
  found.push_back(*best);
}

void BandLandmarkFinder::findGoal(std::size_t index, std::span<const Region> regions, const CameraView& view,
                                  std::vector<LandmarkObservation>& found) const {
  const FieldLandmark& goal = landmarks_[index];
  for (const Region& region : regions) {
    if (region.colorClass != goal.topClass || region.area < options_.minimumGoalArea) continue;
    const bool ofBeacon =
        std::ranges::any_of(found, [&](const auto& seen) { return inside(region, seen.box); });
    if (ofBeacon) continue;
    auto seen = geometry_.locate(goal, boxOf(region), view);
    if (!seen) continue;
    seen->landmark = index;
    found.push_back(*seen);
    return;
  }
}

std::vector<LandmarkObservation> BandLandmarkFinder::find(std::span<const Region> regions,
                                                          const CameraView& view) const {
  std::vector<LandmarkObservation> found;
  for (std::size_t i = 0; i < landmarks_.size(); ++i)
    if (landmarks_[i].kind == FieldLandmark::Kind::kBeacon) findBeacon(i, regions, view, found);
  for (std::size_t i = 0; i < landmarks_.size(); ++i)
    if (landmarks_[i].kind == FieldLandmark::Kind::kGoal) findGoal(i, regions, view, found);
  return found;
}

}  // namespace modules
