// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged graphs, circles and other behaviors; BehaviorViewTest has how it is shown.
#include "widgets/behavior/BehaviorModel.h"

#include <gtest/gtest.h>

#include "robotcontrol/Motion.pb.h"

namespace widgets::test {
namespace {

using Place = BehaviorModel::Place;
using Places = std::vector<Place>;

/// An option whose states may activate the options behind their colons: "play:strike".
void addOption(robotcontrol::BehaviorGraph& graph, const char* name,
               std::initializer_list<const char*> states) {
  auto& option = *graph.add_options();
  option.set_name(name);
  for (const std::string state : states) {
    const std::size_t colon = state.find(':');
    option.add_states()->set_name(state.substr(0, colon));
    if (colon != std::string::npos) option.mutable_states()->rbegin()->add_options(state.substr(colon + 1));
  }
}

void addTransition(robotcontrol::BehaviorGraph& graph, const char* from, const char* to) {
  auto& transition = *graph.mutable_options(0)->add_transitions();
  transition.set_from(from);
  transition.set_to(to);
}

class BehaviorModelTest : public testing::Test {
 protected:
  BehaviorModelTest() {
    graph.set_solution("soccer");
    addOption(graph, "game", {"rest", "play:strike", "defend:strike"});
    addOption(graph, "strike", {"search", "kick:shoot"});
    addOption(graph, "shoot", {"left", "right"});
  }
  void activate(const char* option, const char* name, bool isForced = false) {
    auto& active = *state.add_active();
    active.set_option(option);
    active.set_state(name);
    active.set_seconds(2);
    active.set_forced(isForced);
    active.set_reason("so");
    state.set_solution("soccer");
  }

  robotcontrol::BehaviorGraph graph;
  robotcontrol::BehaviorState state;
  BehaviorModel model;
};

TEST_F(BehaviorModelTest, namesThatTheGraphDoesNotExplainAreLeftOut) {
  graph.mutable_options(0)->mutable_states(0)->add_options("unknown");
  addTransition(graph, "", "play");
  addTransition(graph, "play", "unknown");
  addTransition(graph, "unknown", "play");
  addTransition(graph, "play", "rest");
  EXPECT_TRUE(model.setGraph(&graph));
  const auto& game = model.options()[0];
  EXPECT_TRUE(game.states[0].options.empty());
  ASSERT_EQ(game.transitions.size(), 2U);
  EXPECT_EQ(game.transitions[0].from, -1) << "from all others";
  EXPECT_EQ(game.transitions[0].to, 1);
  EXPECT_EQ(game.transitions[1].from, 1);
  EXPECT_EQ(game.transitions[1].to, 0);
}

TEST_F(BehaviorModelTest, theWayToAStateKeepsWhatIsActive) {
  model.setGraph(&graph);
  EXPECT_EQ(model.pathTo({2, 1}), (Places{{0, 1}, {1, 1}, {2, 1}})) << "the first way there is";
  activate("game", "defend");
  model.setState(&state);
  EXPECT_EQ(model.pathTo({2, 1}), (Places{{0, 2}, {1, 1}, {2, 1}}));
  EXPECT_EQ(model.pathTo({0, 0}), Places({{0, 0}}));
  EXPECT_EQ(model.forcedText(model.pathTo({1, 0})), QStringLiteral("game=defend, strike=search"));
}

TEST_F(BehaviorModelTest, thereIsNoWayToWhatNothingActivates) {
  addOption(graph, "alone", {"here"});
  model.setGraph(&graph);
  for (const Place& place : {Place{3, 0}, Place{0, 3}, Place{-1, 0}, Place{0, -1}, Place{4, 0}})
    EXPECT_TRUE(model.pathTo(place).empty()) << place.option << ' ' << place.state;
}

TEST_F(BehaviorModelTest, optionsThatActivateEachOtherDoNotHangIt) {
  graph.mutable_options(2)->mutable_states(0)->add_options("strike");
  graph.mutable_options(2)->mutable_states(1)->add_options("shoot");
  addOption(graph, "alone", {"here"});
  model.setGraph(&graph);
  EXPECT_TRUE(model.pathTo({3, 0}).empty());
  EXPECT_EQ(model.pathTo({2, 0}).size(), 3U);
}

TEST_F(BehaviorModelTest, anotherSolutionForgetsTheGraph) {
  model.setGraph(&graph);
  EXPECT_TRUE(model.hasGraph());
  state.set_solution("chase");
  state.set_state("approach");
  EXPECT_TRUE(model.setState(&state));
  EXPECT_FALSE(model.hasGraph());
  ASSERT_EQ(model.options().size(), 1U);
  EXPECT_EQ(model.options()[0].name, QStringLiteral("chase"));
  EXPECT_TRUE(model.setGraph(nullptr));
  EXPECT_FALSE(model.setGraph(nullptr)) << "there was nothing any more";
}

TEST_F(BehaviorModelTest, whatTheGraphLacksIsAddedOnce) {
  model.setGraph(&graph);
  activate("game", "celebrate");
  activate("dance", "turn");
  EXPECT_TRUE(model.setState(&state));
  EXPECT_FALSE(model.setState(&state));
  EXPECT_EQ(model.options()[0].states.back().name, QStringLiteral("celebrate"));
  EXPECT_EQ(model.activeIn(3)->state, 0);
  EXPECT_EQ(model.activeIn(1), nullptr);
  EXPECT_FALSE(model.setState(nullptr));
  EXPECT_TRUE(model.active().empty());
}

TEST_F(BehaviorModelTest, aForcedStateSaysSoInsteadOfItsReason) {
  model.setGraph(&graph);
  activate("game", "play");
  activate("strike", "kick", true);
  model.setState(&state);
  EXPECT_EQ(model.description(),
            QStringLiteral("game: play for 2.0 s, because so\nstrike: kick for 2.0 s, forced"));
}

}  // namespace
}  // namespace widgets::test
