// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/ColorTables.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robotcontrol/Perception.pb.h"

TEST(ColorTables, aFileOfARealRobotBecomesATableWithNames) {
  const std::filesystem::path file =
      ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour/bhuman2009/tables/default.c64";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the real table is not at " << file;
  const auto table = app::readColorTable(file);
  ASSERT_TRUE(table) << table.error().describe();
  ASSERT_EQ((*table)->class_names_size(), 8);
  EXPECT_EQ((*table)->class_names(0), "orange");
  ASSERT_EQ((*table)->cells().size(), 262144U);
  EXPECT_EQ(std::ranges::count((*table)->cells(), '\1'), 1051);
}

TEST(ColorTables, whatIsNoTableIsRefused) {
  EXPECT_EQ(app::readColorTable(ROBOTCONTROL_SOURCE_DIR "/README.md").error().id, "color-table.c64");
  EXPECT_FALSE(app::readColorTable("/no/such/table.c64"));
}
