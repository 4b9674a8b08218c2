// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/GrayGuard.h"

#include <gtest/gtest.h>

namespace colortool {
namespace {

constexpr std::uint8_t kGuardedClass = 1, kBlue = 2;

std::size_t guardedCell(int y, int cb, int cr) {
  return (static_cast<std::size_t>(y) * 64 + static_cast<std::size_t>(cb)) * 64 +
         static_cast<std::size_t>(cr);
}
const std::size_t kGray = guardedCell(40, 32, 32), kNearGray = guardedCell(40, 32, 35),
                  kColored = guardedCell(40, 20, 50);

class GrayGuardTest : public testing::Test {
 protected:
  GrayGuardTest() { guard_.setHeight(1000, 10); }
  /// The guard of orange in a cell after a number of strokes.
  std::int32_t votesAfter(int strokes, std::size_t cell) {
    guard_.clearStrengths();
    guard_.addStrength(kGuardedClass, std::int64_t{10} * strokes);
    guard_.update(kGuardedClass);
    return guard_.votes(kGuardedClass, cell);
  }

  GrayGuard guard_{3};
  CellBlocks changed_;
};

TEST_F(GrayGuardTest, isHighestAtGrayAndZeroAtStrongColors) {
  EXPECT_GT(votesAfter(1, kGray), 900);
  EXPECT_LT(votesAfter(1, kNearGray), votesAfter(1, kGray) / 2);
  EXPECT_GT(votesAfter(1, kNearGray), 0);
  EXPECT_EQ(votesAfter(1, kColored), 0);
}

TEST_F(GrayGuardTest, growsWithTheStrokesOfTheClassOnly) {
  EXPECT_NEAR(votesAfter(4, kGray), 4 * votesAfter(1, kGray), 4);
  guard_.update(kBlue);
  EXPECT_EQ(guard_.votes(kBlue, kGray), 0) << "blue has no strokes";
}

TEST_F(GrayGuardTest, doesNotGrowCloseToWhatPixelsClaim) {
  const std::int32_t one = votesAfter(1, kGray);
  guard_.setPixels(kGuardedClass, guardedCell(43, 33, 32), 3, changed_);
  EXPECT_EQ(votesAfter(5, kGray), one) << "three cells of Y and one of Cb beside it";
  EXPECT_GT(votesAfter(5, guardedCell(20, 32, 32)), 4 * one) << "far from it in Y";
  guard_.setPixels(kGuardedClass, guardedCell(43, 33, 32), 0, changed_);
  EXPECT_GT(votesAfter(5, kGray), 4 * one) << "no longer claimed";
}

TEST_F(GrayGuardTest, aSinglePixelClaimsNothing) {
  const std::int32_t before = votesAfter(5, kGray);
  guard_.setPixels(kGuardedClass, kGray, 2, changed_);
  EXPECT_EQ(votesAfter(5, kGray), before);
  EXPECT_EQ(changed_.row(kGray / 64), 0U);
}

TEST_F(GrayGuardTest, reportsWhereItChanged) {
  guard_.setPixels(kGuardedClass, kGray, 3, changed_);
  EXPECT_NE(changed_.row(kGray / 64), 0U);
  EXPECT_NE(changed_.row(guardedCell(44, 33, 0) / 64), 0U);
  EXPECT_EQ(changed_.row(guardedCell(45, 32, 0) / 64), 0U);
  EXPECT_EQ(changed_.row(guardedCell(40, 34, 0) / 64), 0U);
}

TEST_F(GrayGuardTest, aWholeRowHasTheSameVotesAsItsCells) {
  guard_.setPixels(kGuardedClass, kGray, 3, changed_);
  votesAfter(6, kGray);
  for (const int y : {36, 40, 50}) {
    const std::int32_t* row = guard_.votesOfRow(kGuardedClass, y, 32);
    for (int cr = 0; cr < 64; ++cr)
      EXPECT_EQ(row[cr], guard_.votes(kGuardedClass, guardedCell(y, 32, cr))) << cr;
  }
}

TEST_F(GrayGuardTest, isUpdatedOnlyIfSomethingChanged) {
  votesAfter(1, kGray);
  EXPECT_FALSE(guard_.update(kGuardedClass));
  guard_.addStrength(kGuardedClass, 10);
  EXPECT_TRUE(guard_.update(kGuardedClass));
}

TEST_F(GrayGuardTest, withoutAHeightThereIsNone) {
  guard_.setHeight(0, 10);
  EXPECT_EQ(votesAfter(5, kGray), 0);
}

}  // namespace
}  // namespace colortool
