// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/CellSet.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/colortool/PlainCleanUp.h"

namespace colortool {
namespace {

constexpr std::size_t cellAt(int y, int cb, int cr) {
  return static_cast<std::size_t>(y * 4096 + cb * 64 + cr);
}

TEST(CellSet, aCellIsInItAfterItWasSet) {
  CellSet cells;
  EXPECT_TRUE(cells.empty());
  for (const std::size_t cell : {cellAt(0, 0, 0), cellAt(3, 63, 63), cellAt(63, 63, 63)}) {
    cells.set(cell);
    EXPECT_TRUE(cells.contains(cell));
  }
  EXPECT_EQ(cells.size(), 3U);
  EXPECT_FALSE(cells.contains(cellAt(3, 63, 62)));
  cells.set(cellAt(3, 63, 63), false);
  EXPECT_EQ(cells.size(), 2U);
}

TEST(CellSet, neighborsDoNotReachAroundTheCube) {
  CellSet seed, within;
  seed.set(cellAt(5, 7, 63));
  for (const std::size_t cell : {cellAt(5, 7, 63), cellAt(5, 8, 0), cellAt(4, 63, 63), cellAt(5, 7, 0)})
    within.set(cell);
  EXPECT_EQ(connectedCells(seed, within, CellNeighbors::k26), seed);
  EXPECT_EQ(facesOf(seed).size(), 5U);
}

TEST(CellSet, cornersConnectAmongTwentySixNeighborsOnly) {
  CellSet seed, within;
  seed.set(cellAt(5, 7, 9));
  within.set(cellAt(5, 7, 9));
  within.set(cellAt(6, 6, 10));
  EXPECT_EQ(connectedCells(seed, within, CellNeighbors::k26), within);
  EXPECT_EQ(connectedCells(seed, within, CellNeighbors::k6), seed);
}

TEST(CellSet, seedsOutsideAreNone) {
  CellSet seed, within;
  seed.set(cellAt(5, 7, 9));
  within.set(cellAt(5, 7, 10));
  EXPECT_TRUE(connectedCells(seed, within, CellNeighbors::k26).empty());
}

/// From almost nothing to almost all cells: where paths are long, and where they are short.
TEST(CellSet, whatIsConnectedIsAsFoundCellByCell) {
  std::mt19937 random(3);
  for (const unsigned percent : {5U, 12U, 25U, 32U, 50U, 80U, 99U}) {
    CellSet seeds, within;
    for (std::size_t cell = 0; cell < ColorTable::kCellCount; ++cell)
      within.set(cell, random() % 100 < percent);
    for (int i = 0; i < 20; ++i) seeds.set(random() % ColorTable::kCellCount);
    for (const CellNeighbors neighbors : {CellNeighbors::k6, CellNeighbors::k26}) {
      EXPECT_EQ(connectedCells(seeds, within, neighbors), plainConnectedCells(seeds, within, neighbors))
          << percent << " %";
    }
  }
}

/// One way without a branch through all of the cube's middle.
TEST(CellSet, aLongWindingPathIsFollowedToItsEnd) {
  CellSet path, seed;
  for (int y = 0; y < 64; y += 2) {
    for (int cb = 0; cb < 64; cb += 2) {
      for (int cr = 0; cr < 64; ++cr) path.set(cellAt(y, cb, cr));
      if (cb < 62) path.set(cellAt(y, cb + 1, cb % 4 == 0 ? 63 : 0));
    }
    if (y < 62) path.set(cellAt(y + 1, y % 4 == 0 ? 62 : 0, y % 4 == 0 ? 0 : 63));
  }
  seed.set(cellAt(0, 0, 0));
  const CellSet reached = connectedCells(seed, path, CellNeighbors::k6);
  EXPECT_EQ(reached, plainConnectedCells(seed, path, CellNeighbors::k6));
  EXPECT_GT(reached.size(), 4000U);
}

}  // namespace
}  // namespace colortool
