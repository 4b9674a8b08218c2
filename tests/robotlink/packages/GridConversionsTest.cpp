// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/GridConversions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foxglove/Grid.pb.h"

using namespace robotlink;

namespace {

/// Cells of 0.1 m whose first corner is at (1, 2): '#' is occupied, '.' is free, '?' unknown; lowest row
/// first.
foxglove::Grid gridOf(const std::vector<std::string>& rows) {
  foxglove::Grid grid;
  grid.set_column_count(static_cast<std::uint32_t>(rows.front().size()));
  grid.set_row_stride(grid.column_count());
  grid.set_cell_stride(1);
  grid.mutable_cell_size()->set_x(0.1);
  grid.mutable_cell_size()->set_y(0.1);
  grid.mutable_pose()->mutable_position()->set_x(1);
  grid.mutable_pose()->mutable_position()->set_y(2);
  grid.mutable_pose()->mutable_orientation()->set_w(1);
  auto& field = *grid.add_fields();
  field.set_name("occupancy");
  field.set_type(foxglove::PackedElementField::INT8);
  for (const std::string& row : rows) {
    for (const char c : row) grid.mutable_data()->push_back(c == '#' ? 90 : c == '.' ? 10 : char(-1));
  }
  return grid;
}

int runsOf(const foxglove::Grid& grid) {
  int runs = 0;
  forOccupiedRuns(grid, [&](const GridRun&) { return ++runs < 1000; });
  return runs;
}

}  // namespace

TEST(GridConversions, occupiedCellsBecomePointsOfAMap) {
  const auto map = groundMap(gridOf({"??..", ".##.", "...#"}));
  ASSERT_TRUE(map) << map.error().text;
  ASSERT_EQ(map->points.size(), 3U);
  EXPECT_TRUE(map->points[0].isApprox(Vector2(1.15, 2.15)));
  EXPECT_TRUE(map->points[1].isApprox(Vector2(1.25, 2.15)));
  EXPECT_TRUE(map->points[2].isApprox(Vector2(1.35, 2.25)));
  EXPECT_EQ(map->resolution, 0.1);
}

TEST(GridConversions, neighborsInARowAreOneRun) {
  EXPECT_EQ(runsOf(gridOf({"##.#", "####", "...."})), 3);
}

TEST(GridConversions, anEmptyMapCannotBeSaved) {
  const auto map = groundMap(gridOf({"..??"}));
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().id, "map.empty");
}

TEST(GridConversions, whatDoesNotFitTogetherHasNoRuns) {
  foxglove::Grid grid = gridOf({"####"});
  grid.set_column_count(5);
  EXPECT_EQ(runsOf(grid), 0);
  grid = gridOf({"####"});
  grid.set_cell_stride(0);
  EXPECT_EQ(runsOf(grid), 0);
  grid = gridOf({"####"});
  grid.set_row_stride(0);
  EXPECT_EQ(runsOf(grid), 0);
  grid = gridOf({"####"});
  grid.mutable_cell_size()->set_x(std::nan(""));
  EXPECT_EQ(runsOf(grid), 0);
  grid = gridOf({"####"});
  grid.mutable_fields(0)->set_offset(1);
  EXPECT_EQ(runsOf(grid), 0);
  grid = gridOf({"####"});
  grid.set_column_count(0xFFFFFFFF);
  grid.set_cell_stride(0xFFFFFFFF);
  EXPECT_EQ(runsOf(grid), 0);
}
