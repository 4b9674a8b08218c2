// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/config/RobotUse.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/TestFolder.h"

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(RobotUse, fieldAndTeamsAreRead) {
  const auto use = parseRobotUse("field: \"2002\"\nteams: [red, blue]\n", "r.yaml");
  ASSERT_TRUE(use) << describe(use.error());
  EXPECT_EQ(use->field, "2002");
  EXPECT_THAT(use->teams, ElementsAre("red", "blue"));
}

TEST(RobotUse, theOtherKeysAreTheDescriptions) {
  const auto use = parseRobotUse(
      "version: 1\njoints: [{name: a, limits: [0, {deep: 1}]}]\ndrive: {x: [1, 2]}\n", "r.yaml");
  ASSERT_TRUE(use) << describe(use.error());
  EXPECT_EQ(use->field, "");
  EXPECT_THAT(use->teams, IsEmpty());
}

TEST(RobotUse, aFieldInAnotherFolderIsRefusedWithItsPlace) {
  const auto use = parseRobotUse("teams: [red]\nfield: ../secrets/field\n", "r.yaml");
  ASSERT_FALSE(use);
  EXPECT_EQ(use.error().front().id, "robot.field");
  EXPECT_THAT(use.error().front().describe(), HasSubstr("r.yaml"));
}

TEST(RobotUse, aTeamThatIsNoTextIsRefused) {
  EXPECT_FALSE(parseRobotUse("teams: red\n", "r.yaml"));
  EXPECT_FALSE(parseRobotUse("teams: [[red]]\n", "r.yaml"));
  EXPECT_FALSE(parseRobotUse("field: [2002]\n", "r.yaml"));
}

TEST(RobotUse, textThatIsNoYamlIsRefused) {
  EXPECT_FALSE(parseRobotUse("field: [", "r.yaml"));
}

TEST(RobotUse, aFileThatIsMissingIsNamed) {
  const TestFolder folder;
  const auto use = readRobotUse(folder / "nobody.yaml");
  ASSERT_FALSE(use);
  EXPECT_THAT(use.error().front().describe(), HasSubstr("nobody.yaml"));
}

TEST(RobotUse, aRobotPlaysInTheTeamThatItsNameBeginsWith) {
  const RobotUse use{"2002", {"red", "blue"}};
  EXPECT_EQ(use.teamOf("blue3"), "blue");
  EXPECT_EQ(use.teamOf("red1"), "red");
  EXPECT_EQ(use.teamOf("goalie"), "red") << "the first team by default";
  EXPECT_EQ(use.teamOf(""), "red");
  EXPECT_EQ(RobotUse().teamOf("red1"), "") << "a robot without teams plays in none";
}

}  // namespace
}  // namespace robotlink
