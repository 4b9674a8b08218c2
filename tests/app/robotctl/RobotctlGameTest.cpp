// SPDX-License-Identifier: GPL-3.0-or-later
// Games and tournaments as users of `robotctl` play them.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tests/TestFolder.h"
#include "tests/app/robotctl/RobotctlRun.h"

namespace {

using nlohmann::json;
using testing::HasSubstr;

class RobotctlGame : public testing::Test {
 protected:
  RobotctlOutcome robotctl(const std::string& arguments) const {
    return runRobotctl(folder_.path(), arguments);
  }
  json printed(const std::string& arguments) const {
    const RobotctlOutcome outcome = robotctl(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return outcome.status == 0 ? json::parse(outcome.out) : json();
  }
  TestFolder folder_;
};

}  // namespace

TEST_F(RobotctlGame, aGamePrintsScoreThreadsAndADigestThatIsTheSameForAnyNumberOfThem) {
  const std::string game = "sim game2002-1 --seconds 5 --seed 1 --blackout --json --threads ";
  const json one = printed(game + "1"), two = printed(game + "2");
  EXPECT_EQ(one["score"], (json{{"red", 0}, {"blue", 0}}));
  EXPECT_EQ(one["threads"], 1);
  EXPECT_EQ(two["threads"], 2);
  EXPECT_EQ(one["digest"], two["digest"]);
  EXPECT_EQ(one["game"], two["game"]);
  EXPECT_EQ(one["game"]["phase"], "playing");
  EXPECT_NEAR(one["game"]["seconds_left"].get<double>(), 115, 0.1);
  ASSERT_EQ(one["game"]["players"].size(), 2U);
  EXPECT_EQ(one["game"]["players"][1]["team"], "blue");
}

TEST_F(RobotctlGame, whatIsChosenForNobodyIsNamed) {
  const std::string game = "sim game2002-1 --seconds 0.1 ";
  EXPECT_EQ(robotctl(game + "--solution red/behavior=stand --layout blue1=parallel --game none").status, 0);
  EXPECT_THAT(robotctl(game + "--solution green/behavior=stand").errors, HasSubstr("green"));
  EXPECT_EQ(robotctl(game + "--solution green/behavior=stand").status, 1);
  EXPECT_EQ(robotctl(game + "--solution /behavior=stand").status, 2);
  EXPECT_EQ(robotctl(game + "--game nonsense").status, 1);
}

TEST_F(RobotctlGame, programsStartWithChosenColorTables) {
  // A table in which everything is black sees no ball: 262,144 cells of class 0, then the end.
  const std::string cells{"\0\0\4\0\0\0\0\0\0", 9};
  std::ofstream(folder_ / "blind.c64", std::ios::binary) << cells;
  const std::string game = "sim game2002-1 --seconds 2 --errors --json ";
  const auto isSeen = [](const json& figures, const char* robot) {
    return figures["errors"][robot]["percepts/ball"].contains("position");
  };
  const json seeing = printed(game), blind = printed(game + "--color-table blue=blind.c64"),
             other = printed(game + "--color-table red=blind.c64");
  EXPECT_TRUE(isSeen(seeing, "blue1")) << seeing["errors"];
  EXPECT_FALSE(isSeen(blind, "blue1"));
  EXPECT_TRUE(isSeen(other, "blue1"));
  const auto outcome = robotctl(game + "--color-table green=blind.c64");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.errors, testing::AllOf(HasSubstr("green"), HasSubstr("--color-table")));
  EXPECT_THAT(robotctl(game + "--color-table none.c64").errors, HasSubstr("none.c64"));
}

TEST_F(RobotctlGame, aTournamentSwapsSidesKeepsResultsAndReports) {
  const std::string tournament =
      "tournament still:behavior=stand compact --scene game2002-1 --games 2 --seconds 1 --out cup ";
  const json first = printed(tournament + "--json");
  ASSERT_EQ(first["games"].size(), 2U);
  EXPECT_EQ(first["games"][0]["red"]["team"], "still");
  EXPECT_EQ(first["games"][1]["red"]["team"], "compact");
  EXPECT_EQ(first["games"][0]["seed"], first["games"][1]["seed"]);
  EXPECT_EQ(first["standings"][0]["draws"], 2);
  for (const char* file : {"report.html", "games.csv", "results.csv", "tournament.json"})
    EXPECT_TRUE(std::filesystem::exists(folder_ / "cup" / file)) << file;
  const auto result = folder_ / "cup/runs/compact-against-still--game-2.json";
  const auto made = std::filesystem::last_write_time(result);
  EXPECT_EQ(printed(tournament + "--json"), first);
  EXPECT_EQ(std::filesystem::last_write_time(result), made) << "it was not played again";
  EXPECT_EQ(robotctl("tournament compact compact --out cup").status, 2) << "they have the same name";
  EXPECT_EQ(robotctl("tournament a:behavior= compact --out cup").status, 2);
  EXPECT_THAT(robotctl("tournament a:compact,soccer compact --out cup").errors, HasSubstr("two of layout"));
}

TEST_F(RobotctlGame, aTournamentThatCannotBePlayedSaysWhyBeforeItBegins) {
  const auto errorOf = [&](const std::string& arguments) {
    const RobotctlOutcome outcome = robotctl("tournament --games 1000 --out cup " + arguments);
    EXPECT_NE(outcome.status, 0);
    return outcome.errors;
  };
  EXPECT_THAT(errorOf("A:nolayout B:compact"), HasSubstr("nolayout"));
  EXPECT_THAT(errorOf("A:soccer,behavior=nope B:compact"), HasSubstr("has no solution 'nope'"));
  EXPECT_THAT(errorOf("A:soccer B:compact --scene field2002"),
              HasSubstr("there is no robot, team or kind of robots blue"));
  EXPECT_THAT(errorOf("A:soccer B:compact -- --light x"), HasSubstr("--light"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "cup/runs"));
}
