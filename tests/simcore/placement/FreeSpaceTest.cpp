// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/placement/FreeSpace.h"

#include <gtest/gtest.h>

using namespace simcore;
using robotlink::Vector2;
using Cell = ClearanceGrid::Cell;

namespace {

/// A grid of 10 cm around a text's picture: '#' is an obstacle, the first line the top.
ClearanceGrid gridOf(const std::vector<std::string>& picture) {
  const auto height = static_cast<int>(picture.size()), width = static_cast<int>(picture[0].size());
  ClearanceGrid grid({0, 0}, {0.1 * width, 0.1 * height}, 0.1);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (picture[static_cast<std::size_t>(height - 1 - y)][static_cast<std::size_t>(x)] == '#')
        grid.mark({x, y});
    }
  }
  grid.findClearances();
  return grid;
}

const std::vector<std::string> kTwoRooms = {
    "############", "#    #     #", "#    #     #", "#    #     #", "#    #     #", "############",
};

}  // namespace

TEST(ClearanceGrid, clearancesAreThoseOfBruteForce) {
  robotlink::Random random(5);
  ClearanceGrid grid({-1, 2}, {3, 5}, 0.1);
  std::vector<Cell> marked;
  for (int i = 0; i < 40; ++i) {
    const Cell cell{static_cast<int>(random.bits() % 40), static_cast<int>(random.bits() % 30)};
    grid.mark(cell);
    marked.push_back(cell);
  }
  grid.findClearances();
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x) {
      double nearest = 1e9;
      for (const Cell& other : marked)
        nearest = std::min(nearest, 0.1 * std::hypot(other.x - x, other.y - y));
      ASSERT_NEAR(grid.clearance({x, y}), nearest, 1e-5) << x << " " << y;
    }
  }
}

TEST(ClearanceGrid, withoutObstaclesEverythingIsFarFromThem) {
  ClearanceGrid grid({0, 0}, {1, 1}, 0.1);
  grid.findClearances();
  EXPECT_GT(grid.clearance({5, 5}), 1000);
}

TEST(ClearanceGrid, shapesCoverTheirCells) {
  ClearanceGrid grid({0, 0}, {4, 4}, 0.1);
  grid.markRectangle({2, 2, robotlink::kPi / 4}, {2, 0.01});
  for (const double at : {-0.7, -0.31, 0.0, 0.42, 0.69})
    EXPECT_TRUE(grid.isMarked(grid.cellAt({2 + at, 2 + at})));
  EXPECT_FALSE(grid.isMarked(grid.cellAt({2.3, 1.7})));
  grid.markCircle({1, 3}, 0.3);
  EXPECT_TRUE(grid.isMarked(grid.cellAt({1.2, 3.2})));
  EXPECT_FALSE(grid.isMarked(grid.cellAt({1.3, 3.3})));
}

TEST(ClearanceGrid, whatIsFarLargerThanTheGridIsMarkedInNoTime) {
  ClearanceGrid grid({0, 0}, {4, 4}, 0.1);
  grid.markRectangle({2, -9998, robotlink::kPi / 2}, {20'000, 20'000});
  EXPECT_TRUE(grid.isMarked(grid.cellAt({0.05, 1.8})));
  EXPECT_TRUE(grid.isMarked(grid.cellAt({3.9, 0.1})));
  EXPECT_FALSE(grid.isMarked(grid.cellAt({2, 2.2})));
  grid.markCircle({-9997, 2}, 10'000);
  EXPECT_TRUE(grid.isMarked(grid.cellAt({2.8, 2.8})));
  EXPECT_FALSE(grid.isMarked(grid.cellAt({3.3, 2.8})));
}

TEST(ClearanceGrid, aHugeFloorHasLargerCells) {
  const ClearanceGrid grid({-5000, -5000}, {5000, 5000}, 0.05);
  EXPECT_LE(static_cast<double>(grid.width()) * grid.height(), 4.1e6);
  EXPECT_GE(grid.cellSize() * grid.width(), 10'000);
  const ClearanceGrid road({0, 0}, {20'000, 0.01}, 0.05);
  EXPECT_LE(static_cast<double>(road.width()) * road.height(), 4.1e6);
}

TEST(FreeSpace, onlyWhatCanBeReachedCounts) {
  const ClearanceGrid grid = gridOf(kTwoRooms);
  const FreeSpace left(grid, 0.1, Vector2(0.25, 0.25));
  EXPECT_EQ(left.cells().size(), 16U);
  const FreeSpace largest(grid, 0.1, std::nullopt);
  EXPECT_EQ(largest.cells().size(), 20U);
}

TEST(FreeSpace, inTheOpenOnlyWhatIsSurroundedCounts) {
  robotlink::Random random(11);
  ClearanceGrid grid({0, 0}, {6, 5}, 0.1);
  for (int i = 0; i < 60; ++i)
    grid.mark({static_cast<int>(random.bits() % 60), static_cast<int>(random.bits() % 50)});
  grid.findClearances();
  const FreeSpace space(grid, 0.1, Vector2(3, 2.5));
  ASSERT_FALSE(space.empty());
  std::size_t expected = 0;
  const auto hasSomething = [&](Cell cell, int dx, int dy) {
    for (; grid.contains(cell); cell = {cell.x + dx, cell.y + dy})
      if (grid.isMarked(cell)) return true;
    return false;
  };
  const auto surrounded = [&](const Cell& cell) {
    int sides = 0;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) sides += (dx != 0 || dy != 0) && hasSomething(cell, dx, dy) ? 1 : 0;
    }
    return sides >= 7;
  };
  for (const Cell& cell : space.cells()) EXPECT_TRUE(surrounded(cell)) << cell.x << " " << cell.y;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = 0; x < grid.width(); ++x)
      expected += grid.clearance({x, y}) >= 0.1 && surrounded({x, y}) ? 1 : 0;
  }
  EXPECT_LE(space.cells().size(), expected);
  EXPECT_GT(space.cells().size(), expected / 2) << "some cannot be reached";
}

TEST(FreeSpace, aLargerRobotHasLessRoom) {
  const ClearanceGrid grid = gridOf(kTwoRooms);
  EXPECT_EQ(FreeSpace(grid, 0.2, std::nullopt).cells().size(), 6U);
  EXPECT_TRUE(FreeSpace(grid, 0.5, std::nullopt).empty());
}

TEST(FreeSpace, picksAreApartUntilThereIsNoRoom) {
  const ClearanceGrid grid = gridOf(kTwoRooms);
  const FreeSpace space(grid, 0.1, std::nullopt);
  robotlink::Random random(1);
  std::vector<Vector2> taken;
  while (const auto place = space.pick(taken, 0.25, random)) {
    for (const Vector2& other : taken) EXPECT_GE((*place - other).norm(), 0.25);
    taken.push_back(*place);
    ASSERT_LE(taken.size(), 20U);
  }
  EXPECT_GE(taken.size(), 3U);
}

TEST(FreeSpace, headingsFaceTheLongestWay) {
  const ClearanceGrid grid = gridOf({"####################", "#                  #", "#                  #",
                                     "#                  #", "####################"});
  const FreeSpace corridor(grid, 0.15, std::nullopt);
  robotlink::Random random(1);
  for (int i = 0; i < 10; ++i)
    EXPECT_NEAR(std::abs(std::cos(corridor.headingAt({0.25, 0.25}, random))), 1, 0.1);
}
