// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/rendering/RayFan.h"

#include <algorithm>
#include <cmath>

namespace simcore {

RayFan::RayFan(double start, double end, int count)
    : start_(start), step_(count > 1 ? (end - start) / (count - 1) : 0) {
  for (int i = 0; i < std::max(1, count); ++i) {
    const double angle = start + step_ * i;
    directions_.emplace_back(std::cos(angle), std::sin(angle));
  }
}

}  // namespace simcore
