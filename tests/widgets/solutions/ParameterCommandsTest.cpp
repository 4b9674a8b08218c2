// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterCommands.h"

#include "robotlink/commands/CommandCatalog.h"
#include "tests/widgets/Bench.h"
#include "widgets/solutions/ParameterEdits.h"

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
  ParameterEdits edits{session};
  std::vector<std::string> refusals;
  double time = 1;
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

  void tasksAndSolutionsWithParametersAreOffered() {
    ParameterRobot robot;
    QCOMPARE(robot.commands.find("robot.parameter")->offer(0),
             (std::vector<std::string>{"walking/gait", "walking"}));
  }
};

const GuiTest<ParameterCommandsTest> kParameterCommandsTest;

}  // namespace widgets::test

#include "ParameterCommandsTest.moc"
