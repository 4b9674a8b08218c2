// SPDX-License-Identifier: GPL-3.0-or-later
// `robotctl color` as its users call it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "colortool/table/ColorTableFile.h"
#include "tests/app/robotctl/RobotctlColor.h"
#include "tests/game/Data.h"
#include "tests/game/View.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST_F(RobotctlColor, threeStrokesMakeATableThatSortsAllOfTheImage) {
  const auto trained = train();
  ASSERT_EQ(trained.status, 0) << trained.errors;
  const auto scored = color("evaluate --table t.c64 --images images --labels labels --json");
  ASSERT_EQ(scored.status, 0) << scored.errors;
  const json result = json::parse(scored.out);
  EXPECT_EQ(result.at("recall"), (json{{"orange", 1.0}, {"green", 1.0}}));
  EXPECT_EQ(result.at("mean_recall"), 1.0);
  EXPECT_EQ(result.at("false_color"), 0.0);
  EXPECT_EQ(result.at("confusion").at("background"), (json{{"none", 1.0}}));
  EXPECT_THAT(color("evaluate --table t.c64 --images images --labels labels").out,
              HasSubstr("mean recall  100.00 %"));
}

TEST_F(RobotctlColor, allMethodsSortTheImage) {
  for (const std::string method : {"kernel", "gauss", "svm"}) {
    const std::string table = method + ".c64";
    const auto trained =
        color("train --strokes strokes.csv --images images --out " + table + " --method " + method);
    ASSERT_EQ(trained.status, 0) << trained.errors;
    const json result =
        json::parse(color("evaluate --json --images images --labels labels --table " + table).out);
    EXPECT_EQ(result.at("mean_recall"), 1.0) << method;
    EXPECT_EQ(result.at("false_color"), 0.0) << method;
    const json cells = json::parse(color("info --json " + table).out).at("cells");
    EXPECT_GT(cells.at("none"), 200'000) << method << " does not take everything for a color";
  }
  EXPECT_EQ(color("train --strokes strokes.csv --images images --out x.c64 --method magic").status, 2);
}

TEST_F(RobotctlColor, falseColorIsTheShareOfBackgroundThatIsTakenForAColor) {
  ASSERT_EQ(train().status, 0);
  auto table = colortool::ColorTableFile::load(folder_ / "t.c64").value();
  for (std::uint8_t& cell : table.cells) {
    if (cell == 0) cell = 7;
  }
  ASSERT_TRUE(table.save(folder_ / "red.c64"));
  const json result =
      json::parse(color("evaluate --table red.c64 --images images --labels labels --json").out);
  EXPECT_EQ(result.at("false_color"), 1.0);
  EXPECT_EQ(result.at("confusion").at("background"), (json{{"red", 1.0}}));
}

TEST_F(RobotctlColor, imagesAreShownInTheColorsOrNumbersOfTheirClasses) {
  ASSERT_EQ(train().status, 0);
  ASSERT_EQ(color("segment --table t.c64 --images images --out shown").status, 0);
  ASSERT_EQ(color("segment --table t.c64 --images images --out numbers --numbers").status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "shown/007.png"));
  const std::string png = textOf(folder_ / "numbers/000.png");
  const auto image = logplayer::decodePng({reinterpret_cast<const std::uint8_t*>(png.data()), png.size()});
  ASSERT_TRUE(image);
  for (std::size_t bar = 0; bar < 3; ++bar) EXPECT_EQ(image->row(120)[50 + 105 * bar], kLabels[bar]);
}

TEST_F(RobotctlColor, tablesAreDescribedAndCompared) {
  ASSERT_EQ(train().status, 0);
  const json info = json::parse(color("info --json t.c64").out);
  EXPECT_GT(info.at("cells").at("orange"), 100);
  EXPECT_THAT(color("diff t.c64 t.c64").out, HasSubstr("0 of 262144 cells differ"));
  ASSERT_EQ(color("train --strokes strokes.csv --images images --out wide.c64 --radius 12").status, 0);
  const json differences = json::parse(color("diff --json t.c64 wide.c64").out);
  std::uint64_t sum = 0;
  for (const auto& change : differences.at("changes")) sum += change.at("cells").get<std::uint64_t>();
  EXPECT_GT(sum, 100U);
  EXPECT_EQ(differences.at("changed"), sum);
  const json& orange = differences.at("classes").at("orange");
  EXPECT_GT(orange.at("gained"), 0);
  EXPECT_EQ(orange.at("before"), info.at("cells").at("orange"));
  EXPECT_EQ(orange.at("before").get<int>() + orange.at("gained").get<int>() - orange.at("lost").get<int>(),
            orange.at("after").get<int>());
}

TEST_F(RobotctlColor, whatIsWrongIsSaidWithItsPlace) {
  EXPECT_EQ(color("").status, 2);
  EXPECT_EQ(color("train --images images --out t.c64").status, 2);
  EXPECT_EQ(color("train --strokes strokes.csv --images images --out t.c64 --radius 100").status, 2);
  const auto fails = [&](const std::string& arguments, const std::string& says) {
    const auto outcome = color(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments;
    EXPECT_THAT(outcome.errors, HasSubstr(says));
  };
  std::ofstream(folder_ / "bad.csv") << "image,class,x,y,radius\n000.yuyv,orange,50,here,3\n";
  fails("train --strokes bad.csv --images images --out x.c64", "bad.csv:2:20: 'here' is not a number");
  std::ofstream(folder_ / "bad.csv") << "image,class,x,y,radius\n000.yuyv,mauve,50,1,3\n";
  fails("train --strokes bad.csv --images images --out x.c64",
        "there is no class 'mauve'; the classes are background, orange");
  std::ofstream(folder_ / "bad.csv") << "image,class,x,y,radius\n001.yuyv,orange,50,1,3\n";
  fails("train --strokes bad.csv --images images --out x.c64", "there is no image 001.yuyv");
  fails("train --strokes strokes.csv --images labels/none --out x.c64", "labels/none");
  fails("evaluate --table strokes.csv --images images --labels labels", "this is not a .c64 color table");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "x.c64"));
  ASSERT_EQ(train().status, 0);
  fails("evaluate --table t.c64 --images images --labels images", "no image has labels here");
  writeBytes(folder_ / "images/000.yuyv", {1, 2, 3});
  fails("evaluate --table t.c64 --images images --labels labels",
        "a .yuyv image has 307200 bytes, this has 3");
  std::ofstream(folder_ / "bad.csv")
      << "image,class,x,y,radius\n007.yuyv,orange,-50,1,3\n007.yuyv,orange,50,1,3\n";
  const auto outside = color("train --strokes bad.csv --images images --out x.c64");
  EXPECT_EQ(outside.status, 3);
  EXPECT_THAT(outside.errors, HasSubstr("one stroke is outside"));
}

/// Strokes that somebody made in the real images, or in the made ones.
std::string strokesOf(const std::string& source) {
  std::string text = "image,class,x,y,radius\n";
  if (source == "real") {
    return text +
           "000,background,60,46,3\n032,background,131,46,3\n"
           "066,orange,114,114,3\n000,blue,202,63,3\n066,white,5,136,3\n032,green,284,97,3\n"
           "032,red,50,131,3\n";
  }
  const auto stroke = [&](const char* image, const char* name, std::uint8_t label) {
    for (const auto& place : game::placesInside(game::View::at(std::stoi(image)).labels, label, 3, 1)) {
      text += std::string(image) + ',' + name + ',' + std::to_string(place.x) + ',' +
              std::to_string(place.y) + ",3\n";
    }
  };
  stroke("000", "background", 0);
  stroke("005", "background", 0);
  stroke("005", "orange", game::View::kOrange);
  stroke("000", "blue", game::View::kBlue);
  stroke("011", "white", game::View::kWhite);
  stroke("000", "green", game::View::kGreen);
  return text;
}

/// The parameter is the source of the images.
class RobotctlColorImages : public testing::TestWithParam<std::string> {};

TEST_P(RobotctlColorImages, fewStrokesMakeAGoodTable) {
  const auto data = game::dataOf(GetParam()) / "colour/bhuman2009";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "the real images are not in " << data;
  const TestFolder folder;
  std::ofstream(folder / "strokes.csv") << strokesOf(GetParam());
  const auto quoted = [&data](const char* name) { return "'" + (data / name).string() + "'"; };
  const auto trained =
      runRobotctl(folder.path(), "color train --strokes strokes.csv --out t.c64 --images " + quoted("yuyv"));
  ASSERT_EQ(trained.status, 0) << trained.errors;
  const auto evaluate = [&](const std::string& table) {
    const auto scored = runRobotctl(folder.path(), "color evaluate --json --table " + table + " --images " +
                                                       quoted("yuyv") + " --labels " + quoted("labels"));
    EXPECT_EQ(scored.status, 0) << scored.errors;
    return json::parse(scored.out);
  };
  const json ours = evaluate("t.c64"), theirs = evaluate(quoted("tables/default.c64"));
  for (const char* name : {"orange", "green", "white"}) EXPECT_GT(ours.at("recall").at(name), 0.93) << name;
  if (GetParam() == "real") {
    EXPECT_GT(ours.at("recall").at("blue"), theirs.at("recall").at("blue"));
  } else {
    EXPECT_EQ(theirs.at("mean_recall"), 1.0) << "it knows the colors";
    EXPECT_GT(ours.at("recall").at("blue"), 0.93);
  }
  EXPECT_LT(ours.at("false_color"), 0.02);
}

TEST(RobotctlColorLabels, aTableIsMadeFromLabeledImages) {
  const auto data = game::dataOf("made") / "colour/bhuman2009";
  const TestFolder folder;
  const auto both =
      " --images '" + (data / "yuyv").string() + "' --labels '" + (data / "labels").string() + "'";
  const auto trained = runRobotctl(folder.path(), "color train --out t.c64" + both);
  ASSERT_EQ(trained.status, 0) << trained.errors;
  const auto scored = runRobotctl(folder.path(), "color evaluate --json --table t.c64" + both);
  ASSERT_EQ(scored.status, 0) << scored.errors;
  const json figures = json::parse(scored.out);
  for (const char* name : {"orange", "blue", "green", "white"})
    EXPECT_GT(figures.at("recall").at(name), 0.95) << name;
  EXPECT_LT(figures.at("false_color"), 0.02);
  const auto without = runRobotctl(
      folder.path(), "color train --out n.c64 --labels . --images '" + (data / "yuyv").string() + "'");
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.errors, HasSubstr("no image has labels here"));
}

INSTANTIATE_TEST_SUITE_P(Data, RobotctlColorImages, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });

}  // namespace
