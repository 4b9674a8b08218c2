// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/CellGrid.h"

#include <gtest/gtest.h>

#include "colortool/table/ColorTable.h"

namespace colortool {
namespace {

/// A grid of one class, to be changed cell by cell.
struct Grid : CellGrid {
  Grid(int y, int first, int second, std::uint8_t all = 0) {
    sides = {y, first, second};
    classes.assign(count(sides), all);
  }
  std::uint8_t& at(int i, int j, int k) {
    return classes[static_cast<std::size_t>((i * sides[1] + j) * sides[2] + k)];
  }
};

int classOf(const RegriddedCells& cells, int y, int cb, int cr) {
  return cells.classes[static_cast<std::size_t>((y * 64 + cb) * 64 + cr)];
}

TEST(CellGrid, oneOfOurSizeStaysAsItIs) {
  Grid grid(64, 64, 64);
  grid.at(1, 2, 3) = 7;
  const RegriddedCells cells = regrid(grid);
  EXPECT_EQ(cells.classes, grid.classes);
  EXPECT_EQ(cells.mixedCells, 0U);
}

TEST(CellGrid, aSingleCellIsEveryColor) {
  const RegriddedCells cells = regrid(Grid(1, 1, 1, 5));
  EXPECT_EQ(cells.classes, std::vector<std::uint8_t>(ColorTable::kCellCount, 5));
}

TEST(CellGrid, coarseCellsAreRepeatedAndFineOnesReduced) {
  Grid grid(16, 128, 32);  // coarse in Y and Cr, fine in Cb
  for (int j : {10, 11}) grid.at(3, j, 6) = 4;
  const RegriddedCells cells = regrid(grid);
  for (int y = 12; y < 16; ++y) {
    for (int cr = 12; cr < 14; ++cr) EXPECT_EQ(classOf(cells, y, 5, cr), 4) << y << " " << cr;
  }
  EXPECT_EQ(std::ranges::count(cells.classes, 4), 8);
  EXPECT_EQ(cells.mixedCells, 0U);
}

TEST(CellGrid, theOrderOfTheChannelsIsKeptOrTurned) {
  Grid grid(64, 64, 64);
  grid.at(1, 2, 3) = 7;
  grid.crFirst = true;
  EXPECT_EQ(classOf(regrid(grid), 1, 3, 2), 7);
  EXPECT_EQ(classOf(regrid(grid), 1, 2, 3), 0);
}

TEST(CellGrid, mixedCellsTakeTheClassOfMostAndNoneLosesATie) {
  Grid grid(128, 64, 64);
  grid.at(0, 0, 0) = 3;                        // 3 and none
  grid.at(2, 0, 0) = 6, grid.at(3, 0, 0) = 2;  // 6 and 2
  Grid fine(128, 128, 64);
  for (int i = 0; i < 2; ++i) fine.at(i, 0, 0) = 9;
  fine.at(0, 1, 0) = 1;  // 9, 9, 1, none
  const RegriddedCells cells = regrid(grid), finer = regrid(fine);
  EXPECT_EQ(classOf(cells, 0, 0, 0), 3);
  EXPECT_EQ(classOf(cells, 1, 0, 0), 2) << "the lowest number";
  EXPECT_EQ(cells.mixedCells, 2U);
  EXPECT_EQ(classOf(finer, 0, 0, 0), 9);
  EXPECT_EQ(finer.mixedCells, 1U);
}

TEST(CellGrid, sidesArePowersOfTwoWithinLimits) {
  for (const int side : {1, 2, 16, 64, 128}) EXPECT_TRUE(CellGrid::fits(side)) << side;
  for (const int side : {0, -1, -64, 3, 63, 129, 256}) EXPECT_FALSE(CellGrid::fits(side)) << side;
}

}  // namespace
}  // namespace colortool
