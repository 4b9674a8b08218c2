// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/GameRules.h"

#include <gmock/gmock.h>

#include "robotlink/base/AtomicFile.h"

using namespace app;
using testing::HasSubstr;
using Watch = GameRules::Watch;

namespace {

std::string shippedRules() {
  return robotlink::readFile(gameRulesNamed("2002")).value();
}

std::string rulesWith(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

robotlink::Errors errorsIn(const std::string& text) {
  const auto rules = GameRules::parse(text, "rules.yaml");
  return rules ? robotlink::Errors() : rules.error();
}

}  // namespace

TEST(GameRules, thoseOf2002AreRead) {
  const auto rules = GameRules::load(gameRulesNamed("2002"));
  ASSERT_TRUE(rules) << robotlink::describe(rules.error());
  EXPECT_THAT(rules->teams, testing::ElementsAre("red", "blue"));
  EXPECT_EQ(rules->halves, 2U);
  EXPECT_EQ(rules->half, std::chrono::seconds(120));
  ASSERT_NE(rules->penaltyFor(Watch::kPushing), nullptr);
  EXPECT_EQ(rules->penaltyFor(Watch::kPushing)->reason, "pushing");
  EXPECT_EQ(rules->penalty("leaving")->watch, Watch::kLeaving);
  EXPECT_EQ(rules->penalty("illegal-defender")->watch, Watch::kDefending);
  EXPECT_EQ(rules->penalty("holding")->watch, Watch::kHolding);
  EXPECT_GT(rules->holdingDistance, 0.05);
  EXPECT_EQ(rules->penalty("request")->watch, Watch::kNothing);
  EXPECT_EQ(rules->penalty("laughing"), nullptr);
  EXPECT_LT(rules->goalie.x(), 0) << "it stands in its own half";
  for (const auto* places : {&rules->kicking, &rules->waiting})
    for (const auto& place : *places) EXPECT_LT(place.x(), 0);
}

TEST(GameRules, holdingIsWatchedIfTheFileSaysSo) {
  const std::string watched = "holding, watch: holding, after: 3,", near = "holding: {distance: 0.09}";
  const auto rules = GameRules::parse(shippedRules(), "rules.yaml");
  ASSERT_TRUE(rules) << robotlink::describe(rules.error());
  EXPECT_EQ(rules->penaltyFor(Watch::kHolding)->after, std::chrono::seconds(3));
  EXPECT_FALSE(errorsIn(rulesWith(shippedRules(), near, "")).empty()) << "how near is not said";
  const auto unwatched = rulesWith(shippedRules(), watched, "holding,");
  EXPECT_TRUE(errorsIn(rulesWith(unwatched, near, "")).empty());
}

TEST(GameRules, whatIsWrongIsSaidWithItsLine) {
  const auto wrongTeams = errorsIn(rulesWith(shippedRules(), "[red, blue]", "[red]"));
  ASSERT_EQ(wrongTeams.size(), 1U);
  EXPECT_EQ(wrongTeams[0].id, "game.teams");
  EXPECT_GT(wrongTeams[0].where.line, 0);
  EXPECT_EQ(errorsIn(rulesWith(shippedRules(), "watch: pushing", "watch: sleeping")).at(0).id, "game.word");
  EXPECT_EQ(errorsIn(rulesWith(shippedRules(), "reason: leaving", "reason: pushing")).at(0).id,
            "game.reason");
  EXPECT_EQ(errorsIn(rulesWith(shippedRules(), "goalie: [-1.85, 0.0]", "goalie: [1]")).at(0).id,
            "game.place");
  EXPECT_EQ(errorsIn(rulesWith(shippedRules(), "version: 1", "version: 2")).at(0).id, "game.version");
  EXPECT_FALSE(errorsIn(rulesWith(shippedRules(), "count: 2", "count: 1.5")).empty());
  EXPECT_FALSE(errorsIn(rulesWith(shippedRules(), "loss: 0.02", "loss: 2")).empty());
  EXPECT_FALSE(errorsIn("version: 1\n").empty());
}
