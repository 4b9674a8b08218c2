// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/votes/CellBlocks.h"

#include <gtest/gtest.h>

#include <utility>

namespace colortool {
namespace {

TEST(CellBlocksTest, cellsBelongToTheBlocksThatTheyAreIn) {
  EXPECT_EQ(CellBlocks::blocksOf(0, 0), 0b0001U);
  EXPECT_EQ(CellBlocks::blocksOf(15, 15), 0b0001U);
  EXPECT_EQ(CellBlocks::blocksOf(15, 16), 0b0011U);
  EXPECT_EQ(CellBlocks::blocksOf(16, 47), 0b0110U);
  EXPECT_EQ(CellBlocks::blocksOf(0, 63), 0b1111U);
  EXPECT_EQ(CellBlocks::blocksOf(63, 63), 0b1000U);
}

TEST(CellBlocksTest, aRowKeepsItsBlocksAndItsNeighborsTheirs) {
  CellBlocks blocks;
  blocks.includeBlocks(16, 0b1000);
  blocks.includeBlocks(16, 0b0001);
  EXPECT_EQ(blocks.row(15), 0U);
  EXPECT_EQ(blocks.row(16), 0b1001U);
  EXPECT_EQ(blocks.row(17), 0U);
  blocks.includeBlocks(CellBlocks::kRows - 1, 0b1111);
  EXPECT_EQ(blocks.row(CellBlocks::kRows - 1), 0b1111U);
  EXPECT_EQ(blocks.row(CellBlocks::kRows - 2), 0U);
}

TEST(CellBlocksTest, manyRowsAtOnceAreTheSameAsOneByOne) {
  // Ranges that begin and end within the 16 rows that share a word, and across several of these.
  const std::pair<std::size_t, std::size_t> ranges[] = {
      {0, 1}, {3, 13}, {15, 17}, {16, 32}, {5, 100}, {40, 40}, {0, CellBlocks::kRows}};
  for (const auto& [first, end] : ranges) {
    CellBlocks together, single;
    together.includeBlocks(first, end, 0b0101);
    for (std::size_t row = first; row < end; ++row) single.includeBlocks(row, 0b0101);
    for (std::size_t row = 0; row < CellBlocks::kRows; ++row)
      ASSERT_EQ(together.row(row), single.row(row)) << first << " to " << end << ", row " << row;
  }
}

TEST(CellBlocksTest, setsAreJoinedFilledAndCleared) {
  CellBlocks one, other;
  one.includeBlocks(3, 0b0001);
  other.includeBlocks(3, 0b0100);
  other.includeBlocks(99, 0b0010);
  one.include(other);
  EXPECT_EQ(one.row(3), 0b0101U);
  EXPECT_EQ(one.row(99), 0b0010U);
  EXPECT_EQ(other.row(3), 0b0100U);
  one.includeAll();
  EXPECT_EQ(one.row(0), 0b1111U);
  EXPECT_EQ(one.row(CellBlocks::kRows - 1), 0b1111U);
  one.clear();
  EXPECT_EQ(one.row(3), 0U);
}

}  // namespace
}  // namespace colortool
