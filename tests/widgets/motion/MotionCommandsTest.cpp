// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionCommands.h"

#include <QComboBox>
#include <QToolButton>

#include "robotcontrol/Linking.pb.h"
#include "robotlink/commands/CommandCatalog.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/widgets/Bench.h"
#include "widgets/motion/MotionView.h"
#include "widgets/motion/WalkPad.h"

namespace widgets::test {

using robotcontrol::HeadMode;
using robotcontrol::MotionRequest;

namespace {

/// The table of a robot whose behavior can obey.
robotcontrol::SolutionTable behaviorWith(const std::string& active) {
  robotcontrol::SolutionTable table;
  auto& task = *table.add_tasks();
  task.set_name("behavior");
  task.set_active(active);
  task.add_solutions()->set_name("go-to-ball");
  task.add_solutions()->set_name("obey");
  return table;
}

/// Commands without any view.
struct CommandedRobot : Bench {
  CommandedRobot() {
    commands = robotlink::CommandTable(robotlink::commandCatalog());
    attachMotionCommands(context);
    show("go-to-ball");
  }
  void show(const std::string& active) {
    push("red1/tables/solutions", behaviorWith(active), ++time);
    step();
  }
  void step() {
    session.tick();
    context.steering->tick();
  }
  /// Whether motions are sent within a second.
  bool sends() {
    requests.clear();
    for (int i = 0; i < 30; ++i) step();
    return std::any_of(requests.begin(), requests.end(),
                       [](const auto& request) { return request.has_motion(); });
  }
  /// As a remote robot says who steers it; an empty name: nobody.
  void showSteering(const std::string& who, bool own) {
    robotcontrol::SteeringStatus status;
    status.set_who(who);
    status.set_client(who.empty() ? 0 : 1);
    status.set_own(own);
    push("red1/steering", status, ++time);
  }
  std::string refusal(const char* line) {
    const auto done = commands.runLine(line);
    return done ? std::string() : done.error().id;
  }
  void takeOver() {
    QCOMPARE(refusal("robot.take-over"), std::string());
    show("obey");
  }
  /// The last command; fails if there was none.
  robotcontrol::RemoteMotion motion() {
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
      if (request->has_motion()) return request->motion();
    }
    qFatal("no motion was commanded");
  }
  double time = 0;
};

}  // namespace

class MotionCommandsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aRobotIsTakenOverWalksStandsAndIsGivenBackWithoutAView() {
    CommandedRobot bench;
    bench.takeOver();
    QCOMPARE(bench.requests.front().select_solution().solution(), std::string("obey"));
    QCOMPARE(bench.refusal("robot.walk 0.3 -0.1 0.5"), std::string());
    bench.step();
    QCOMPARE(bench.motion().motion().walk().x(), 0.3);
    QCOMPARE(bench.motion().motion().walk().y(), -0.1);
    QCOMPARE(bench.motion().motion().walk().rotation(), 0.5);
    bench.requests.clear();
    for (int i = 0; i < 30; ++i) bench.step();
    QCOMPARE(bench.requests.size(), std::size_t{10});  // it is told again, or it would stop
    QCOMPARE(bench.refusal("robot.stand"), std::string());
    bench.step();
    QCOMPARE(bench.motion().motion().kind(), MotionRequest::STAND);
    QCOMPARE(bench.refusal("robot.take-over off"), std::string());
    QCOMPARE(bench.requests.back().select_solution().solution(), std::string("go-to-ball"));
  }

  void whatIsCommandedWhileTheRobotSwitchesBeginsAsSoonAsItObeys() {
    CommandedRobot bench;
    QCOMPARE(bench.refusal("robot.take-over on"), std::string());
    QCOMPARE(bench.refusal("robot.walk 0.1"), std::string());
    bench.step();
    for (const auto& request : bench.requests) QVERIFY(!request.has_motion());
    bench.show("obey");
    QCOMPARE(bench.motion().motion().walk().x(), 0.1);
  }

  void aRefusalIsReportedAndForgetsWhatWasCommanded() {
    CommandedRobot bench;
    std::string refused;
    bench.session.setRefusalHandler([&](const std::string&, const std::string& reason) { refused = reason; });
    QCOMPARE(bench.refusal("robot.take-over"), std::string());
    QCOMPARE(bench.refusal("robot.walk 0.1"), std::string());
    for (const auto& request : bench.requests) {
      if (request.has_select_solution()) bench.answer(request, false, "the process has failed");
    }
    bench.step();
    QCOMPARE(refused, std::string("the process has failed"));
    bench.takeOver();
    QCOMPARE(bench.motion().motion().kind(), MotionRequest::STAND);
  }

  void withoutManualControlNothingIsCommanded() {
    CommandedRobot bench;
    for (const char* line : {"robot.walk 1", "robot.stand", "robot.head search-ball", "robot.motion get-up",
                             "robot.head-joint pan 0.1"}) {
      QCOMPARE(bench.refusal(line), std::string("robot.not-taken"));
    }
    bench.session.setRobots({});
    QCOMPARE(bench.refusal("robot.walk 1"), std::string("robot.none"));
    QCOMPARE(bench.refusal("robot.take-over"), std::string("robot.none"));
  }

  void headAndMotionsAreCommandedByTheirNames() {
    CommandedRobot bench;
    bench.takeOver();
    QCOMPARE(bench.refusal("robot.head search-ball"), std::string());
    bench.step();
    QCOMPARE(bench.motion().head().kind(), HeadMode::SEARCH_BALL);
    QCOMPARE(bench.refusal("robot.head-joint pan 0.5"), std::string());
    QCOMPARE(bench.refusal("robot.head-joint tilt -0.25"), std::string());
    bench.step();
    QCOMPARE(bench.motion().head().kind(), HeadMode::ANGLES);
    QCOMPARE(bench.motion().head().pan(), 0.5);
    QCOMPARE(bench.motion().head().tilt(), -0.25);
    QCOMPARE(bench.refusal("robot.motion fly"), std::string("robot.motion"));
    QCOMPARE(bench.refusal("robot.motion get-up"), std::string());
    bench.step();
    QCOMPARE(bench.motion().motion().kind(), MotionRequest::GET_UP);
  }

  void aJointThatTheRobotLacksOrAnAngleBeyondItsLimitsIsRefused() {
    CommandedRobot bench;
    auto robot = std::make_shared<robotlink::RobotDescription>();
    robot->joints.push_back({"headPan", -1, 1});
    bench.context.robots["red1"] = robot;
    bench.takeOver();
    QCOMPARE(bench.refusal("robot.head-joint mouth 0"), std::string("robot.head-joint"));
    QCOMPARE(bench.refusal("robot.head-joint pan 1.5"), std::string("robot.head-joint"));
    QCOMPARE(bench.refusal("robot.head-joint pan 0.9"), std::string());
  }

  void anotherRobotIsNotSteeredAndTheFormerOneStands() {
    CommandedRobot bench;
    bench.takeOver();
    QCOMPARE(bench.refusal("robot.walk 0.3"), std::string());
    bench.step();
    bench.requests.clear();
    bench.session.selectRobot("blue1");
    for (int i = 0; i < 30; ++i) bench.step();
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests.front().robot(), std::string("red1"));
    QCOMPARE(bench.motion().motion().kind(), MotionRequest::STAND);
  }

  void aRobotElsewhereThatObeysIsLeftAloneUntilItIsCommandedHere() {
    CommandedRobot bench;
    bench.session.setRemoteRobots({{"red1", {"ws://10.0.0.1:8765", true}}});
    bench.show("obey");
    QVERIFY(!bench.sends());
    QCOMPARE(bench.refusal("robot.stand"), std::string());
    QVERIFY(bench.sends());
    // After somebody else has steered it, it waits for a new command.
    bench.showSteering("Anna", false);
    QVERIFY(!bench.sends());
    bench.showSteering("", false);
    QVERIFY(!bench.sends());
    bench.showSteering("RobotControl", true);
    QVERIFY(bench.sends());
    bench.showSteering("", false);
    QVERIFY(!bench.sends());
    QCOMPARE(bench.refusal("robot.take-over on"), std::string());
    QVERIFY(bench.sends());
    bench.session.selectRobot("blue1");
    bench.step();
    bench.session.selectRobot("red1");
    QVERIFY(!bench.sends());
  }

  void takingOverARobotElsewhereIsSaidBeforeTheFirstMotion() {
    CommandedRobot bench;
    std::vector<std::string> steered;
    bench.commands.attach("robot.steer", [&](const auto& values) -> robotlink::Result<void> {
      steered.push_back(std::get<std::string>(values[0]) + (std::get<bool>(values[1]) ? " on" : " off"));
      return {};
    });
    bench.takeOver();
    QVERIFY(steered.empty());  // it is here
    bench.session.setRemoteRobots({{"red1", {"ws://10.0.0.1:8765", true}}});
    bench.takeOver();
    QCOMPARE(steered, std::vector<std::string>{"red1 on"});
    bench.showSteering("RobotControl", true);
    bench.step();
    bench.takeOver();
    QCOMPARE(steered.size(), std::size_t{1});  // it is said already
    // Somebody else is not displaced by that.
    bench.showSteering("Anna", false);
    bench.step();
    bench.takeOver();
    QCOMPARE(steered.size(), std::size_t{1});
    bench.showSteering("", false);
    bench.step();
    bench.takeOver();
    QCOMPARE(steered.size(), std::size_t{2});
  }

  void viewAndCommandsSteerTogether() {
    CommandedRobot bench;
    auto view = bench.open<MotionView>({760, 560});
    view->setGamepad([] { return Gamepad::State(); });
    bench.takeOver();
    bench.tick(*view);
    QVERIFY(child<QToolButton>(*view, "motionTakeOver").isChecked());
    QCOMPARE(bench.refusal("robot.walk 0.3"), std::string());
    QCOMPARE(bench.refusal("robot.head track-ball"), std::string());
    for (int i = 0; i < 3; ++i) bench.tick(*view);
    QCOMPARE(bench.motion().motion().walk().x(), 0.3);
    QCOMPARE(child<QComboBox>(*view, "headMode").currentIndex(), 2);
    auto& pad = child<WalkPad>(*view, "walkPad");
    QTest::keyPress(&pad, Qt::Key_S);
    bench.tick(*view);
    QVERIFY(bench.motion().motion().walk().x() < 0);
    QTest::keyRelease(&pad, Qt::Key_S);
    bench.tick(*view);
    QCOMPARE(bench.motion().motion().kind(), MotionRequest::STAND);
    QCOMPARE(bench.refusal("robot.walk 0.2"), std::string());
    view->hide();  // it does not end what a script commands
    bench.step();
    QCOMPARE(bench.motion().motion().walk().x(), 0.2);
  }

  void motionsAreOfferedForCompletion() {
    CommandedRobot bench;
    const auto* command = bench.commands.find("robot.motion");
    const auto names = command->offer({});
    QVERIFY(std::find(names.begin(), names.end(), "get-up") != names.end());
    QVERIFY(names.size() > 3);
  }
};

const GuiTest<MotionCommandsTest> kMotionCommandsTest;

}  // namespace widgets::test

#include "MotionCommandsTest.moc"
