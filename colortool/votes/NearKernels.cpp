// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/NearKernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

/// Kernels are longest from the second of these distances from gray on, and round up to the first, in cells
/// of Cb and Cr.
constexpr double kRoundUpTo = 6, kLongestFrom = 11;
/// How many times longer and wider than the round kernel the longest one is: along saturation, across hue.
constexpr double kLongestAlong = 1.5, kLongestAcross = 0.5;
/// Number of directions in half a turn, and of degrees of saturation besides the round one.
constexpr int kDirections = 16, kDegrees = 3;

}  // namespace

NearKernels::NearKernels(const VoteKernel::Shape& gray)
    : gray_(gray), kernels_(1 + std::size_t{kDegrees} * kDirections) {}

double NearKernels::largestSum() const {
  return VoteKernel(gray_).largestSum();
}

void NearKernels::setPeak(double peak) {
  peak_ = peak;
  for (auto& kernel : kernels_) kernel.reset();
}

const VoteKernel& NearKernels::at(std::size_t cell) {
  // Gray is the common corner of four cells.
  const double blue = static_cast<double>(cell >> 6U & 63U) + 0.5 - ColorTable::kCells / 2.0,
               red = static_cast<double>(cell & 63U) + 0.5 - ColorTable::kCells / 2.0;
  const double share = (std::hypot(blue, red) - kRoundUpTo) / (kLongestFrom - kRoundUpTo);
  const int degree = static_cast<int>(std::lround(kDegrees * std::clamp(share, 0.0, 1.0)));
  const double turns = std::atan2(red, blue) / std::numbers::pi;
  const int direction = (static_cast<int>(std::lround(turns * kDirections)) + kDirections) % kDirections;
  auto& kernel =
      kernels_[degree == 0 ? 0 : static_cast<std::size_t>((degree - 1) * kDirections + direction + 1)];
  if (!kernel) {
    VoteKernel::Shape shape = gray_;
    const double longer = static_cast<double>(degree) / kDegrees;
    shape.along = 1 + (kLongestAlong - 1) * longer;
    shape.across = 1 + (kLongestAcross - 1) * longer;
    shape.direction = direction * std::numbers::pi / kDirections;
    kernel.emplace(shape);
    kernel->setPeak(peak_);
  }
  return *kernel;
}

}  // namespace colortool
