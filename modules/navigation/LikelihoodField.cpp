// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/LikelihoodField.h"

#include <algorithm>
#include <cmath>

namespace modules {

LikelihoodField::LikelihoodField(const DistanceMap& distances)
    : lowX_(static_cast<float>(distances.frame().low.x())),
      lowY_(static_cast<float>(distances.frame().low.y())),
      perCell_(static_cast<float>(1 / distances.frame().cell)),
      width_(static_cast<float>(distances.frame().width)),
      height_(static_cast<float>(distances.frame().height)),
      columns_(static_cast<std::size_t>(distances.frame().width)),
      distances_(distances.frame().size()) {
  const GridFrame& frame = distances.frame();
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const double steps = std::min<double>(kFarthest, std::round(distances.at(column, row) / kStep));
      distances_[frame.index(column, row)] = static_cast<std::uint8_t>(steps);
    }
  }
  setDeviation(0.15, 0.1);
}

void LikelihoodField::setDeviation(double deviation, double randomShare) {
  const double share = std::clamp(randomShare, 1e-3, 1.0), sigma = std::max(deviation, 0.01);
  for (std::size_t i = 0; i < logarithms_.size(); ++i) {
    const double away = kStep * static_cast<double>(i) / sigma;
    logarithms_[i] = static_cast<float>(std::log((1 - share) * std::exp(-0.5 * away * away) + share));
  }
}

}  // namespace modules
