// SPDX-License-Identifier: GPL-3.0-or-later
// The motion tester with robots on wheels.
#include <QAbstractSpinBox>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>

#include "tests/widgets/FieldBench.h"
#include "tests/widgets/drive/DriveBench.h"
#include "widgets/motion/HeadPanel.h"
#include "widgets/motion/MotionButtons.h"
#include "widgets/motion/MotionView.h"
#include "widgets/motion/WalkPad.h"

namespace widgets::test {

using robotcontrol::MotionRequest;

namespace {

robotcontrol::SolutionTable driving(const std::string& active) {
  robotcontrol::SolutionTable table;
  for (const char* name : {"avoidance", "driving"}) {
    auto& task = *table.add_tasks();
    task.set_name(name);
    task.set_process("cognition");
    task.set_active(name == std::string("driving") ? active : "vector-field");
    task.add_solutions()->set_name("wander");
    if (name == std::string("driving")) task.add_solutions()->set_name("obey");
  }
  return table;
}

struct WheelSteering : DriveBench {
  WheelSteering() {
    push("p3at1/tables/solutions", driving("wander"), 1);
    push("p3at1/drive/state", state(), 1);
    view = open<widgets::MotionView>({640, 420});
    view->setGamepad([this] { return pad; });
    walkPad = &child<widgets::WalkPad>(*view, "walkPad");
  }
  void takeOver() {
    click(child<QToolButton>(*view, "motionTakeOver"));
    push("p3at1/tables/solutions", driving("obey"), 2);
    tick(*view);
  }
  robotcontrol::Velocity2 pending() {
    tick(*view);
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
      if (request->has_motion()) return request->motion().motion().walk();
    }
    qFatal("no motion was commanded");
  }
  widgets::Gamepad::State pad;
  std::unique_ptr<widgets::MotionView> view;
  widgets::WalkPad* walkPad = nullptr;
};

}  // namespace

class DrivingTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void whatIsFasterThanItMayBeAskedForStaysOnThePad() {
    for (const bool wheels : {true, false}) {
      widgets::WalkPad::Picture still, fast;
      still.enabled = fast.enabled = true;
      still.wheels = fast.wheels = wheels;
      fast.measured = widgets::WalkAxes{3, wheels ? 0 : 2.5, -4};
      fast.asked = widgets::WalkAxes{-2, 0, wheels ? 2.0 : 0.0};
      const auto picture = [](const widgets::WalkPad::Picture& what) {
        QImage image(200, 200, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        widgets::WalkPad::paint(painter, {20, 20, 160, 160}, what, QGuiApplication::palette());
        return image;
      };
      const QImage before = picture(still), after = picture(fast);
      QVERIFY(before != after);
      // Beside the pad's own rectangle nothing is painted; its margin of 12 holds tips and arcs.
      for (int i = 0; i < 200; ++i) {
        for (const QPoint& at : {QPoint(i, 18), QPoint(i, 181), QPoint(18, i), QPoint(181, i)})
          QCOMPARE(after.pixelColor(at), before.pixelColor(at));
      }
    }
  }

  void theTaskThatObeysIsTakenOver() {
    WheelSteering s;
    s.takeOver();
    const auto& asked = s.requests.front().select_solution();
    QCOMPARE(asked.task(), std::string("driving"));
    QCOMPARE(asked.solution(), std::string("obey"));
    QCOMPARE(child<QLabel>(*s.view, "motionState").text(), QStringLiteral("You steer the robot."));
    click(child<QToolButton>(*s.view, "motionTakeOver"));
    QCOMPARE(s.requests.back().select_solution().solution(), std::string("wander"));
  }

  void thereIsNeitherHeadNorKeyFrames() {
    WheelSteering s;
    QVERIFY(!s.view->findChild<widgets::HeadPanel*>()->isVisible());
    QVERIFY(!s.view->findChild<widgets::MotionButtons*>()->isVisible());
    QVERIFY(!child<QSlider>(*s.view, "walkTurn").isVisible());
    QVERIFY(child<QToolButton>(*s.view, "motionMotors").isVisible());
    // The next robot has legs: it has all of them again.
    s.context.robots.erase("p3at2");
    s.session.selectRobot("p3at2");
    s.tick(*s.view);
    QVERIFY(s.view->findChild<widgets::HeadPanel*>()->isVisible());
    QVERIFY(!child<QToolButton>(*s.view, "motionMotors").isVisible());
  }

  void leftAndRightTurn() {
    WheelSteering s;
    s.takeOver();
    QTest::mousePress(s.walkPad, Qt::LeftButton, {}, {2, s.walkPad->height() / 2});
    auto pending = s.pending();
    QVERIFY(std::abs(pending.x()) < 0.01 && pending.y() == 0);
    QVERIFY(std::abs(pending.rotation() - robotlink::radians(50)) < 0.02);  // half of what it can
    QTest::mouseRelease(s.walkPad, Qt::LeftButton);
    QTest::keyPress(s.walkPad, Qt::Key_W);
    QTest::keyPress(s.walkPad, Qt::Key_D);
    pending = s.pending();
    QCOMPARE(pending.x(), 0.375);
    QCOMPARE(pending.y(), 0.0);
    QVERIFY(pending.rotation() < -0.8);
    QTest::keyRelease(s.walkPad, Qt::Key_W);
    QTest::keyRelease(s.walkPad, Qt::Key_D);
    QVERIFY(s.pending().x() == 0);
  }

  void eitherStickOfTheGamepadTurns() {
    WheelSteering s;
    s.takeOver();
    s.pad = {true, QStringLiteral("Pad"), {1, 0.5, 0.2}, true, false};
    const auto pending = s.pending();
    QCOMPARE(pending.x(), 0.375);
    QCOMPARE(pending.y(), 0.0);
    QVERIFY(std::abs(pending.rotation() - 0.7 * robotlink::radians(50)) < 0.01);  // and A kicks nothing
  }

  void theLimitsAreTheRobots() {
    WheelSteering s;
    auto& limit = child<QAbstractSpinBox>(*s.view, "limitSpeed");
    limit.setFocus();
    limit.selectAll();
    QTest::keyClicks(&limit, QStringLiteral("9999"));
    QTest::keyClick(&limit, Qt::Key_Return);
    limit.selectAll();
    QTest::keyClicks(&limit, QStringLiteral("750"));
    QTest::keyClick(&limit, Qt::Key_Return);
    s.takeOver();
    QTest::keyPress(s.walkPad, Qt::Key_Up);
    QCOMPARE(s.pending().x(), 0.75);
    const QJsonObject state = s.view->saveState();
    QCOMPARE(state[QStringLiteral("driveSpeed")].toDouble(), 0.75);
    QCOMPARE(state[QStringLiteral("speed")].toDouble(), 0.15);  // that of robots with legs
    WheelSteering other;
    other.view->restoreState(state);
    QCOMPARE(other.view->saveState(), state);
  }

  void motorsAreSwitchedAndStopActsAtThePlatform() {
    WheelSteering s;
    auto& motors = child<QToolButton>(*s.view, "motionMotors");
    QCOMPARE(motors.text(), QStringLiteral("Motors on"));
    click(motors);
    QVERIFY(s.requests.back().control_drive().has_motors() && !s.requests.back().control_drive().motors());
    auto off = DriveBench::state();
    off.set_motors_on(false);
    s.push("p3at1/drive/state", off, 2);
    s.takeOver();
    QCOMPARE(motors.text(), QStringLiteral("Motors off"));
    QVERIFY(child<QLabel>(*s.view, "motionState").text().contains(QStringLiteral("motors are off")));
    click(child<QPushButton>(*s.view, "motionStop"));
    QVERIFY(s.requests.back().stop().engaged());
  }

  void whatTheRobotSaysOfItsSpeedIsShown() {
    WheelSteering s;
    auto state = DriveBench::state();
    state.mutable_velocity()->set_x(0.2);
    state.mutable_velocity()->set_rotation(0.4);
    s.push("p3at1/drive/state", state, 3);
    s.takeOver();
    QCOMPARE(child<QLabel>(*s.view, "speedBelievedX").text(), QStringLiteral("200"));
    QCOMPARE(child<QLabel>(*s.view, "speedBelievedTurn").text(), QStringLiteral("0.40"));
    QVERIFY(!child<QLabel>(*s.view, "speedBelievedY").isVisible());
    QTest::keyPress(s.walkPad, Qt::Key_W);
    QTest::keyPress(s.walkPad, Qt::Key_A);
    s.pending();
    keepPicture(*s.view, "motion-wheels");
  }
};

const GuiTest<DrivingTest> kDrivingTest;

}  // namespace widgets::test

#include "DrivingTest.moc"
