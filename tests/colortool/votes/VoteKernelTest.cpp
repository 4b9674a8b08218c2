// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/VoteKernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

using Votes = std::vector<std::int32_t>;

Votes votesOf(const VoteKernel& kernel, robotlink::YCbCr color, CellBlocks* touched = nullptr) {
  Votes votes(ColorTable::kCellCount, 0);
  CellBlocks blocks;
  kernel.add(votes, ColorTable::cellOf(color), 1, touched == nullptr ? blocks : *touched);
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

TEST(VoteKernelTest, aLongKernelReachesFartherInItsDirectionAndLessAcrossIt) {
  // Towards more Cb and Cr alike.
  VoteKernel slanted(
      {.chroma = 2, .brightness = 10, .along = 1.5, .across = 0.5, .direction = std::numbers::pi / 4});
  slanted.setPeak(1000);
  const Votes votes = votesOf(slanted, {100, 128, 128}), round = votesOf(kernel(false), {100, 128, 128});
  const std::size_t along = ColorTable::cellOf({100, 140, 140}), back = ColorTable::cellOf({100, 116, 116}),
                    across = ColorTable::cellOf({100, 140, 116});
  EXPECT_GT(votes[along], 2 * round[along]);
  EXPECT_EQ(votes[along], votes[back]);
  EXPECT_LT(10 * votes[across], round[across]);
}

TEST(VoteKernelTest, whatWasTouchedIsKnown) {
  for (const bool shaded : {false, true}) {
    for (const robotlink::YCbCr color :
         {robotlink::YCbCr{0, 0, 0}, {255, 255, 255}, {20, 200, 60}, {250, 90, 170}}) {
      CellBlocks touched;
      const Votes votes = votesOf(kernel(shaded), color, &touched);
      for (std::size_t cell = 0; cell < votes.size(); ++cell) {
        if (votes[cell] == 0) continue;
        const int cr = static_cast<int>(cell % 64);
        ASSERT_NE(touched.row(cell / 64) & CellBlocks::blocksOf(cr, cr), 0U) << cell;
      }
    }
  }
}

/// At the edges of the table, where kernels are cut off, and everywhere else.
TEST(VoteKernelTest, takingAVoteAwayLeavesNothing) {
  VoteKernel slanted({.chroma = 3, .brightness = 9, .along = 1.5, .across = 0.4, .direction = 2});
  slanted.setPeak(1000);
  for (const VoteKernel& each : {kernel(false), kernel(true), slanted}) {
    Votes votes(ColorTable::kCellCount, 0);
    CellBlocks touched;
    for (const int strength : {1, -1}) {
      for (std::size_t cell = 0; cell < ColorTable::kCellCount; cell += 331)
        each.add(votes, cell, static_cast<std::int16_t>(strength), touched);
    }
    EXPECT_TRUE(std::ranges::all_of(votes, [](std::int32_t vote) { return vote == 0; }));
  }
}

TEST(VoteKernelTest, noCellGetsMoreThanTheLargestSum) {
  for (const bool shaded : {false, true}) {
    VoteKernel made({3, 20, 2.3, shaded, 0.5});
    made.setPeak(100);
    Votes votes(ColorTable::kCellCount, 0);
    CellBlocks touched;
    // Every eighth cell along each chroma axis and Y, with what the others would have given.
    for (std::size_t y = 0; y < 64; y += 8) {
      for (std::size_t cb = 0; cb < 64; cb += 4) {
        for (std::size_t cr = 0; cr < 64; cr += 4)
          made.add(votes, y << 12U | cb << 6U | cr, 8 * 4 * 4, touched);
      }
    }
    EXPECT_LE(std::ranges::max(votes), 1.1 * 100 * made.largestSum()) << shaded;
  }
}

}  // namespace
}  // namespace colortool
