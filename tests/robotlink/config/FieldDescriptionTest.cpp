// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/FieldDescription.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "robotlink/base/AtomicFile.h"

namespace robotlink {
namespace {

using testing::HasSubstr;

const char* const kFile = ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml";

std::string fieldText() {
  return readFile(kFile).value();
}

/// The shipped file with one passage replaced.
std::string withReplaced(const std::string& from, const std::string& to) {
  std::string text = fieldText();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string fieldErrors(const std::string& text) {
  const auto field = FieldDescription::parse(text, "field.yaml");
  return field ? "" : describe(field.error());
}

TEST(FieldDescription, theFieldOf2002HasItsMeasures) {
  const auto field = FieldDescription::load(kFile);
  ASSERT_TRUE(field) << describe(field.error());
  EXPECT_EQ(field->length, 4.2);
  EXPECT_EQ(field->width, 2.7);
  EXPECT_EQ(field->goals.size(), 2U);
  ASSERT_EQ(field->beacons.size(), 6U);
  EXPECT_DOUBLE_EQ(field->beaconTopBandHeight(), 0.35);
  EXPECT_DOUBLE_EQ(field->beaconBottomBandHeight(), 0.25);
  ASSERT_NE(field->color("orange"), nullptr);
  EXPECT_EQ(field->color("mauve"), nullptr);
}

TEST(FieldDescription, placesOfTheKickOffLieInTheOwnHalf) {
  const auto field = FieldDescription::load(kFile);
  ASSERT_TRUE(field);
  ASSERT_EQ(field->kickOff.size(), 4U);
  EXPECT_EQ(field->kickOff[0], (Pose2{-0.8, 0, 0}));
  const std::string wrong = fieldErrors(withReplaced("[[-0.8, 0.0]", "[[0.8, 0.0]"));
  EXPECT_THAT(wrong, HasSubstr("field.yaml:27"));
  EXPECT_THAT(wrong, HasSubstr("in the half of the team that plays toward +x"));
}

TEST(FieldDescription, theFieldOf2002IsSymmetric) {
  const auto field = FieldDescription::load(kFile);
  ASSERT_TRUE(field);
  for (const auto& beacon : field->beacons) {
    const auto mirrored = std::ranges::find_if(
        field->beacons, [&](const auto& other) { return other.position.isApprox(-beacon.position); });
    ASSERT_NE(mirrored, field->beacons.end()) << beacon.name;
    EXPECT_EQ(mirrored->topColor == "pink", beacon.bottomColor == "pink") << beacon.name;
  }
}

TEST(FieldDescription, aFieldNeedsNoWallsAndNoBeaconsButMayHaveLinesAroundIt) {
  const auto field = FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2009.yaml");
  ASSERT_TRUE(field) << describe(field.error());
  EXPECT_TRUE(field->hasBoundary());
  EXPECT_EQ(field->goalLineX(), 3);
  EXPECT_EQ(field->touchLineY(), 2);
  EXPECT_EQ(field->wallHeight, 0);
  EXPECT_TRUE(field->beacons.empty());
  EXPECT_FALSE(FieldDescription::load(kFile)->hasBoundary());
  EXPECT_EQ(FieldDescription::load(kFile)->goalLineX(), 2.1) << "the walls bound the field of play";
  EXPECT_THAT(fieldErrors(withReplaced("lines: {width: 0.025,",
                                       "lines: {boundary: {length: 9, width: 2}, width: 0.025,")),
              HasSubstr("'length' must be between"));
}

TEST(FieldDescription, teamsHaveAGoalToAttackAndAColor) {
  const auto field = FieldDescription::parse(withReplaced("{name: red, attacks: skyblue, color: red}",
                                                          "{name: cyan, attacks: yellow, color: skyblue}"),
                                             "field.yaml");
  ASSERT_TRUE(field) << describe(field.error());
  EXPECT_EQ(field->playingDirection("cyan"), -1);
  EXPECT_EQ(field->teamColor("cyan"), *field->color("skyblue"));
  EXPECT_EQ(field->playingDirection("red"), 1) << "is not one of the teams";
  EXPECT_THAT(fieldErrors(withReplaced("attacks: skyblue", "attacks: green")),
              HasSubstr("attacks 'green', which is not one of the goals"));
}

TEST(FieldDescription, aFieldOfAnOlderLogHasTheTeamsOf2002) {
  std::string text = fieldText();
  const std::size_t begin = text.find("teams:"), end = text.find("# Where robots");
  ASSERT_LT(begin, end);
  const auto old = FieldDescription::parse(text.erase(begin, end - begin), "field.yaml");
  ASSERT_TRUE(old) << describe(old.error());
  EXPECT_EQ(old->playingDirection("red"), 1);
  EXPECT_EQ(old->playingDirection("blue"), -1);
  EXPECT_EQ(old->teamColor("blue"), *old->color("blue"));
}

TEST(FieldDescription, aColorThatThePaletteLacksIsRefusedWithItsPlace) {
  EXPECT_THAT(fieldErrors(withReplaced("mass: 0.026, color: orange", "mass: 0.026, color: mauve")),
              AllOf(testing::StartsWith("field.yaml:"), HasSubstr(": the palette has no color 'mauve'")));
}

TEST(FieldDescription, wrongValuesAreRefused) {
  EXPECT_THAT(fieldErrors(withReplaced("length: 4.2", "length: -4.2")),
              HasSubstr("'length' must be between"));
  EXPECT_THAT(fieldErrors(withReplaced("length: 4.2", "length: 1e9")), HasSubstr("'length' must be between"));
  EXPECT_THAT(fieldErrors(withReplaced("mass: 0.026", "mass: .nan")), HasSubstr("a finite number"));
  EXPECT_THAT(fieldErrors(withReplaced("[0, 130, 50]", "[0, 130, 256]")),
              HasSubstr("three whole numbers from 0 to 255"));
  EXPECT_THAT(fieldErrors(withReplaced("position: [-2.2, 1.45]", "position: [-2.2]")),
              HasSubstr("must have 2 numbers"));
  EXPECT_THAT(fieldErrors(withReplaced("thickness:", "thikness:")),
              AllOf(HasSubstr("unknown key 'thikness'"), HasSubstr("'thickness' is missing")));
  EXPECT_THAT(fieldErrors(withReplaced("version: 1", "version: 2")), HasSubstr("only version 1"));
}

}  // namespace
}  // namespace robotlink
