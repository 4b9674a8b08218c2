// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/placement/ClearanceGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace simcore {
namespace {

using robotlink::Vector2;
using Cell = ClearanceGrid::Cell;

/// The marked cells as rows of '#' and '.', the lowest first.
std::vector<std::string> rows(const ClearanceGrid& grid) {
  std::vector<std::string> rows;
  for (int y = 0; y < grid.height(); ++y) {
    std::string& row = rows.emplace_back();
    for (int x = 0; x < grid.width(); ++x) row += grid.isMarked({x, y}) ? '#' : '.';
  }
  return rows;
}

TEST(ClearanceGrid, cellsCoverTheFloorAndBeyondItThereAreNone) {
  const ClearanceGrid grid({-1, 2}, {1, 3}, 0.25);
  EXPECT_EQ(grid.width(), 8);
  EXPECT_EQ(grid.height(), 4);
  EXPECT_EQ(grid.cellAt({-1, 2}), (Cell{0, 0}));
  EXPECT_EQ(grid.cellAt({0.99, 2.99}), (Cell{7, 3}));
  EXPECT_TRUE(grid.centerOf({0, 0}).isApprox(Vector2(-0.875, 2.125)));
  EXPECT_FALSE(grid.contains(grid.cellAt({-1.01, 2.5})));
  EXPECT_FALSE(grid.contains(grid.cellAt({1e30, 2.5})));
}

TEST(ClearanceGrid, aHugeFloorGetsLargerCells) {
  const ClearanceGrid wide({0, 0}, {10'000, 10'000}, 0.1), narrow({0, 0}, {1e7, 0.1}, 0.1);
  EXPECT_LE(static_cast<double>(wide.width()) * wide.height(), 4.01e6);
  EXPECT_LE(static_cast<double>(narrow.width()) * narrow.height(), 4.01e6);
}

TEST(ClearanceGrid, obstaclesMarkTheCellsThatTheyCover) {
  ClearanceGrid grid({0, 0}, {5, 4}, 1);
  grid.markRectangle({2, 1, 0}, {1.9, 0.9});
  grid.mark({4, 3});
  grid.mark({5, 3});  // outside
  EXPECT_EQ(rows(grid), (std::vector<std::string>{".##..", ".##..", ".....", "....#"}));
}

TEST(ClearanceGrid, aTurnedRectangleAndACircleAreMarkedWithoutGaps) {
  ClearanceGrid turned({0, 0}, {5, 5}, 1);
  turned.markRectangle({2.5, 2.5, robotlink::kPi / 2}, {5, 0.5});
  for (int y = 0; y < 5; ++y) EXPECT_TRUE(turned.isMarked({2, y})) << y;
  EXPECT_FALSE(turned.isMarked({0, 2}));
  ClearanceGrid round({0, 0}, {5, 5}, 1);
  round.markCircle({2.5, 2.5}, 1);
  EXPECT_EQ(rows(round), (std::vector<std::string>{".....", ".###.", ".###.", ".###.", "....."}));
}

TEST(ClearanceGrid, aRectangleFarLargerThanTheFloorMarksAllOfIt) {
  ClearanceGrid grid({0, 0}, {3, 2}, 1);
  grid.markRectangle({0, 0, 0.3}, {1e6, 1e6});
  EXPECT_EQ(rows(grid), (std::vector<std::string>{"###", "###"}));
}

TEST(ClearanceGrid, clearancesAreTheDistancesToTheNearestMark) {
  ClearanceGrid grid({0, 0}, {20, 13}, 1);
  std::minstd_rand random(1);
  std::vector<Cell> marks;
  for (int i = 0; i < 9; ++i) {
    marks.push_back({static_cast<int>(random() % 20), static_cast<int>(random() % 13)});
    grid.mark(marks.back());
  }
  grid.findClearances();
  for (int y = 0; y < 13; ++y) {
    for (int x = 0; x < 20; ++x) {
      double nearest = 1e9;
      for (const Cell& mark : marks) nearest = std::min(nearest, std::hypot(mark.x - x, mark.y - y));
      EXPECT_NEAR(grid.clearance({x, y}), nearest, 1e-4) << x << " " << y;
    }
  }
}

TEST(ClearanceGrid, withoutMarksEverythingIsFar) {
  ClearanceGrid grid({0, 0}, {2, 2}, 1);
  grid.findClearances();
  EXPECT_GT(grid.clearance({1, 1}), 1000);
}

}  // namespace
}  // namespace simcore
