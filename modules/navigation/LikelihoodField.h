// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// The likelihood of the end of a laser ray on the map, by its distance from the nearest wall
/// (the likelihood field of Thrun, Burgard and Fox, Probabilistic Robotics, 6.4). One byte per cell, so that
/// the field of a large building stays in the processor's cache. Reading is thread-safe.
class LikelihoodField {
 public:
  explicit LikelihoodField(const DistanceMap& distances);

  /// `deviation` is that of the end of a ray, m; `randomShare` the fraction of rays that hit something
  /// unknown to the map.
  void setDeviation(double deviation, double randomShare);
  /// The logarithm of the likelihood at a place in the map, m; 0 is the best.
  float logLikelihood(float x, float y) const { return logarithms_[nearness(x, y)]; }
  /// The distance to the nearest wall, m; at most 2.5, which is also the value outside the map.

 private:
  /// The resolution of distances, m.
  static constexpr double kStep = 0.01;
  std::uint8_t nearness(float x, float y) const {
    const float column = (x - lowX_) * perCell_, row = (y - lowY_) * perCell_;
    // Also false for values that are not finite.
    if (!(column >= 0 && row >= 0 && column < width_ && row < height_)) return kFarthest;
    return distances_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
  }
  static constexpr std::uint8_t kFarthest = 250;

  // The grid, in single precision for speed.
  float lowX_, lowY_, perCell_, width_, height_;
  std::size_t columns_;
  /// The distance of each cell, in units of kStep.
  std::vector<std::uint8_t> distances_;
  /// Indexed by distance.
  std::array<float, kFarthest + 1> logarithms_{};
};

}  // namespace modules
