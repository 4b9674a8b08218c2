// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ColorTables.h"

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
  EXPECT_EQ((*table)->source(), file.lexically_normal().string())
      << "whoever uses it can say where it is from";
}

TEST(ColorTables, tablesOfOtherTeamsAreTakenAsTheyAre) {
  const std::filesystem::path folder = ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the real tables are not at " << folder;
  for (const char* name :
       {"upenn_Germany2016_10am_Top_64bitmask.raw.bz2", "runswift2005_tightnnmc_128.cal.bz2",
        "nubots2013_default_RC2013.lut.bz2", "ers7/tekkotsu_7general.tm"}) {
    const auto table = app::readColorTable(folder / name);
    ASSERT_TRUE(table) << name << ": " << table.error().describe();
    EXPECT_GT((*table)->class_names_size(), 3) << name;
    ASSERT_EQ((*table)->cells().size(), 262144U) << name;
    EXPECT_LT(std::ranges::count((*table)->cells(), '\0'), 262144) << name << " has colors";
  }
}

TEST(ColorTables, oneOfALogSaysSoAndWhereItWasFromThen) {
  robotcontrol::ColorTable logged;
  logged.set_cells("1");
  EXPECT_EQ(app::colorTableOfLog(logged).source(), "of the log");
  EXPECT_EQ(app::colorTableOfLog(app::colorTableOfLog(logged)).source(), "of the log");
  logged.set_source("/home/me/game.c64");
  const auto table = app::colorTableOfLog(logged);
  EXPECT_EQ(table.source(), "of the log: /home/me/game.c64");
  EXPECT_EQ(app::colorTableOfLog(table).source(), table.source());
  EXPECT_EQ(table.cells(), logged.cells());
}

TEST(ColorTables, whatIsNoTableIsRefusedWithTheNameOfItsFile) {
  for (const std::string file : {ROBOTCONTROL_SOURCE_DIR "/README.md", "/no/such/table.c64"}) {
    const auto table = app::readColorTable(file);
    ASSERT_FALSE(table);
    EXPECT_NE(table.error().describe().find(file), std::string::npos) << table.error().describe();
  }
}
