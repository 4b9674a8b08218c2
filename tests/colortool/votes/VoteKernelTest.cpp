// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/VoteKernel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

using Votes = std::vector<std::int32_t>;

Votes votesOf(const VoteKernel& kernel, robotlink::YCbCr color, CellBox* changed = nullptr) {
  Votes votes(ColorTable::kCellCount, 0);
  CellBox box;
  kernel.add(votes, ColorTable::cellOf(color), 1, changed == nullptr ? box : *changed);
  return votes;
}

VoteKernel kernel(bool shaded) {
  VoteKernel made({2, 10, 3, shaded, 1});
  made.setPeak(1000);
  return made;
}

TEST(VoteKernelTest, aVoteIsLargestInTheSamplesOwnCell) {
  const Votes votes = votesOf(kernel(false), {100, 80, 180});
  EXPECT_EQ(votes[ColorTable::cellOf({100, 80, 180})], 1000);
  EXPECT_EQ(std::ranges::max(votes), 1000);
  EXPECT_GT(votes[ColorTable::cellOf({140, 80, 180})], votes[ColorTable::cellOf({100, 120, 180})])
      << "40 brighter is nearer than 40 of another hue";
}

TEST(VoteKernelTest, alongTheShadeADarkColorIsNearerToGray) {
  const Votes straight = votesOf(kernel(false), {160, 80, 190}),
              shaded = votesOf(kernel(true), {160, 80, 190});
  // Half the light: (160 + 26) / 2 - 26 = 67; chroma of -48 and 62 becomes -24 and 31.
  const std::size_t dark = ColorTable::cellOf({67, 104, 159});
  EXPECT_EQ(straight[dark], 0);
  EXPECT_GT(shaded[dark], 30);
  EXPECT_EQ(shaded[ColorTable::cellOf({160, 80, 190})], 1000);
}

TEST(VoteKernelTest, whatWasTouchedIsInTheBox) {
  for (const bool shaded : {false, true}) {
    for (const robotlink::YCbCr color :
         {robotlink::YCbCr{0, 0, 0}, {255, 255, 255}, {20, 200, 60}, {250, 90, 170}}) {
      CellBox box;
      const Votes votes = votesOf(kernel(shaded), color, &box);
      for (std::size_t cell = 0; cell < votes.size(); ++cell) {
        const int place[] = {static_cast<int>(cell >> 12U), static_cast<int>(cell >> 6U & 63U),
                             static_cast<int>(cell & 63U)};
        for (int axis = 0; axis < 3 && votes[cell] != 0; ++axis) {
          ASSERT_GE(place[axis], box.first[axis]) << cell << " " << axis;
          ASSERT_LE(place[axis], box.last[axis]) << cell << " " << axis;
        }
      }
    }
  }
}

TEST(VoteKernelTest, noCellGetsMoreThanTheLargestSum) {
  for (const bool shaded : {false, true}) {
    VoteKernel made({3, 20, 2.3, shaded, 0.5});
    made.setPeak(100);
    Votes votes(ColorTable::kCellCount, 0);
    CellBox box;
    // Every eighth cell along each chroma axis and Y, with what the others would have given.
    for (std::size_t y = 0; y < 64; y += 8) {
      for (std::size_t cb = 0; cb < 64; cb += 4) {
        for (std::size_t cr = 0; cr < 64; cr += 4) made.add(votes, y << 12U | cb << 6U | cr, 8 * 4 * 4, box);
      }
    }
    EXPECT_LE(std::ranges::max(votes), 1.1 * 100 * made.largestSum()) << shaded;
  }
}

}  // namespace
}  // namespace colortool
