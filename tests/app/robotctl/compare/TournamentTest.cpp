// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotctl/compare/Tournament.h"

#include <gmock/gmock.h>

using namespace app;
using nlohmann::json;
using testing::HasSubstr;

namespace {

Tournament smallTournament() {
  Tournament tournament;
  tournament.teams = {TeamChoice::parse("good:parallel,behavior=clever").value(),
                      TeamChoice::parse("compact").value()};
  tournament.scene = "game2002-1";
  tournament.games = 4;
  tournament.firstSeed = 5;
  tournament.seconds = 60;
  return tournament;
}

/// What `robotctl sim` prints of a game.
json printed(int red, int blue) {
  return {
      {"score", {{"red", red}, {"blue", blue}}},
      {"digest", "0123"},
      {"errors",
       {{"red1", {{"models/ball", {{"missed", 0.25}}}}}, {"blue1", {{"models/ball", {{"missed", 0.5}}}}}}},
      {"game",
       {{"players",
         {{{"robot", "red1"}, {"team", "red"}, {"penalties", 1}, {"longest_outside_seconds", 2.5}},
          {{"robot", "blue1"}, {"team", "blue"}, {"penalties", 0}}}}}}};
}

const Comparison::Row& rowOf(const Comparison& comparison, const std::string& name) {
  const auto row = std::ranges::find(comparison.rows(), name, &Comparison::Row::name);
  EXPECT_NE(row, comparison.rows().end()) << name;
  return *row;
}

}  // namespace

TEST(Tournament, teamsAreWrittenInParts) {
  const auto team = TeamChoice::parse("fast:compact,behavior=stand,motion=crawl,preset=tuned.yaml");
  ASSERT_TRUE(team);
  EXPECT_EQ(team->name, "fast");
  EXPECT_THAT(team->optionsFor("blue"),
              testing::ElementsAre("--layout", "blue=compact", "--solution", "blue/behavior=stand",
                                   "--solution", "blue/motion=crawl", "--preset", "blue=tuned.yaml"));
  EXPECT_EQ(TeamChoice::parse("compact")->layout, "compact");
  EXPECT_EQ(TeamChoice::parse("compact")->name, "compact");
  EXPECT_TRUE(TeamChoice::parse("plain:")->optionsFor("red").empty());
  EXPECT_FALSE(TeamChoice::parse("a:behavior="));
  EXPECT_FALSE(TeamChoice::parse(":compact"));
  EXPECT_FALSE(TeamChoice::parse(""));
}

TEST(Tournament, sidesAreSwappedWithTheSameSeed) {
  const auto runs = smallTournament().runs();
  ASSERT_EQ(runs.size(), 4U);
  EXPECT_THAT(shellLine(runs[0].arguments), HasSubstr("--seed 5 "));
  EXPECT_THAT(shellLine(runs[0].arguments),
              HasSubstr("red=parallel --solution red/behavior=clever --layout blue=compact"));
  EXPECT_THAT(shellLine(runs[1].arguments), HasSubstr("--seed 5 "));
  EXPECT_THAT(shellLine(runs[1].arguments), HasSubstr("red=compact --layout blue=parallel"));
  EXPECT_THAT(shellLine(runs[2].arguments), HasSubstr("--seed 6 "));
  EXPECT_EQ(runs[1].variant, "compact against good");
  EXPECT_EQ(runs[1].subject, "game 2");
}

TEST(Tournament, countsForTheTeamWhateverItsColor) {
  const Tournament tournament = smallTournament();
  TournamentTable table(tournament);
  ASSERT_TRUE(table.add(0, printed(2, 0)));
  ASSERT_TRUE(table.add(1, printed(1, 3)));
  ASSERT_TRUE(table.add(2, printed(1, 1)));
  const auto standings = table.standings();
  EXPECT_EQ(standings[0].team, "good");
  EXPECT_EQ(standings[0].wins, 2);
  EXPECT_EQ(standings[0].draws, 1);
  EXPECT_EQ(standings[0].goals, 6);
  EXPECT_EQ(standings[0].conceded, 2);
  EXPECT_EQ(standings[1].losses, 2);
  EXPECT_EQ(rowOf(table.figures(), "games won").byVariant.at("good").bySubject.at("game 3"), 0.5);
  EXPECT_EQ(rowOf(table.figures(), "penalties").byVariant.at("compact").bySubject.at("game 2"), 1)
      << "the red one is of the other team then";
  EXPECT_EQ(rowOf(table.figures(), "models/ball missed").byVariant.at("good").bySubject.at("game 2"), 0.5);
  EXPECT_FALSE(table.add(3, json::object()));
}

TEST(Tournament, isReportedAsTablesAndJson) {
  const Tournament tournament = smallTournament();
  TournamentTable table(tournament);
  ASSERT_TRUE(table.add(0, printed(2, 0)));
  EXPECT_EQ(table.csv(), "game,seed,red,blue,goals of red,goals of blue,digest\n1,5,good,compact,2,0,0123\n");
  EXPECT_EQ(table.asJson()["games"][0]["red"]["goals"], 2);
  EXPECT_EQ(table.asJson()["standings"][1]["losses"], 1);
  const std::string page =
      reportHtml(table.figures(), {"good against compact", "robotctl", {}, table.tables()});
  EXPECT_THAT(page, HasSubstr("<h2>Standings</h2>"));
  EXPECT_THAT(page, HasSubstr("<td>2 : 0</td>"));
}
