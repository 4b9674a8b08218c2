// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/YamlReader.h"

#include <gmock/gmock.h>

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

YamlReader reader(std::string_view text) {
  auto result = YamlReader::parse(text, "robot.yaml");
  EXPECT_TRUE(result) << result.error().describe();
  return std::move(*result);
}

std::string errorsOf(YamlReader& yaml) {
  const auto result = yaml.finish();
  return result ? "" : describe(result.error());
}

TEST(YamlReader, scalarsListsAndMapsAreRead) {
  YamlReader yaml =
      reader("name: ers210\nmass: 1.63\nlegs: 4\nred: true\njoints: [a, b]\npose: {x: -2, y: +1e-3}\n");
  const YamlNode root = yaml.root();
  EXPECT_EQ(root.required<std::string>("name"), "ers210");
  EXPECT_EQ(root.required<double>("mass"), 1.63);
  EXPECT_EQ(root.required<int>("legs"), 4);
  EXPECT_TRUE(root.required<bool>("red"));
  EXPECT_THAT(root.required<std::vector<std::string>>("joints"), ElementsAre("a", "b"));
  EXPECT_EQ(root.child("pose").required<double>("x"), -2);
  EXPECT_EQ(root.child("pose").required<double>("y"), 1e-3);
  EXPECT_EQ(errorsOf(yaml), "");
}

TEST(YamlReader, anOptionalKeyMayBeMissingButNotWrong) {
  YamlReader yaml = reader("period: soon\n");
  EXPECT_EQ(yaml.root().optional<int>("priority", 7), 7);
  yaml.root().optional<double>("period", 1.0);
  EXPECT_THAT(errorsOf(yaml), HasSubstr("robot.yaml:1:9: here should be a finite number, not 'soon'"));
}

TEST(YamlReader, aMissingKeyIsReportedOnceWithItsPlace) {
  YamlReader yaml = reader("body:\n  head:\n    mass: 1\n");
  const YamlNode head = yaml.root().child("body").child("head");
  head.required<double>("mass");
  EXPECT_EQ(head.child("camera").child("model").required<double>("width"), 0);
  EXPECT_EQ(errorsOf(yaml), "robot.yaml:3:5: the key 'camera' is missing here");
}

TEST(YamlReader, aKeyThatNobodyAskedForIsUnknown) {
  YamlReader yaml = reader("name: a\nparts:\n  - {size: 1}\n  - {size: 2, sise: 3}\n");
  yaml.root().required<std::string>("name");
  for (const YamlNode& part : yaml.root().child("parts").items()) part.required<int>("size");
  EXPECT_EQ(errorsOf(yaml), "robot.yaml:4:15: unknown key 'sise'");
}

TEST(YamlReader, aKeyThatStandsTwiceIsRefused) {
  YamlReader yaml = reader("a: 1\na: 2\n");
  EXPECT_EQ(yaml.root().required<int>("a"), 1);
  EXPECT_EQ(errorsOf(yaml), "robot.yaml:2:1: 'a' appears here twice");
}

TEST(YamlReader, allErrorsAreReportedInTheOrderOfTheFile) {
  YamlReader yaml = reader("a: x\nb: [1, z]\nc: 1\n");
  yaml.root().required<std::vector<double>>("b");
  yaml.root().required<int>("a");
  const auto result = yaml.finish();
  ASSERT_FALSE(result);
  ASSERT_EQ(result.error().size(), 3U);
  EXPECT_EQ(result.error()[0].where, (FilePosition{"robot.yaml", 1, 4}));
  EXPECT_EQ(result.error()[1].where, (FilePosition{"robot.yaml", 2, 8}));
  EXPECT_EQ(result.error()[2].id, "yaml.unknown-key");
}

TEST(YamlReader, aSyntaxErrorHasItsPlace) {
  const auto result = YamlReader::parse("a: 1\nb: [1, 2\nc: 3\n", "robot.yaml");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().id, "yaml.syntax");
  EXPECT_GE(result.error().where.line, 2);
}

TEST(YamlReader, numbersMustBeFiniteAndPlain) {
  for (const char* text : {".nan", ".inf", "1e999", "nan", "inf", "1 m", "0x10", "''", "'1'", "[1]", "~"}) {
    YamlReader yaml = reader(std::string("a: ") + text + "\n");
    yaml.root().required<double>("a");
    EXPECT_THAT(errorsOf(yaml), HasSubstr("a finite number")) << text;
  }
}

TEST(YamlReader, rangesAndLengthsAreChecked) {
  YamlReader yaml = reader("radius: -1\nposition: [1, 2]\n");
  EXPECT_EQ(yaml.root().numberIn("radius", 0, 5), 0);
  EXPECT_THAT(yaml.root().numbers("position", 3), ElementsAre(1, 2, 0));
  EXPECT_EQ(
      errorsOf(yaml),
      "robot.yaml:1:9: 'radius' must be between 0 and 5\nrobot.yaml:2:11: 'position' must have 3 numbers");
}

TEST(YamlReader, wholeNumbersOfARangeAreNotCut) {
  YamlReader yaml = reader("a: 3\nb: 2.5\nc: 11\nd: 99999999999\n");
  EXPECT_EQ(yaml.root().wholeNumberIn("a", 2, 10), 3);
  EXPECT_EQ(yaml.root().wholeNumberIn("b", 2, 10), 2);
  EXPECT_EQ(yaml.root().wholeNumberIn("c", 2, 10), 2);
  EXPECT_EQ(yaml.root().wholeNumberIn("d", 2, 10), 2);
  EXPECT_EQ(errorsOf(yaml),
            "robot.yaml:2:4: here should be a whole number, not '2.5'\n"
            "robot.yaml:3:4: 'c' must be between 2 and 10\n"
            "robot.yaml:4:4: here should be a whole number, not '99999999999'");
}

TEST(YamlReader, whatIsNoNumberIsOneError) {
  YamlReader yaml = reader("radius: large\n");
  EXPECT_EQ(yaml.root().numberIn("radius", 1, 5), 1);
  EXPECT_EQ(errorsOf(yaml), "robot.yaml:1:9: here should be a finite number, not 'large'");
}

TEST(YamlReader, mapsWhoseKeysAreDataKeepTheirOrder) {
  YamlReader yaml = reader("palette: {white: 1, green: 2, orange: 3}\n");
  std::vector<std::string> names;
  for (const auto& [name, value] : yaml.root().child("palette").entries()) names.push_back(name);
  EXPECT_THAT(names, ElementsAre("white", "green", "orange"));
  EXPECT_EQ(errorsOf(yaml), "");
}

TEST(YamlReader, aSmallFileThatStandsForAHugeTreeIsRefused) {
  std::string text = "a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string previous = "*a" + std::to_string(i - 1);
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + previous;
    for (int j = 0; j < 9; ++j) text += ", " + previous;
    text += "]\n";
  }
  const auto result = YamlReader::parse(text, "bomb.yaml");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text, HasSubstr("too large"));
}

TEST(YamlReader, aMissingFileIsAnErrorWithItsName) {
  const auto result = YamlReader::load("/nowhere/robot.yaml");
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().describe(), HasSubstr("/nowhere/robot.yaml"));
}

TEST(YamlReader, anEmptyFileLacksEverything) {
  YamlReader yaml = reader("");
  yaml.root().required<int>("version");
  EXPECT_THAT(errorsOf(yaml), HasSubstr("a map with the key 'version'"));
}

}  // namespace
}  // namespace robotlink
