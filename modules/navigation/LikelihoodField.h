// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "modules/navigation/DistanceMap.h"
#include "modules/navigation/RangeBeam.h"

namespace modules {

/// How well a place of the map explains the end of a laser's ray, by how far it is from the nearest wall (the
/// likelihood field of Thrun, Burgard and Fox, Probabilistic Robotics, 6.4). One byte a cell, so that the
/// field of a large building stays in the processor's cache.
class LikelihoodField {
 public:
  explicit LikelihoodField(const DistanceMap& distances);

  /// `deviation`: m, of the end of a ray; `randomShare`: of rays that hit what the map does not know.
  void setDeviation(double deviation, double randomShare);
  /// The logarithm of the likelihood, 0 at best.
  float logLikelihood(float x, float y) const { return logarithms_[nearness(x, y)]; }
  /// m, 2.5 at most and beyond the map.
  double distance(float x, float y) const { return kStep * nearness(x, y); }

 private:
  static constexpr double kStep = 0.01;
  std::uint8_t nearness(float x, float y) const {
    const float column = (x - lowX_) * perCell_, row = (y - lowY_) * perCell_;
    // Also false where they are not finite.
    if (!(column >= 0 && row >= 0 && column < width_ && row < height_)) return kFarthest;
    return distances_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
  }
  static constexpr std::uint8_t kFarthest = 250;

  float lowX_, lowY_, perCell_, width_, height_;
  std::size_t columns_;
  std::vector<std::uint8_t> distances_;  // in steps
  std::array<float, kFarthest + 1> logarithms_{};
};

}  // namespace modules
