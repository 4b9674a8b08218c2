// SPDX-License-Identifier: GPL-3.0-or-later
// What color tables' classes are called, and tables of others, by `robotctl color`.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "colortool/table/NamedColorTable.h"
#include "tests/app/robotctl/RobotctlColor.h"
#include "tests/game/Data.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

class RobotctlColorTables : public RobotctlColor {
 protected:
  RobotctlOutcome train(const std::string& more) const {
    return color("train --strokes strokes.csv --images images " + more);
  }
  json evaluated(const std::string& arguments) const {
    const auto scored = color("evaluate --json --images images " + arguments);
    EXPECT_EQ(scored.status, 0) << scored.errors;
    return json::parse(scored.out);
  }
};

TEST_F(RobotctlColorTables, classesGoWithTheTableByTheirNames) {
  ASSERT_EQ(train("--classes 2002 --out own.c64").status, 0);
  const json info = json::parse(color("info --json own.c64").out);
  EXPECT_EQ(info.at("classes").at(2), "skyblue");
  EXPECT_GT(info.at("cells").at("green"), 100);
  // Green is class 5 in the labels and in this table, too, but class 2 in the other.
  ASSERT_EQ(train("--classes orange,green --out few.c64").status, 0);
  for (const char* table : {"own.c64", "few.c64"}) {
    const json result = evaluated(std::string("--labels labels --table ") + table);
    EXPECT_EQ(result.at("recall"), (json{{"orange", 1.0}, {"green", 1.0}})) << table;
    EXPECT_EQ(result.at("confusion").at("background"), (json{{"none", 1.0}})) << table;
  }
  EXPECT_THAT(color("diff own.c64 few.c64").out, HasSubstr("0 of 262144 cells differ"));
  ASSERT_EQ(train("--out few.c64").status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "few.c64.classes"))
      << "the names of the known files are not written";
}

TEST_F(RobotctlColorTables, picturesOfNumbersAreLabelsAgain) {
  ASSERT_EQ(train("--classes green,orange --out t.c64").status, 0);
  ASSERT_EQ(color("segment --table t.c64 --images images --out numbers --numbers").status, 0);
  EXPECT_EQ(textOf(folder_ / "numbers/labels.classes"),
            "robotcontrol-color-classes 1\ngreen #008232\norange #ff6900\n");
  const json result = evaluated("--labels numbers --table t.c64");
  EXPECT_EQ(result.at("recall"), (json{{"green", 1.0}, {"orange", 1.0}}));
  // With other names, what is green is taken for orange.
  EXPECT_EQ(evaluated("--labels numbers --table t.c64 --label-classes orange,green").at("mean_recall"), 0.0);
  ASSERT_EQ(color("segment --table t.c64 --images images --out shown").status, 0);
  const std::string png = textOf(folder_ / "shown/000.png");
  const auto shown = logplayer::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
  ASSERT_TRUE(shown);
  EXPECT_EQ(shown->row(120)[3 * 50], 255) << "orange in the color of its class";
  EXPECT_EQ(shown->row(120)[3 * 50 + 1], 105);
}

TEST_F(RobotctlColorTables, namesThatAreBrokenAreReportedWithTheirLine) {
  ASSERT_EQ(train("--classes 2002 --out t.c64").status, 0);
  std::ofstream(folder_ / "t.c64.classes") << "robotcontrol-color-classes 1\norange\n";
  for (const char* command :
       {"info t.c64", "diff t.c64 t.c64", "segment --table t.c64 --images images --out x",
        "evaluate --table t.c64 --images images --labels labels"}) {
    const auto outcome = color(command);
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_THAT(outcome.errors, HasSubstr("t.c64.classes:2: a class is expected here")) << command;
  }
  EXPECT_EQ(color("info t.c64 --classes 2002").status, 0) << "other names can be given";
  const auto twice = color("info t.c64 --classes orange,orange");
  EXPECT_EQ(twice.status, 1);
  EXPECT_THAT(twice.errors, HasSubstr("the class 'orange' is named twice"));
}

TEST_F(RobotctlColorTables, cellsOfSeveralClassesAreKeptWhereThereIsRoom) {
  std::ofstream(folder_ / "strokes.csv") << "image,class,x,y,radius\n000,orange,50,100,3\n000,red,50,100,3\n";
  const auto kept = train("--several 0.9 --out t.c64");
  EXPECT_EQ(kept.status, 0) << kept.errors;
  const json cells = json::parse(color("info --json t.c64").out).at("cells");
  EXPECT_GT(cells.at("orange+red"), 100);
  EXPECT_FALSE(cells.contains("red"));
  const auto reduced = train("--several 0.9 --out t.c64 --classes a,b,c,d,e,f,orange,red");
  EXPECT_EQ(reduced.status, 3);
  EXPECT_THAT(reduced.errors, HasSubstr("t.c64: of " + cells.at("orange+red").dump() + " cells of several"));
  EXPECT_EQ(json::parse(color("info --json t.c64").out).at("cells").at("orange"), cells.at("orange+red"));
}

TEST_F(RobotctlColorTables, tablesOfOthersAreConverted) {
  std::string map = "TMAP\nYUV8\n2 1 1\n";
  map += '\0';
  map += '\2';
  std::ofstream(folder_ / "other.tm", std::ios::binary) << map;
  std::ofstream(folder_ / "other.col") << "2 (1 2 3) \"bright\"\n";
  const auto converted = color("convert other.tm t.c64");
  EXPECT_EQ(converted.status, 0) << converted.errors;
  EXPECT_THAT(converted.out, HasSubstr("t.c64: a table of Tekkotsu and CMPack, 2 x 1 x 1 cells"));
  EXPECT_THAT(converted.out, HasSubstr("bright                    131072 cells  50.00 %"));
  EXPECT_EQ(json::parse(color("info --json t.c64").out).at("cells").at("bright"), 131072);
  ASSERT_EQ(color("convert other.tm t.c64 --classes 2002").status, 0);
  EXPECT_EQ(json::parse(color("info --json t.c64").out).at("cells").at("yellow"), 131072);
}

TEST_F(RobotctlColorTables, whatAConvertedTableLacksIsReported) {
  std::string bytes(std::size_t{128} * 128 * 128, '\0');
  bytes[0] = 6;
  std::ofstream(folder_ / "fine.lut", std::ios::binary) << bytes;
  const auto converted = color("convert fine.lut t.c64");
  EXPECT_EQ(converted.status, 3);
  EXPECT_THAT(converted.errors, HasSubstr("t.c64: 1 cell had several classes in the finer table"));
  EXPECT_EQ(color("convert fine.lut t.c64 --format runswift").status, 3) << "0 is a class of theirs";
  EXPECT_EQ(json::parse(color("info --json t.c64").out).at("cells").at("orange"), 262144);
}

TEST_F(RobotctlColorTables, whatIsNoTableIsNotConverted) {
  const auto fails = [&](const std::string& arguments, const std::string& says) {
    const auto outcome = color("convert " + arguments);
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_THAT(outcome.errors, HasSubstr(says));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "t.c64"));
  };
  fails("strokes.csv t.c64", "strokes.csv: this is not a color table of a known format");
  fails("strokes.csv t.c64 --format upenn", "a table of the UPennalizers has 262144 bytes");
  fails("nothing.lut t.c64", "nothing.lut");
  std::ofstream(folder_ / "damaged.bz2") << "BZh9 and nothing more";
  fails("damaged.bz2 t.c64", "damaged.bz2: this bzip2 file is damaged");
  EXPECT_EQ(color("convert strokes.csv t.c64 --format magic").status, 2);
}

/// The parameter is the source of the tables.
class RobotctlColorFiles : public testing::TestWithParam<std::string> {};

TEST_P(RobotctlColorFiles, tablesOfOtherTeamsAreConverted) {
  const auto data = game::dataOf(GetParam()) / "colour";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "the real tables are not at " << data;
  const TestFolder folder;
  // Finer tables than ours have cells of several classes at the borders of theirs: status 3 says so.
  std::map<std::string, int> tables{{"nubots2013_default_RC2013.lut.bz2", 3},
                                    {"runswift2005_tightnnmc_128.cal.bz2", 3},
                                    {"upenn_Germany2016_10am_Top_64bitmask.raw.bz2", 0},
                                    {"ers7/tekkotsu_7general.tm", 0}};
  if (GetParam() == "made")
    tables = {{"nubots.lut", 3}, {"runswift.cal", 3}, {"upenn.raw", 0}, {"tekkotsu.tm", 0}};
  for (const auto& [name, status] : tables) {
    const auto converted = runRobotctl(folder.path(), "color convert '" + (data / name).string() + "' t.c64");
    EXPECT_EQ(converted.status, status) << name << converted.errors;
    EXPECT_EQ(runRobotctl(folder.path(), "color info t.c64").status, 0) << name;
    EXPECT_THAT(textOf(folder / "t.c64.classes"), HasSubstr("\norange #")) << name;
  }
  const auto same = data / "bhuman2009/tables/default.c64";
  ASSERT_EQ(runRobotctl(folder.path(), "color convert '" + same.string() + "' t.c64").status, 0);
  EXPECT_EQ(textOf(folder / "t.c64"), textOf(same));
  EXPECT_FALSE(std::filesystem::exists(folder / "t.c64.classes"));
}

INSTANTIATE_TEST_SUITE_P(Data, RobotctlColorFiles, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
