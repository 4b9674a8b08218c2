// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/NearKernels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace colortool {
namespace {

NearKernels kernels(double peak = 1000) {
  NearKernels made({2, 6, 3, false, 1});
  made.setPeak(peak);
  return made;
}

/// The vote of a sample of a color for another one.
std::int32_t vote(NearKernels& kernels, robotlink::YCbCr sample, robotlink::YCbCr other) {
  std::vector<std::int32_t> votes(ColorTable::kCellCount, 0);
  CellBlocks touched;
  const std::size_t cell = ColorTable::cellOf(sample);
  kernels.at(cell).add(votes, cell, 1, touched);
  return votes[ColorTable::cellOf(other)];
}

TEST(NearKernels, votesOfGrayReachEquallyFar) {
  NearKernels made = kernels();
  const robotlink::YCbCr gray{100, 128, 128};
  EXPECT_EQ(vote(made, gray, {100, 140, 128}), vote(made, gray, {100, 128, 140}));
  EXPECT_EQ(vote(made, gray, gray), 1000);
}

/// A hue of all directions: half as saturated is nearer than as far beside it.
TEST(NearKernels, votesOfSaturatedColorsReachFartherAlongTheirSaturation) {
  NearKernels made = kernels();
  for (const auto& [cb, cr] :
       {std::pair(64, 64), {64, -64}, {-64, 64}, {-64, -64}, {80, 0}, {0, 80}, {-80, 0}, {0, -80}}) {
    const auto at = [cb = cb, cr = cr](double along, double across) {
      return robotlink::YCbCr{100, static_cast<std::uint8_t>(128 + along * cb - across * cr),
                              static_cast<std::uint8_t>(128 + along * cr + across * cb)};
    };
    const std::int32_t paler = vote(made, at(1, 0), at(0.82, 0)),
                       beside =
                           std::max(vote(made, at(1, 0), at(1, 0.18)), vote(made, at(1, 0), at(1, -0.18)));
    EXPECT_GT(paler, 300) << cb << " " << cr;
    EXPECT_GT(paler, 5 * beside) << cb << " " << cr;
    EXPECT_EQ(vote(made, at(1, 0), at(1, 0)), 1000);
  }
}

TEST(NearKernels, anotherPeakAppliesToAllKernels) {
  NearKernels made = kernels();
  const robotlink::YCbCr orange{100, 80, 190};
  EXPECT_EQ(vote(made, orange, orange), 1000);
  made.setPeak(500);
  EXPECT_EQ(vote(made, orange, orange), 500);
}

}  // namespace
}  // namespace colortool
