// SPDX-License-Identifier: GPL-3.0-or-later
// A game of two robots in the window: their solutions are switched and shadowed while they play, and their
// behavior is controlled.
#include <qtadvanceddocking/DockWidget.h>
#include <QComboBox>
#include <QTreeView>

#include "app/core/program/ShippedFiles.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/packages/GamePackages.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"
#include "widgets/behavior/OptionCanvas.h"
#include "widgets/solutions/SolutionModel.h"

namespace app::test {
namespace {

using robotcontrol::BehaviorState;
using widgets::SolutionModel;

constexpr char kLocalization[] = "self-localisation";

/// A desk with a running game one against one, in which blue1 is selected.
class GameDesk : public EmptyDesk {
 public:
  explicit GameDesk(const std::filesystem::path& home) : EmptyDesk(home) {
    RunOptions options = defaultSimulation();
    options.scene = sceneNamed("game2002-1");
    workbench.open(SimulationFeed::opening(options));
  }
  bool run(const std::string& line) { return workbench.commands().runLine(line).has_value(); }
  widgets::View* open(const char* id) {
    ads::CDockWidget* dock = window.docks().open(QLatin1String(id));
    dock->setAsCurrentTab();
    return qobject_cast<widgets::View*>(dock->widget());
  }
  const robotlink::StreamStore& store() { return workbench.session().store(); }
  /// The newest message of a stream, and its number from the start.
  const robotlink::StreamMessage* newest(const std::string& path) {
    return store().latest(path, robotlink::Instant::max());
  }
  template <typename T>
  const T* newestAs(const std::string& path) {
    return store().latestAs<T>(path, robotlink::Instant::max());
  }
  robotlink::Instant timeOf(const std::string& path) {
    const auto* message = newest(path);
    return message == nullptr ? robotlink::Instant() : message->time;
  }
  /// The cell of a solution of the task in the view Solutions.
  QModelIndex solution(const char* name, int column = SolutionModel::kName) {
    auto& tree = find<QTreeView>("solutionsTree");
    const auto& model = *tree.model();
    for (int task = 0; task < model.rowCount(); ++task) {
      const QModelIndex parent = model.index(task, 0);
      if (parent.data(SolutionModel::kTaskRole).toString() != QLatin1String(kLocalization)) continue;
      for (int row = 0; row < model.rowCount(parent); ++row) {
        const QModelIndex found = model.index(row, column, parent);
        if (found.data(SolutionModel::kSolutionRole).toString() == QLatin1String(name)) return found;
      }
    }
    return {};
  }
  bool isActive(const char* name) {
    return solution(name).data(SolutionModel::kChoiceRole).toInt() ==
           static_cast<int>(SolutionModel::Choice::kActive);
  }
  /// A person's click into the check box of a solution.
  void clickBox(const char* name) {
    auto& tree = find<QTreeView>("solutionsTree");
    const QModelIndex cell = solution(name, SolutionModel::kShadow);
    tree.scrollTo(cell);
    const QRect rect = tree.visualRect(cell);
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, QPoint(rect.left() + 10, rect.center().y()));
  }
  /// The state of an option of blue1's behavior; empty: it is not active.
  std::string stateOf(const std::string& option) {
    const auto* state = newestAs<BehaviorState>(std::string("blue1/") + robotlink::kBehaviorState.name);
    for (int i = 0; state != nullptr && i < state->active_size(); ++i)
      if (state->active(i).option() == option) return state->active(i).state();
    return {};
  }
  bool isForced(const std::string& option) {
    const auto* state = newestAs<BehaviorState>(std::string("blue1/") + robotlink::kBehaviorState.name);
    for (int i = 0; state != nullptr && i < state->active_size(); ++i)
      if (state->active(i).option() == option) return state->active(i).forced();
    return false;
  }
};

}  // namespace

class GameGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void solutionsOfOneRobotAreSwitchedAndShadowedInTheRunningGame() {
    GameDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.run("simulation.start"));
    QVERIFY(desk.run("robot.select blue1"));
    desk.open("solutions");
    QTRY_VERIFY_WITH_TIMEOUT(desk.solution("kalman").isValid(), kWaitMs);
    // All of them draw the pose that they believe, the particle filter its particles, too.
    QVERIFY(desk.run("robot.key self-localisation/pose always"));
    QVERIFY(desk.run("robot.key self-localisation/particles always"));
    const std::string particles = "blue1/drawings/field/self-localisation/particles",
                      pose = "blue1/drawings/field/self-localisation/pose",
                      shadow = "blue1/shadow/kalman/drawings/field/self-localisation/pose",
                      package = "blue1/shadow/kalman/models/pose";
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest(particles) != nullptr && desk.newest(pose) != nullptr, kWaitMs);
    QVERIFY(desk.isActive("field-monte-carlo"));
    // Another one in the shadow.
    desk.clickBox("kalman");
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest(shadow) != nullptr && desk.newest(package) != nullptr, kWaitMs);
    QTRY_COMPARE_WITH_TIMEOUT(
        desk.solution("kalman", SolutionModel::kShadow).data(Qt::CheckStateRole).toInt(),
        static_cast<int>(Qt::Checked), kWaitMs);
    QVERIFY(desk.isActive("field-monte-carlo"));
    QVERIFY(desk.newest("red1/shadow/kalman/models/pose") == nullptr);
    // What both cost.
    for (const char* name : {"kalman", "field-monte-carlo"})
      QTRY_VERIFY_WITH_TIMEOUT(
          desk.solution(name, SolutionModel::kCost).data().toString().contains(QStringLiteral(" ms, ")),
          kWaitMs);
    // Switching takes the particles away; the shadow goes on.
    widgets::test::clickCell(desk.find<QTreeView>("solutionsTree"), desk.solution("odometry"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.isActive("odometry"), kWaitMs);
    const auto switched = desk.timeOf(pose);
    QTRY_VERIFY_WITH_TIMEOUT(desk.timeOf(pose) > switched + std::chrono::milliseconds(200), kWaitMs);
    QVERIFY(desk.timeOf(particles) < switched + std::chrono::milliseconds(100));
    QTRY_VERIFY_WITH_TIMEOUT(desk.timeOf(shadow) > switched, kWaitMs);
    // A reset keeps both; unchecking ends the shadow.
    QVERIFY(desk.run("simulation.reset"));
    QVERIFY(desk.run("simulation.start"));
    QTRY_VERIFY_WITH_TIMEOUT(desk.newest(package) != nullptr && desk.isActive("odometry"), kWaitMs);
    desk.clickBox("kalman");
    QTRY_COMPARE_WITH_TIMEOUT(
        desk.solution("kalman", SolutionModel::kShadow).data(Qt::CheckStateRole).toInt(),
        static_cast<int>(Qt::Unchecked), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(desk.timeOf(pose) > desk.timeOf(package) + std::chrono::milliseconds(300),
                             kWaitMs);
    QVERIFY(desk.run("robot.shadow self-localisation kalman"));
    const auto before = desk.timeOf(package);
    QTRY_VERIFY_WITH_TIMEOUT(desk.timeOf(package) > before, kWaitMs);
  }

  void theRunningGameIsRefereedByHand() {
    GameDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.run("simulation.start"));
    auto* view = desk.open("game");
    const auto game = [&] { return desk.newestAs<robotcontrol::GameStatus>("game"); };
    QTRY_VERIFY_WITH_TIMEOUT(game() != nullptr && game()->players_size() == 2 && game()->automatic(),
                             kWaitMs);
    QTRY_VERIFY(child<QToolButton>(*view, "gameAutomatic").isChecked());
    click(*view, "gameAutomatic");
    QTRY_VERIFY_WITH_TIMEOUT(!game()->automatic(), kWaitMs);
    click(*view, "gameFinish");
    QTRY_COMPARE_WITH_TIMEOUT(game()->state().phase(), robotcontrol::GameState::FINISHED, kWaitMs);
    QTRY_VERIFY(child<QToolButton>(*view, "gameFinish").isChecked());
    click(*view, "gameRestart");
    QTRY_VERIFY_WITH_TIMEOUT(
        game()->state().phase() != robotcontrol::GameState::FINISHED && game()->state().half() == 1, kWaitMs);
    QVERIFY(!game()->automatic());
    click(*view, "gameAutomatic");
    QTRY_VERIFY_WITH_TIMEOUT(game()->automatic(), kWaitMs);
  }

  void theToolbarShowsTheLayoutOfTheSelectedRobot() {
    GameDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    const auto& box = desk.find<QComboBox>("layoutBox");
    QTRY_COMPARE_WITH_TIMEOUT(box.currentText(), QStringLiteral("soccer"), kWaitMs);
    QVERIFY(desk.run("layout.open balanced blue"));
    QVERIFY(desk.run("robot.select blue1"));
    QTRY_COMPARE_WITH_TIMEOUT(box.currentText(), QStringLiteral("balanced"), kWaitMs);
    QVERIFY(desk.run("robot.select red1"));
    QTRY_COMPARE_WITH_TIMEOUT(box.currentText(), QStringLiteral("soccer"), kWaitMs);
  }

  void theBehaviorIsForcedHeldAndSteppedInTheRunningGame() {
    GameDesk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    QVERIFY(desk.run("simulation.start"));
    QVERIFY(desk.run("robot.select blue1"));
    auto* view = desk.open("behavior");
    auto& graph = child<widgets::OptionCanvas>(*view, "behaviorGraph");
    QAction& force = child<QAction>(*view, "behaviorForceAction");
    QTRY_VERIFY_WITH_TIMEOUT(child<QAction>(*view, "behaviorReleaseAction").isEnabled(), kWaitMs);
    QTRY_VERIFY_WITH_TIMEOUT(!desk.stateOf("game").empty(), kWaitMs);
    // A state in which it is not.
    const auto* known =
        desk.newestAs<robotcontrol::BehaviorGraph>(std::string("blue1/") + robotlink::kBehaviorGraph.name);
    QVERIFY(known != nullptr);
    widgets::BehaviorModel::Place place{0, 0};
    for (const auto& state : known->options(0).states()) {
      if (state.name() != desk.stateOf("game") && state.name() != "playing" && state.name() != "play") break;
      ++place.state;
    }
    const std::string wanted = known->options(0).states(place.state).name();
    QTest::mouseClick(&graph, Qt::LeftButton, {}, graph.stateRect(place).center().toPoint());
    QVERIFY(force.isEnabled());
    force.trigger();
    QTRY_COMPARE_WITH_TIMEOUT(desk.stateOf("game"), wanted, kWaitMs);
    QVERIFY(desk.isForced("game"));
    // Saving the parameters does not save that.
    const std::filesystem::path file = home_ / "saved.textproto";
    QVERIFY(desk.run("parameters.save behavior/soccer " + file.string()));
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(file), kWaitMs);
    QVERIFY(robotlink::readFile(file).value().find("forced") == std::string::npos);
    QVERIFY(robotlink::readFile(file).value().find("skills") != std::string::npos);
    // Held, it stays where it is after the release, until it is stepped.
    QAction& hold = child<QAction>(*view, "behaviorHoldAction");
    QAction& step = child<QAction>(*view, "behaviorStepAction");
    QVERIFY(!step.isEnabled());
    hold.trigger();
    child<QAction>(*view, "behaviorReleaseAction").trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!desk.isForced("game") && step.isEnabled(), kWaitMs);
    const auto released = desk.timeOf(std::string("blue1/") + robotlink::kBehaviorState.name);
    QTRY_VERIFY_WITH_TIMEOUT(desk.timeOf(std::string("blue1/") + robotlink::kBehaviorState.name) >
                                 released + std::chrono::milliseconds(500),
                             kWaitMs);
    QCOMPARE(desk.stateOf("game"), wanted);
    step.trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk.stateOf("game") != wanted, kWaitMs);
    // Another robot is not held; this one is when it is shown again.
    QVERIFY(desk.run("robot.select red1"));
    QTRY_VERIFY_WITH_TIMEOUT(!hold.isChecked() && hold.isEnabled(), kWaitMs);
    QVERIFY(desk.run("robot.select blue1"));
    QTRY_VERIFY_WITH_TIMEOUT(hold.isChecked() && step.isEnabled(), kWaitMs);
    hold.trigger();
  }
};

const widgets::test::GuiTest<GameGuiTest> kGameGuiTest;

}  // namespace app::test

#include "GameGuiTest.moc"
