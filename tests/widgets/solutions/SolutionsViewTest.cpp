// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/SolutionsView.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QSlider>
#include <QToolButton>
#include <QTreeView>

#include "robotcontrol/World.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/widgets/Bench.h"
#include "widgets/solutions/ParameterPanel.h"
#include "widgets/solutions/SolutionModel.h"

namespace widgets::test {

using robotcontrol::SolutionTable;

namespace {

SolutionTable someTasks(const std::string& active = "scan-lines") {
  SolutionTable table;
  auto& task = *table.add_tasks();
  task.set_name("ball-percept");
  task.set_process("cognition");
  task.set_active(active);
  task.set_default_solution("scan-lines");
  auto add = [&](const char* name, const char* help, const char* unavailable) {
    auto& solution = *task.add_solutions();
    solution.set_name(name);
    solution.set_help(help);
    solution.set_unavailable(unavailable);
    solution.set_has_parameters(true);
  };
  add("scan-lines", "Fits a circle to the ball's edge", "");
  add("regions", "Takes the largest orange region", "");
  add("oracle", "Looks the ball up",
      "unavailable because neither the robot nor another task provides the simulator's ground truth "
      "(oracle/world)");
  return table;
}

/// Any message with the kinds of fields that parameters have will do as parameters.
robotcontrol::ParameterValues someParameters(double speed, double standard) {
  robotcontrol::SimulationStatus now, defaults;
  now.set_speed(speed);
  now.set_running(true);
  now.set_steps(7);
  now.set_scene("field");
  defaults = now;
  defaults.set_speed(standard);
  robotcontrol::ParameterValues values;
  values.set_task("ball-percept");
  values.set_solution("scan-lines");
  values.mutable_value()->set_type("robotcontrol.SimulationStatus");
  values.mutable_value()->set_data(now.SerializeAsString());
  values.mutable_defaults()->set_type("robotcontrol.SimulationStatus");
  values.mutable_defaults()->set_data(defaults.SerializeAsString());
  return values;
}

robotcontrol::SimulationStatus sentParameters(const robotcontrol::Request& request) {
  robotcontrol::SimulationStatus sent;
  sent.ParseFromString(request.set_parameters().value().data());
  return sent;
}

/// The same with limits and what is built in, from a file.
robotcontrol::ParameterValues parametersIn(const std::filesystem::path& file, double speed,
                                           double standard = 1) {
  auto values = someParameters(speed, standard);
  values.set_file(file.string());
  robotcontrol::SimulationStatus builtIn;
  builtIn.set_speed(0.5);
  values.mutable_built_in()->set_data(builtIn.SerializeAsString());
  auto& limits = *values.add_limits();
  limits.set_path("speed");
  limits.set_maximum(4);
  return values;
}

/// Shows parameters in the panel of a view.
QTreeView& openParameters(Bench& bench, widgets::SolutionsView& view,
                          const robotcontrol::ParameterValues& values) {
  bench.push("red1/tables/solutions", someTasks(), 1);
  bench.tick(view);
  click(child<QToolButton>(view, "solutionsParameters"));
  auto& tree = child<QTreeView>(view, "solutionsTree");
  clickCell(tree, find(tree, QStringLiteral("scan-lines")));
  bench.push("red1/parameters/ball-percept/scan-lines", values, 2);
  bench.tick(view);
  return child<QTreeView>(view, "parametersTree");
}

}  // namespace

class SolutionsViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whyThereIsNothingToChooseIsSaid() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.tick(*view);
    const auto hint = [&] {
      return child<QLabel>(child<QTreeView>(*view, "solutionsTree"), "emptyHint").text();
    };
    QVERIFY(hint().contains(QStringLiteral("not reported its tasks")));
    robotlink::RemoteRobot remote;
    remote.isForeign = true;
    bench.session.setRemoteRobots({{"red1", remote}});
    bench.tick(*view);
    QVERIFY(hint().contains(QStringLiteral("red1 has no solutions")));
  }

  void whatSolutionsCostIsShownOnceTheRobotMeasures() {
    Bench bench({.answers = true});
    auto view = bench.open<widgets::SolutionsView>();
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    QAbstractItemModelTester tester(tree.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    robotcontrol::KeyTable keys;
    keys.add_keys()->set_name("timing/tasks");
    keys.mutable_keys(0)->mutable_mode()->set_kind(robotcontrol::KeyMode::OFF);
    bench.push("red1/tables/keys", keys, 1);
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    const auto cost = [&](const char* name) {
      return find(tree, QString::fromLatin1(name), SolutionModel::kCost).data().toString();
    };
    QCOMPARE(cost("regions"), QString());
    QVERIFY(tree.model()->setData(find(tree, QStringLiteral("regions"), SolutionModel::kShadow), Qt::Checked,
                                  Qt::CheckStateRole));
    bench.tick(*view);
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QCOMPARE(bench.requests[0].set_key().name(), std::string("shadow/ball-percept/regions"));
    QCOMPARE(bench.requests[1].set_key().name(), std::string("timing/tasks"));
    for (int frame = 0; frame < 50; ++frame) {
      robotcontrol::StopwatchTimes times;
      const auto add = [&](const char* solution, double seconds) {
        auto& entry = *times.add_entries();
        entry.set_task("ball-percept");
        entry.set_solution(solution);
        entry.set_seconds(seconds);
      };
      add("scan-lines", frame < 25 ? 0.001 : 0.003);
      add("regions (shadow)", 0.00004);
      bench.push("red1/stopwatches/cognition", times, 1 + 0.04 * frame);
      // Its times are published after each third frame.
      robotcontrol::FrameInfo info;
      info.set_number(1 + 3 * static_cast<std::uint64_t>(frame));
      bench.push("red1/frames/cognition", info, 1 + 0.04 * frame);
    }
    for (int i = 0; i < 20; ++i) bench.tick(*view);
    QCOMPARE(cost("scan-lines"), QStringLiteral("2.00 ms, 15.0 %"));
    QCOMPARE(cost("regions"), QStringLiteral("40 µs, 0.3 %"));
    QCOMPARE(cost("oracle"), QString());
    QCOMPARE(cost("ball-percept"), QString());
  }

  void oneClickSwitchesAndTheSwitchIsPendingUntilTheRobotConfirms() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    QAbstractItemModelTester tester(tree.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    QCOMPARE(find(tree, QStringLiteral("ball-percept"), SolutionModel::kProcess).data().toString(),
             QStringLiteral("cognition"));
    QCOMPARE(find(tree, QStringLiteral("ball-percept"), SolutionModel::kState).data().toString(),
             QStringLiteral("scan-lines"));
    clickCell(tree, find(tree, QStringLiteral("regions")));
    const auto& request = bench.requests.back();
    QCOMPARE(request.select_solution().task(), std::string("ball-percept"));
    QCOMPARE(request.select_solution().solution(), std::string("regions"));
    QCOMPARE(find(tree, QStringLiteral("regions"), SolutionModel::kState).data().toString(),
             QStringLiteral("switching…"));
    bench.push("red1/tables/solutions", someTasks("regions"), 2);
    bench.tick(*view);
    QCOMPARE(find(tree, QStringLiteral("ball-percept"), SolutionModel::kState).data().toString(),
             QStringLiteral("regions"));
    QCOMPARE(find(tree, QStringLiteral("regions"), SolutionModel::kState).data().toString(),
             QStringLiteral("Takes the largest orange region"));
  }

  void whatIsUnavailableSaysWhyAndIsNotRequested() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    const QModelIndex oracle = find(tree, QStringLiteral("oracle"));
    QVERIFY(
        oracle.siblingAtColumn(SolutionModel::kState)
            .data()
            .toString()
            .contains(QStringLiteral(
                "neither the robot nor another task provides the simulator's ground truth (oracle/world)")));
    QVERIFY(oracle.data(Qt::ToolTipRole).toString().contains(QStringLiteral("another task provides")));
    clickCell(tree, oracle);
    for (const auto& request : bench.requests) QVERIFY(!request.has_select_solution());
    QVERIFY(child<QLabel>(*view, "solutionsState").text().contains(QStringLiteral("another task provides")));
  }

  void aRefusalIsShownInItsRowWithItsReason() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    clickCell(tree, find(tree, QStringLiteral("regions")));
    bench.answer(false, "its parameters cannot be read");
    bench.tick(*view);
    QCOMPARE(find(tree, QStringLiteral("regions"), SolutionModel::kState).data().toString(),
             QStringLiteral("refused: its parameters cannot be read"));
    QVERIFY(child<QLabel>(*view, "solutionsState").text().contains(QStringLiteral("refused")));
  }

  void whatOneRobotRefusedIsNotShownAtAnother() {
    Bench bench;
    bench.session.setRobots({"red1", "red2"});
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.push("red2/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    const auto state = [&] {
      return find(tree, QStringLiteral("regions"), SolutionModel::kState).data().toString();
    };
    clickCell(tree, find(tree, QStringLiteral("regions")));
    const auto asked = bench.requests.back();
    bench.session.selectRobot("red2");
    bench.tick(*view);
    QCOMPARE(state(), QStringLiteral("Takes the largest orange region"));
    bench.answer(asked, false, "its parameters cannot be read");
    bench.tick(*view);
    QCOMPARE(state(), QStringLiteral("Takes the largest orange region"));
  }

  void oneClickSwitchesATaskInAllRobots() {
    Bench bench;
    bench.session.setRobots({"red1", "red2", "blue1"});
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    auto& inAll = child<QAction>(*view, "solutionsInAllRobotsAction");
    tree.setCurrentIndex(find(tree, QStringLiteral("ball-percept")));
    bench.tick(*view);
    QVERIFY2(!inAll.isEnabled(), "a task is no solution");
    tree.setCurrentIndex(find(tree, QStringLiteral("regions")));
    bench.tick(*view);
    QVERIFY(inAll.isEnabled());
    bench.requests.clear();
    inAll.trigger();
    QCOMPARE(bench.requests.size(), std::size_t{3});
    for (const auto& request : bench.requests)
      QCOMPARE(request.select_solution().solution(), std::string("regions"));
    QCOMPARE(bench.requests[0].robot(), std::string("red1"));
    QCOMPARE(bench.requests[2].robot(), std::string("blue1"));
    bench.answer(false, "it has no camera");
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "solutionsState").text().contains(QStringLiteral("blue1")));
  }

  void oneClickSwitchesATaskInTheTeam() {
    Bench bench;
    bench.session.setRobots({"red1", "red2", "blue1"});
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    auto& inTeam = child<QAction>(*view, "solutionsInTeamAction");
    tree.setCurrentIndex(find(tree, QStringLiteral("regions")));
    bench.tick(*view);
    QVERIFY2(!inTeam.isEnabled(), "nothing says that it is of a team");
    robotcontrol::WorldObjects objects;
    for (const auto& [name, team] :
         {std::pair("red1", "a"), std::pair("red2", "b"), std::pair("blue1", "a")}) {
      auto& robot = *objects.add_objects();
      robot.set_path(name);
      robot.add_properties()->set_name("team");
      robot.mutable_properties(0)->set_text(team);
    }
    bench.push("objects", objects, 1);
    bench.tick(*view);
    QVERIFY(inTeam.isEnabled());
    bench.requests.clear();
    inTeam.trigger();
    QCOMPARE(bench.requests.size(), std::size_t{2});
    QCOMPARE(bench.requests[0].robot(), std::string("red1"));
    QCOMPARE(bench.requests[1].robot(), std::string("blue1"));
    QCOMPARE(bench.requests[1].select_solution().solution(), std::string("regions"));
  }

  void defaultsSwitchesOnlyWhatIsNotDefault() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks("regions"), 1);
    bench.tick(*view);
    bench.requests.clear();
    click(child<QToolButton>(*view, "solutionsDefaults"));
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].select_solution().solution(), std::string("scan-lines"));
  }

  void aParameterIsSetOnEnterAndCanBeUndoneAndReset() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    clickCell(tree, find(tree, QStringLiteral("scan-lines")));
    QVERIFY2(bench.requests.empty(), "nothing is asked for before somebody looks");
    click(child<QToolButton>(*view, "solutionsParameters"));
    QCOMPARE(bench.requests.back().get_parameters().solution(), std::string("scan-lines"));
    bench.push("red1/parameters/ball-percept/scan-lines", someParameters(2, 1), 2);
    bench.tick(*view);
    auto& fields = child<QTreeView>(*view, "parametersTree");
    QAbstractItemModelTester tester(fields.model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    QCOMPARE(find(fields, QStringLiteral("speed"), 1).data().toString(), QStringLiteral("2"));
    QCOMPARE(find(fields, QStringLiteral("speed"), 2).data().toString(), QStringLiteral("1"));

    clickCell(fields, find(fields, QStringLiteral("speed"), 1));
    auto& editor = child<QLineEdit>(fields, "parameterEditor");
    QTest::keyClicks(&editor, QStringLiteral("0.25"));
    QTest::keyClick(&editor, Qt::Key_Return);
    QCoreApplication::processEvents();  // item views commit from the event loop
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 0.25);
    QCOMPARE(sentParameters(bench.requests.back()).steps(), std::uint64_t{7});
    click(child<QToolButton>(*view, "parametersUndo"));
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 2.0);
    click(child<QToolButton>(*view, "parametersRedo"));
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 0.25);
    QVERIFY2(!view->parameters().redo(), "there is nothing more");
    QVERIFY(view->parameters().undo());
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 2.0);
    QVERIFY(view->parameters().redo());
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 0.25);
    click(child<QToolButton>(*view, "parametersResetAll"));
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 1.0);
  }

  void whatWasTunedIsShownAndSavedToItsFile() {
    const TestFolder folder;
    const auto file = folder.write("ball-percept.scan-lines.textproto", "speed: 1 # slow\n");
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    auto& fields = openParameters(bench, *view, parametersIn(file, 2));
    const QModelIndex speed = find(fields, QStringLiteral("speed"), 1);
    QVERIFY(speed.data(Qt::ToolTipRole).toString().contains(QStringLiteral("changed from 1")));
    QVERIFY(speed.data(Qt::ToolTipRole).toString().contains(QStringLiteral("between 0 and 4")));
    QVERIFY(speed.data(Qt::BackgroundRole).isValid());
    QCOMPARE(find(fields, QStringLiteral("speed"), 3).data().toString(), QStringLiteral("0.5"));
    keepPicture(*view, "parameters-tuned");
    click(child<QToolButton>(*view, "parametersSave"));
    QCOMPARE(robotlink::readFile(file).value_or(""), std::string("speed: 2 # slow\n"));
    QVERIFY(bench.requests.back().set_parameters().saved());
    bench.answer(true);
    bench.push("red1/parameters/ball-percept/scan-lines", parametersIn(file, 2, 2), 3);
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "parametersState").text().contains(QStringLiteral("Saved")));
    QVERIFY(!child<QToolButton>(*view, "parametersSave").isEnabled());
    QCOMPARE(find(fields, QStringLiteral("speed"), 2).data().toString(), QStringLiteral("2"));
  }

  void aSliderSetsANumberBetweenItsLimits() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    auto& fields = openParameters(bench, *view, parametersIn({}, 2));
    auto& slider = child<QSlider>(*view, "parameterSlider");
    QVERIFY(!slider.isVisible());
    fields.setCurrentIndex(find(fields, QStringLiteral("speed")));
    QVERIFY(slider.isVisible());
    QCOMPARE(slider.value() * 2, slider.maximum());
    QTest::keyClick(&slider, Qt::Key_End);
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 4.0);
    click(child<QToolButton>(*view, "parametersUndo"));
    QCOMPARE(slider.value() * 2, slider.maximum());
    fields.setCurrentIndex(find(fields, QStringLiteral("running")));
    QVERIFY(!slider.isVisible());
  }

  void theCurrentParameterIsResetAndAllAreReadAgain() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    click(child<QToolButton>(*view, "solutionsParameters"));
    clickCell(child<QTreeView>(*view, "solutionsTree"),
              find(child<QTreeView>(*view, "solutionsTree"), QStringLiteral("scan-lines")));
    bench.push("red1/parameters/ball-percept/scan-lines", someParameters(2, 1), 2);
    bench.tick(*view);
    bench.requests.clear();
    auto& fields = child<QTreeView>(*view, "parametersTree");
    clickCell(fields, find(fields, QStringLiteral("speed")));
    click(child<QToolButton>(*view, "parametersReset"));
    QCOMPARE(sentParameters(bench.requests.back()).speed(), 1.0);
    QCOMPARE(sentParameters(bench.requests.back()).steps(), std::uint64_t{7});
    click(child<QToolButton>(*view, "parametersRefresh"));
    QCOMPARE(bench.requests.back().get_parameters().task(), std::string("ball-percept"));
    QCOMPARE(bench.requests.back().get_parameters().solution(), std::string("scan-lines"));
  }

  void theKeyboardChooses() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    tree.setCurrentIndex(find(tree, QStringLiteral("regions")));
    QTest::keyClick(&tree, Qt::Key_Space);
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests[0].select_solution().solution(), std::string("regions"));
  }

  void aTextThatIsNoNumberChangesNothing() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    click(child<QToolButton>(*view, "solutionsParameters"));
    clickCell(child<QTreeView>(*view, "solutionsTree"),
              find(child<QTreeView>(*view, "solutionsTree"), QStringLiteral("scan-lines")));
    bench.push("red1/parameters/ball-percept/scan-lines", someParameters(2, 1), 2);
    bench.tick(*view);
    bench.requests.clear();
    auto& fields = child<QTreeView>(*view, "parametersTree");
    const QModelIndex steps = find(fields, QStringLiteral("steps"), 1);
    QVERIFY(!fields.model()->setData(steps, QStringLiteral("many")));
    QVERIFY(!fields.model()->setData(steps, QStringLiteral("-1")));
    QVERIFY(bench.requests.empty());
    QVERIFY(fields.model()->setData(find(fields, QStringLiteral("running"), 1), Qt::Unchecked,
                                    Qt::CheckStateRole));
    QCOMPARE(sentParameters(bench.requests.back()).running(), false);
  }

  void parametersThatAreRefusedAreTakenBack() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    click(child<QToolButton>(*view, "solutionsParameters"));
    clickCell(child<QTreeView>(*view, "solutionsTree"),
              find(child<QTreeView>(*view, "solutionsTree"), QStringLiteral("scan-lines")));
    bench.push("red1/parameters/ball-percept/scan-lines", someParameters(2, 1), 2);
    bench.tick(*view);
    auto& fields = child<QTreeView>(*view, "parametersTree");
    fields.model()->setData(find(fields, QStringLiteral("speed"), 1), QStringLiteral("-3"));
    bench.answer(false, "speed must not be negative");
    bench.tick(*view);
    QCOMPARE(find(fields, QStringLiteral("speed"), 1).data().toString(), QStringLiteral("2"));
    QVERIFY(child<QLabel>(*view, "parametersState").text().contains(QStringLiteral("must not be negative")));
  }

  void aRefusalThatComesLateChangesNothingOfWhatIsShownThen() {
    Bench bench;
    auto view = bench.open<widgets::SolutionsView>();
    bench.push("red1/tables/solutions", someTasks(), 1);
    bench.tick(*view);
    click(child<QToolButton>(*view, "solutionsParameters"));
    auto& tree = child<QTreeView>(*view, "solutionsTree");
    clickCell(tree, find(tree, QStringLiteral("scan-lines")));
    bench.push("red1/parameters/ball-percept/scan-lines", someParameters(2, 1), 2);
    bench.tick(*view);
    auto& fields = child<QTreeView>(*view, "parametersTree");
    fields.model()->setData(find(fields, QStringLiteral("speed"), 1), QStringLiteral("-3"));
    const auto asked = bench.requests.back();
    clickCell(tree, find(tree, QStringLiteral("regions")));
    auto others = someParameters(5, 1);
    others.set_solution("regions");
    bench.push("red1/parameters/ball-percept/regions", others, 3);
    bench.tick(*view);
    QCOMPARE(find(fields, QStringLiteral("speed"), 1).data().toString(), QStringLiteral("5"));
    bench.answer(asked, false, "speed must not be negative");
    bench.tick(*view);
    QCOMPARE(find(fields, QStringLiteral("speed"), 1).data().toString(), QStringLiteral("5"));
    QVERIFY(child<QLabel>(*view, "parametersState")
                .text()
                .contains(QStringLiteral("of scan-lines were refused")));
  }
};

const GuiTest<SolutionsViewTest> kSolutionsViewTest;

}  // namespace widgets::test

#include "SolutionsViewTest.moc"
