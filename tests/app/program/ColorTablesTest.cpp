// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/ColorTables.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "robotcontrol/Perception.pb.h"
#include "tests/game/Data.h"
#include "tests/game/Tables.h"

/// The parameter is the source of the tables.
class ColorTableFiles : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(folder())) GTEST_SKIP() << "the real tables are not at " << folder();
  }
  std::filesystem::path folder() const { return game::dataOf(GetParam()) / "colour"; }
};

TEST_P(ColorTableFiles, aFileOfBHumanBecomesATableWithNames) {
  const auto file = folder() / "bhuman2009/tables/default.c64";
  const auto table = app::readColorTable(file);
  ASSERT_TRUE(table) << table.error().describe();
  ASSERT_EQ((*table)->class_names_size(), 8);
  EXPECT_EQ((*table)->class_names(0), "orange");
  ASSERT_EQ((*table)->cells().size(), 262144U);
  const std::ptrdiff_t orange = GetParam() == "real" ? 1051 : std::ranges::count(game::table().cells, 1);
  EXPECT_EQ(std::ranges::count((*table)->cells(), '\1'), orange);
  EXPECT_EQ((*table)->source(), file.lexically_normal().string())
      << "whoever uses it can say where it is from";
}

TEST_P(ColorTableFiles, tablesOfOtherTeamsAreTakenAsTheyAre) {
  std::vector<std::string> names{"upenn_Germany2016_10am_Top_64bitmask.raw.bz2",
                                 "runswift2005_tightnnmc_128.cal.bz2", "nubots2013_default_RC2013.lut.bz2",
                                 "ers7/tekkotsu_7general.tm"};
  if (GetParam() == "made") names = {"upenn.raw", "runswift.cal", "nubots.lut", "tekkotsu.tm"};
  for (const std::string& name : names) {
    const auto table = app::readColorTable(folder() / name);
    ASSERT_TRUE(table) << name << ": " << table.error().describe();
    EXPECT_GT((*table)->class_names_size(), 3) << name;
    ASSERT_EQ((*table)->cells().size(), 262144U) << name;
    EXPECT_LT(std::ranges::count((*table)->cells(), '\0'), 262144) << name << " has colors";
  }
}

INSTANTIATE_TEST_SUITE_P(Data, ColorTableFiles, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

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
