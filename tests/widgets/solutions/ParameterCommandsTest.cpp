// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterCommands.h"

#include <algorithm>

#include "robotcontrol/Modeling.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/commands/CommandCatalog.h"
#include "tests/TestFolder.h"
#include "tests/widgets/Bench.h"
#include "widgets/solutions/ParameterEdits.h"
#include "widgets/solutions/ParameterSweep.h"

namespace widgets::test {
namespace {

/// Any message with the kinds of fields that parameters have will do as parameters.
robotcontrol::ParameterValues gaitParameters(double speed) {
  robotcontrol::SimulationStatus now, standard;
  now.set_speed(speed);
  standard.set_speed(1);
  now.set_scene("field");
  robotcontrol::ParameterValues values;
  values.set_task("walking");
  values.set_solution("gait");
  values.mutable_value()->set_type("robotcontrol.SimulationStatus");
  values.mutable_value()->set_data(now.SerializeAsString());
  values.mutable_defaults()->set_type("robotcontrol.SimulationStatus");
  values.mutable_defaults()->set_data(standard.SerializeAsString());
  return values;
}

/// A robot with one task, which answers when the test says so.
struct ParameterRobot : Bench {
  ParameterRobot() {
    commands = robotlink::CommandTable(robotlink::commandCatalog());
    attachParameterCommands(commands, edits);
    session.setRefusalHandler([this](const std::string& what, const std::string& reason) {
      refusals.push_back(what + ": " + reason);
    });
    robotcontrol::SolutionTable table;
    auto& task = *table.add_tasks();
    task.set_name("walking");
    task.set_active("gait");
    task.add_solutions()->set_name("gait");
    task.mutable_solutions(0)->set_has_parameters(true);
    task.add_solutions()->set_name("halt");
    push("red1/tables/solutions", table, 1);
    session.tick();
  }
  std::string refusal(const char* line) {
    const auto done = commands.runLine(line);
    return done ? std::string() : done.error().id;
  }
  /// Answers the requests for values that were not answered yet.
  void answerAll(double speed = 2) {
    push("red1/parameters/walking/gait", gaitParameters(speed), ++time);
    const auto asked = std::exchange(requests, {});
    for (const auto& request : asked) {
      if (request.has_get_parameters()) answer(request, true);
    }
    session.tick();
  }
  /// What the last request sets.
  robotcontrol::SimulationStatus sent() {
    robotcontrol::SimulationStatus value;
    if (requests.empty() || !requests.back().has_set_parameters()) qFatal("no parameters were set");
    value.ParseFromString(requests.back().set_parameters().value().data());
    return value;
  }
  /// Answers with a file of this text that the program has read.
  void answerWithFile(const std::string& text, double speed) {
    file = folder.write("walking.gait.textproto", text);
    auto values = gaitParameters(speed);
    values.set_file(file.string());
    push("red1/parameters/walking/gait", values, ++time);
    answer(std::exchange(requests, {}).front(), true);
    session.tick();
  }
  std::string textOfFile() const { return robotlink::readFile(file).value_or("there is none"); }

  const TestFolder folder;
  std::filesystem::path file;
  ParameterEdits edits{session};
  std::vector<std::string> refusals;
  double time = 1;
};

/// A robot that does what it is asked at once, and whose ball is at ten times the speed.
struct SweptRobot : ParameterRobot {
  SweptRobot() {
    attachSweepCommands(commands, sweep);
    session.setRemoteRobots({});
  }
  /// Half a second passes.
  void step() {
    time += 0.5;
    for (const auto& request : std::exchange(requests, {})) {
      if (request.has_set_parameters()) {
        robotcontrol::SimulationStatus set;
        set.ParseFromString(request.set_parameters().value().data());
        speed = set.speed();
        speeds.push_back(speed);
      }
      push("red1/parameters/walking/gait", gaitParameters(speed), time);
      answer(request, true);
    }
    robotcontrol::BallModel ball;
    ball.mutable_position_in_robot()->set_x(10 * speed);
    push("red1/models/ball", ball, time);
    session.tick();
    sweep.tick(robotlink::Instant(robotlink::fromSeconds(time)));
  }
  /// Lets it run to its end.
  void finish() {
    for (int i = 0; i < 200 && sweep.isRunning(); ++i) step();
    QVERIFY(!sweep.isRunning());
  }
  ParameterSweep sweep{commands, session, edits, nullptr};
  double speed = 2;
  std::vector<double> speeds;
};

}  // namespace

class ParameterCommandsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void oneParameterIsSetAndTheOthersStay() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.parameter walking speed 3.5"), std::string());
    QCOMPARE(robot.requests.back().get_parameters().solution(), std::string("gait"));
    robot.answerAll();
    QCOMPARE(robot.sent().speed(), 3.5);
    QCOMPARE(robot.sent().scene(), std::string("field"));
    QCOMPARE(robot.requests.back().set_parameters().task(), std::string("walking"));
    QCOMPARE(robot.requests.back().set_parameters().solution(), std::string("gait"));
  }

  void editsThatAreOnTheirWayTogetherAreAllKept() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.parameter walking/gait speed 3.5"), std::string());
    QCOMPARE(robot.refusal("robot.parameter walking running on"), std::string());
    QCOMPARE(robot.refusal("robot.parameter walking scene 'the hall'"), std::string());
    robot.answerAll();
    QCOMPARE(robot.requests.size(), std::size_t{3});
    QCOMPARE(robot.sent().speed(), 3.5);
    QVERIFY(robot.sent().running());
    QCOMPARE(robot.sent().scene(), std::string("the hall"));
  }

  void aParameterOrAllAreResetToTheirDefaults() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.reset-parameter walking speed"), std::string());
    robot.answerAll(7);
    QCOMPARE(robot.sent().speed(), 1.0);
    QCOMPARE(robot.sent().scene(), std::string("field"));
    QCOMPARE(robot.refusal("robot.reset-parameter walking"), std::string());
    robot.answerAll(7);
    QCOMPARE(robot.sent().scene(), std::string());
  }

  void namesThatTheRobotDoesNotHaveFailAtOnce() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.parameter flying speed 1"), std::string("robot.task-unknown"));
    QCOMPARE(robot.refusal("robot.parameter walking/wings speed 1"), std::string("robot.solution-unknown"));
    QCOMPARE(robot.refusal("robot.parameter walking/halt speed 1"), std::string("robot.parameter-none"));
    QVERIFY(robot.requests.empty());
  }

  void wrongPathsAndValuesAreReportedByTheFirstAnswerAndThenAtOnce() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.parameter walking sped 1"), std::string());
    robot.answerAll();
    QCOMPARE(robot.refusals.size(), std::size_t{1});
    QVERIFY(robot.refusals.front().find("speed") != std::string::npos);
    QVERIFY(robot.requests.empty());
    QCOMPARE(robot.refusal("robot.parameter walking sped 1"), std::string("robot.parameter-unknown"));
    QCOMPARE(robot.refusal("robot.parameter walking speed fast"), std::string("robot.parameter-value"));
    QCOMPARE(robot.refusal("robot.parameter walking running maybe"), std::string("robot.parameter-value"));
  }

  void whatTheRobotRefusesIsReported() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.parameter walking speed 3"), std::string());
    robot.answer(false, "the process has failed");
    robot.session.tick();
    QCOMPARE(robot.refusals, std::vector<std::string>{"parameter speed of walking: the process has failed"});
  }

  void whatWasChangedIsSavedAndTheProgramIsTold() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("parameters.save walking"), std::string());
    robot.answerWithFile("# Slow.\nspeed: 1  # m/s\n", 3.5);
    QCOMPARE(robot.textOfFile(), std::string("# Slow.\nspeed: 3.5  # m/s\nscene: \"field\"\n"));
    QVERIFY(robot.requests.back().set_parameters().saved());
    QCOMPARE(robot.sent().speed(), 3.5);
  }

  void allAreSavedToTheirOwnFilesOnly() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("parameters.save '' a.textproto"), std::string("parameters.file"));
    QCOMPARE(robot.refusal("parameters.save"), std::string());
    QCOMPARE(robot.requests.size(), std::size_t{1});
    robot.answerWithFile("", 3.5);
    QCOMPARE(robot.textOfFile(), std::string("speed: 3.5\nscene: \"field\"\n"));
  }

  void aFileThatCannotBeUsedIsReportedAndStays() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("parameters.save walking"), std::string());
    robot.answerWithFile("speed: fast\n", 3.5);
    QCOMPARE(robot.textOfFile(), std::string("speed: fast\n"));
    QCOMPARE(robot.refusals.size(), std::size_t{1});
    QVERIFY(robot.refusals.front().find("walking.gait.textproto:1:") != std::string::npos);
    QVERIFY(robot.requests.empty());
  }

  void parametersOfARobotElsewhereAreSavedToAFileHere() {
    ParameterRobot robot;
    robot.session.setRemoteRobots({{"red1", {.url = "ws://far:8765"}}});
    QCOMPARE(robot.refusal("parameters.save walking"), std::string());
    robot.answerWithFile("speed: 1\n", 3.5);
    QVERIFY(robot.refusals.front().find("ws://far:8765") != std::string::npos);
    QCOMPARE(robot.textOfFile(), std::string("speed: 1\n"));
    const auto here = robot.folder / "here.textproto";
    QCOMPARE(robot.refusal(("parameters.save walking " + here.string()).c_str()), std::string());
    robot.answerAll(3.5);
    QCOMPARE(robotlink::readFile(here).value_or(""), std::string("speed: 3.5\nscene: \"field\"\n"));
    QVERIFY(robot.requests.empty());
  }

  void allParametersAreReset() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("parameters.reset"), std::string());
    robot.answerAll(7);
    QCOMPARE(robot.sent().speed(), 1.0);
    QCOMPARE(robot.sent().scene(), std::string());
  }

  void pathsOfParametersAreOffered() {
    ParameterRobot robot;
    QCOMPARE(robot.refusal("robot.parameter walking speed 3"), std::string());
    robot.answerAll();
    const auto paths = robot.commands.find("robot.parameter")->offer({"walking"});
    QVERIFY(std::ranges::find(paths, "speed") != paths.end());
  }

  void aSweepMeasuresAFigureAtEachValue() {
    SweptRobot robot;
    robot.step();
    const auto file = robot.folder / "sweep.csv";
    const std::string line = "parameters.sweep walking speed 1:2:0.5 'models/ball.position_in_robot.x' 1 ";
    QCOMPARE(robot.refusal((line + file.string()).c_str()), std::string());
    QVERIFY(robot.sweep.working().value());
    QCOMPARE(robot.refusal((line + file.string()).c_str()), std::string("sweep.running"));
    robot.finish();
    QVERIFY(!robot.sweep.working().value());
    QCOMPARE(robot.speeds, (std::vector<double>{1, 1.5, 2, 2}));
    const auto& rows = robot.sweep.rows();
    QCOMPARE(rows.size(), std::size_t{3});
    QCOMPARE(rows[1].value, std::string("1.5"));
    QCOMPARE(rows[1].mean, 15.0);
    QCOMPARE(rows[1].count, std::size_t{2});  // two halves of the second that was asked for
    QVERIFY(robotlink::readFile(file).value_or("").find("\n1.5," + std::to_string(rows[1].count) +
                                                        ",15,0,15,15\n") != std::string::npos);
  }

  void aSweepThatFailsOrIsStoppedGivesTheFormerValueBack() {
    SweptRobot robot;
    robot.step();
    QCOMPARE(robot.refusal("parameters.sweep walking speed 5,6 models/pose.robot_in_field.x 1"),
             std::string());
    robot.finish();
    QCOMPARE(robot.sweep.working().error().id, std::string("sweep.nothing"));
    QCOMPARE(robot.speeds, (std::vector<double>{5, 2}));
    robot.speeds.clear();
    QCOMPARE(robot.refusal("parameters.sweep walking speed 5,6 simulation.time 1"), std::string());
    robot.step();
    robot.step();
    QCOMPARE(robot.refusal("parameters.stop-sweep"), std::string());
    robot.finish();
    QCOMPARE(robot.speeds.back(), 2.0);
    QVERIFY(robot.sweep.rows().size() < 2);
    QVERIFY(robot.sweep.working().has_value());
  }

  void aPlanThatCannotBeFailsAtOnce() {
    SweptRobot robot;
    QCOMPARE(robot.refusal("parameters.sweep flying speed 1 simulation.time 1"),
             std::string("robot.task-unknown"));
    QCOMPARE(robot.refusal("parameters.sweep walking speed 1 'a b' 1"), std::string("expression.syntax"));
    for (const char* values : {"''", "1,,2", "1:2", "1:2:0", "2:1:1", "1:2:x", "0:1:1e-9"}) {
      const std::string line = std::string("parameters.sweep walking speed ") + values + " simulation.time 1";
      QCOMPARE(robot.refusal(line.c_str()), std::string("sweep.values"));
    }
    QCOMPARE(ParameterSweep::valuesIn("0.1:0.3:0.1").value(),
             (std::vector<std::string>{"0.1", "0.2", "0.3"}));
    QCOMPARE(ParameterSweep::valuesIn("3:1:-1").value(), (std::vector<std::string>{"3", "2", "1"}));
    QCOMPARE(ParameterSweep::valuesIn("on,off").value(), (std::vector<std::string>{"on", "off"}));
    QVERIFY(!robot.sweep.isRunning());
  }

  void tasksAndSolutionsWithParametersAreOffered() {
    ParameterRobot robot;
    QCOMPARE(robot.commands.find("robot.parameter")->offer({}),
             (std::vector<std::string>{"walking/gait", "walking"}));
  }
};

const GuiTest<ParameterCommandsTest> kParameterCommandsTest;

}  // namespace widgets::test

#include "ParameterCommandsTest.moc"
