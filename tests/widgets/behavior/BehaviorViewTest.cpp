// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/behavior/BehaviorView.h"

#include <QAction>
#include <QLabel>
#include <algorithm>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/packages/GamePackages.h"
#include "tests/widgets/Bench.h"
#include "widgets/behavior/OptionCanvas.h"

namespace widgets::test {

using robotcontrol::BehaviorGraph;
using robotcontrol::BehaviorState;

namespace {

void addTransition(BehaviorGraph::Option& option, const char* from, const char* to, const char* reason) {
  auto& transition = *option.add_transitions();
  transition.set_from(from);
  transition.set_to(to);
  transition.set_reason(reason);
}

/// game: play (activates strike), rest; strike: search, kick.
BehaviorGraph someGraph() {
  BehaviorGraph graph;
  graph.set_solution("soccer");
  auto& game = *graph.add_options();
  game.set_name("game");
  auto& play = *game.add_states();
  play.set_name("play");
  play.add_options("strike");
  game.add_states()->set_name("rest");
  addTransition(game, "", "rest", "the game is over");
  auto& strike = *graph.add_options();
  strike.set_name("strike");
  strike.set_help("Plays the ball.");
  for (const char* name : {"search", "kick"}) strike.add_states()->set_name(name);
  addTransition(strike, "search", "kick", "found");
  addTransition(strike, "kick", "search", "kicked");
  return graph;
}

void activate(BehaviorState& state, const char* option, const char* name, const char* reason,
              double seconds) {
  auto& active = *state.add_active();
  active.set_option(option);
  active.set_state(name);
  active.set_reason(reason);
  active.set_seconds(seconds);
}

BehaviorState someState(const char* strike) {
  BehaviorState state;
  state.set_solution("soccer");
  activate(state, "game", "play", "the game is on", 9);
  activate(state, "strike", strike, "found", 1.5);
  return state;
}

}  // namespace

class BehaviorViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theModelKnowsWhatIsActiveAndTheWayToEachState() {
    BehaviorModel model;
    const BehaviorGraph graph = someGraph();
    QVERIFY(model.setGraph(&graph));
    const BehaviorState state = someState("kick");
    QVERIFY(!model.setState(&state));
    QCOMPARE(model.active().size(), std::size_t{2});
    QCOMPARE(model.activeIn(1)->state, 1);
    QVERIFY(model.description().contains(QStringLiteral("strike: kick for 1.5 s, because found")));
    const auto path = model.pathTo({1, 0});
    QCOMPARE(model.forcedText(path), QStringLiteral("game=play, strike=search"));
    QVERIFY(model.pathTo({1, 7}).empty());
    QVERIFY(model.pathTo({5, 0}).empty());
  }

  void aBehaviorWithoutAGraphShowsItsStateOnly() {
    BehaviorModel model;
    BehaviorState state;
    state.set_solution("go-to-ball-and-kick");
    state.set_state("approach");
    QVERIFY(model.setState(&state));
    QCOMPARE(model.options().size(), std::size_t{1});
    QVERIFY(!model.hasGraph());
    state.set_state("kick");
    QVERIFY(model.setState(&state));
    QCOMPARE(model.options()[0].states.size(), std::size_t{2});
  }

  void theHistoryHasASegmentForEachStateAndGapsWhereAnOptionWasNotActive() {
    OptionHistory history;
    for (int i = 0; i < 10; ++i) history.add(i, someState(i < 4 ? "search" : "kick"));
    BehaviorState rest;
    activate(rest, "game", "rest", "the game is over", 0);
    for (int i = 10; i < 13; ++i) history.add(i, rest);
    QCOMPARE(history.rows().size(), std::size_t{2});
    const auto& strike = history.rows()[1].segments;
    QCOMPARE(strike.size(), std::size_t{2});
    QCOMPARE(strike[0].to, 4.0);
    QCOMPARE(strike[1].state, QStringLiteral("kick"));
    QVERIFY(strike[1].to <= 9.0);
    QCOMPARE(history.rows()[0].segments.back().from, 10.0);
    history.add(200, rest);
    QCOMPARE(history.rows()[1].segments.size(), std::size_t{0});
  }

  void boxesDoNotOverlapAndEveryStateIsFoundWhereItIsDrawn() {
    BehaviorModel model;
    const BehaviorGraph graph = someGraph();
    model.setGraph(&graph);
    const OptionGraph picture(model);
    QVERIFY(!picture.optionRect(0).intersects(picture.optionRect(1)));
    QVERIFY(picture.optionRect(0).right() < picture.optionRect(1).left());
    for (int option = 0; option < 2; ++option)
      for (int state = 0; state < 2; ++state) {
        const BehaviorModel::Place place{option, state};
        QVERIFY(picture.at(picture.stateRect(place).center()) == place);
      }
    QVERIFY(OptionGraph::toolTip(model, {1, 0}).contains(QStringLiteral("found")));
    QVERIFY(!OptionGraph::toolTip(model, {1, 0}).contains(QStringLiteral("kicked")));
  }

  void noLineIsHiddenByABox() {
    // root: a state for each option below; a and b: each of the next, and back to the root; c: none.
    BehaviorGraph graph;
    graph.set_solution("soccer");
    const char* const names[]{"root", "a", "b", "c", "d", "e"};
    for (int i = 0; i < 6; ++i) {
      auto& option = *graph.add_options();
      option.set_name(names[i]);
      for (int to = 0; to < 6; ++to) {
        if (to == i || (i > 2 && to < 5)) continue;
        auto& state = *option.add_states();
        state.set_name(std::string("to ") + names[to]);
        if (to > i || to == 0) state.add_options(names[to]);
      }
    }
    BehaviorModel model;
    model.setGraph(&graph);
    const OptionGraph picture(model);
    QVERIFY(picture.lines().size() > 10);
    for (const OptionGraph::Line& line : picture.lines()) {
      QCOMPARE(line.path.elementAt(0).x, picture.stateRect(line.from).right());
      QCOMPARE(line.path.currentPosition().x(), picture.optionRect(line.to).left());
      for (int i = 1; i < 200; ++i) {
        const QPointF at = line.path.pointAtPercent(i / 200.0);
        for (int option = 0; option < 6; ++option)
          QVERIFY2(
              !picture.optionRect(option).adjusted(1, 1, -1, -1).contains(at),
              qPrintable(QStringLiteral("%1 to %2 in %3").arg(line.from.option).arg(line.to).arg(option)));
        QVERIFY(picture.bounds().contains(at));
      }
    }
  }

  void whetherABehaviorIsHeldIsAskedUntilTheRobotOrTheUserSaysIt() {
    Bench bench;
    robotcontrol::SolutionTable table;
    auto& task = *table.add_tasks();
    task.set_name("behavior");
    task.set_active("soccer");
    task.add_solutions()->set_name("soccer");
    task.mutable_solutions(0)->set_has_parameters(true);
    bench.push("red1/tables/solutions", table, 1);
    auto view = bench.open<BehaviorView>();
    bench.push(std::string("red1/") + robotlink::kBehaviorGraph.name, someGraph(), 1);
    bench.push(std::string("red1/") + robotlink::kBehaviorState.name, someState("kick"), 1);
    bench.advance();
    bench.tick(*view);
    const auto asked = [&bench] {
      return std::ranges::count_if(bench.requests, [](const auto& one) { return one.has_get_parameters(); });
    };
    QCOMPARE(asked(), 1);
    bench.answer(false, "its program starts");
    for (int i = 0; i < 40; ++i) bench.tick(*view);
    QCOMPARE(asked(), 2);
    const auto pending = bench.requests.back();
    auto& hold = child<QAction>(*view, "behaviorHoldAction");
    hold.trigger();
    bench.answer(pending, false, "its program starts");
    bench.tick(*view);
    QVERIFY2(hold.isChecked(), "the user chose it since");
    const auto before = asked();
    for (int i = 0; i < 40; ++i) bench.tick(*view);
    QCOMPARE(asked(), before);
  }

  void theViewShowsWhatIsActiveAndEnablesForcingOfSelectedStates() {
    Bench bench;
    auto view = bench.open<BehaviorView>();
    QVERIFY(!child<QAction>(*view, "behaviorForceAction").isEnabled());
    bench.push(std::string("red1/") + robotlink::kBehaviorGraph.name, someGraph(), 1);
    bench.push(std::string("red1/") + robotlink::kBehaviorState.name, someState("kick"), 1);
    bench.advance();
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "behaviorNow").text().contains(QStringLiteral("strike: kick")));
    auto& graph = child<OptionCanvas>(*view, "behaviorGraph");
    const QPoint place = graph.stateRect({1, 0}).center().toPoint();
    QTest::mouseClick(&graph, Qt::LeftButton, {}, place);
    QVERIFY((graph.selected() == BehaviorModel::Place{1, 0}));
    QVERIFY(child<QAction>(*view, "behaviorForceAction").isEnabled());
    QVERIFY(!child<QAction>(*view, "behaviorStepAction").isEnabled());
    keepPicture(*view, "behavior");
  }
};

const GuiTest<BehaviorViewTest> kBehaviorViewTest;

}  // namespace widgets::test

#include "BehaviorViewTest.moc"
