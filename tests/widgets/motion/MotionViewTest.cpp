// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionView.h"

#include <SDL.h>

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>

#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Linking.pb.h"
#include "robotlink/config/RobotDescription.h"
#include "tests/widgets/Bench.h"
#include "widgets/motion/MotionButtons.h"
#include "widgets/motion/WalkPad.h"

namespace widgets::test {

using robotcontrol::HeadMode;
using robotcontrol::MotionRequest;

namespace {

robotcontrol::SolutionTable behavior(const std::string& active, const std::string& unavailable = {}) {
  robotcontrol::SolutionTable table;
  auto& task = *table.add_tasks();
  task.set_name("behavior");
  task.set_process("cognition");
  task.set_active(active);
  task.add_solutions()->set_name("go-to-ball");
  auto& obey = *task.add_solutions();
  obey.set_name("obey");
  obey.set_unavailable(unavailable);
  return table;
}

/// A bench whose robot obeys; without a gamepad.
struct WalkSteering : Bench {
  WalkSteering() {
    push("red1/tables/solutions", behavior("go-to-ball"), 1);
    view = open<widgets::MotionView>({760, 560});
    view->setGamepad([this] { return pad; });
    push("red1/tables/solutions", behavior("obey"), 2);
    step();
    requests.clear();
  }
  void step(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) tick(*view);
  }
  /// The motion of the last command; fails if there was none.
  MotionRequest motion() const {
    for (auto request = requests.rbegin(); request != requests.rend(); ++request) {
      if (request->has_motion()) return request->motion().motion();
    }
    qFatal("no motion was commanded");
  }
  std::size_t motions() const {
    return static_cast<std::size_t>(
        std::count_if(requests.begin(), requests.end(), [](const auto& r) { return r.has_motion(); }));
  }
  widgets::Gamepad::State pad;
  std::unique_ptr<widgets::MotionView> view;
};

void pushPose(Bench& bench, double time, double x, double y, double heading) {
  foxglove::FrameTransforms transforms;
  auto& transform = *transforms.add_transforms();
  transform.set_parent_frame_id("field");
  transform.set_child_frame_id("red1");
  transform.mutable_translation()->set_x(x);
  transform.mutable_translation()->set_y(y);
  transform.mutable_rotation()->set_z(std::sin(heading / 2));
  transform.mutable_rotation()->set_w(std::cos(heading / 2));
  bench.push("transforms", transforms, time);
}

}  // namespace

class MotionViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void takingOverRequestsObeyAndGivingBackTheFormerSolution() {
    Bench bench;
    bench.push("red1/tables/solutions", behavior("go-to-ball"), 1);
    auto view = bench.open<widgets::MotionView>();
    auto& take = child<QToolButton>(*view, "motionTakeOver");
    auto& state = child<QLabel>(*view, "motionState");
    QCOMPARE(state.text(), QStringLiteral("go-to-ball steers the robot."));
    click(take);
    QCOMPARE(bench.requests[0].select_solution().task(), std::string("behavior"));
    QCOMPARE(bench.requests[0].select_solution().solution(), std::string("obey"));
    QVERIFY(state.text().startsWith(QStringLiteral("Switching")));
    bench.push("red1/tables/solutions", behavior("obey"), 2);
    bench.tick(*view);
    QVERIFY(take.isChecked());
    QCOMPARE(state.text(), QStringLiteral("You steer the robot."));
    click(take);
    QCOMPARE(bench.requests.back().select_solution().solution(), std::string("go-to-ball"));
  }

  void aTakeOverThatIsImpossibleOrRefusedSaysWhy() {
    Bench bench;
    bench.push("red1/tables/solutions",
               behavior("go-to-ball",
                        "unavailable because neither the robot nor another task provides motions that the "
                        "user requests (remote/motion)"),
               1);
    auto view = bench.open<widgets::MotionView>();
    QVERIFY(!child<QToolButton>(*view, "motionTakeOver").isEnabled());
    QVERIFY(child<QLabel>(*view, "motionState")
                .text()
                .contains(QStringLiteral("neither the robot nor another task provides motions that the user "
                                         "requests (remote/motion)")));
    bench.push("red1/tables/solutions", behavior("go-to-ball"), 2);
    bench.tick(*view);
    click(child<QToolButton>(*view, "motionTakeOver"));
    bench.answer(bench.requests.front(), false, "the process has failed");
    bench.tick(*view);
    QCOMPARE(child<QLabel>(*view, "motionState").text(), QStringLiteral("Refused: the process has failed"));
  }

  void nothingIsCommandedBeforeTheTakeOver() {
    Bench bench;
    bench.push("red1/tables/solutions", behavior("go-to-ball"), 1);
    auto view = bench.open<widgets::MotionView>();
    QTest::keyPress(&child<widgets::WalkPad>(*view, "walkPad"), Qt::Key_W);
    for (int i = 0; i < 10; ++i) bench.tick(*view);
    for (const auto& request : bench.requests) QVERIFY(!request.has_motion());
  }

  void theMousePadWalksUntilItIsReleased() {
    WalkSteering bench;
    auto& pad = child<widgets::WalkPad>(*bench.view, "walkPad");
    QTest::mousePress(&pad, Qt::LeftButton, {}, {pad.width() / 2, 2});
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::WALK);
    QVERIFY(std::abs(bench.motion().walk().x() - 0.15) < 0.001);
    QVERIFY(std::abs(bench.motion().walk().y()) < 0.005);
    QCOMPARE(child<QLabel>(*bench.view, "speedAskedX").text(), QStringLiteral("150"));
    QTest::mouseRelease(&pad, Qt::LeftButton);
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::STAND);
  }

  void keysWalkAndTurnAndAreResentTenTimesASecond() {
    WalkSteering bench;
    auto& pad = child<widgets::WalkPad>(*bench.view, "walkPad");
    QTest::keyPress(&pad, Qt::Key_A);
    QTest::keyPress(&pad, Qt::Key_E);
    bench.step();
    QCOMPARE(bench.motion().walk().y(), 0.15);
    QCOMPARE(bench.motion().walk().rotation(), -1.0);
    bench.requests.clear();
    bench.step(30);
    QCOMPARE(bench.motions(), std::size_t{10});
    QTest::keyPress(&pad, Qt::Key_Shift);  // halves
    bench.step();
    QCOMPARE(bench.motion().walk().y(), 0.075);
    QTest::keyRelease(&pad, Qt::Key_Shift);
    QTest::keyRelease(&pad, Qt::Key_A);
    QTest::keyRelease(&pad, Qt::Key_E);
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::STAND);
  }

  void losingTheFocusAndHidingStopTheRobot() {
    WalkSteering bench;
    auto& pad = child<widgets::WalkPad>(*bench.view, "walkPad");
    pad.setFocus();
    QTest::keyPress(&pad, Qt::Key_W);
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::WALK);
    pad.clearFocus();
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::STAND);
    pad.setFocus();
    QTest::keyPress(&pad, Qt::Key_W);
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::WALK);
    bench.view->hide();  // nobody ticks a hidden view: it must say so by itself
    QCOMPARE(bench.motion().kind(), MotionRequest::STAND);
  }

  void limitsBoundTheSpeedInEveryDirection() {
    WalkSteering bench;
    auto& limit = child<QAbstractSpinBox>(*bench.view, "limitSpeed");
    limit.setFocus();
    limit.selectAll();
    QTest::keyClicks(&limit, QStringLiteral("80"));
    QTest::keyClick(&limit, Qt::Key_Return);
    auto& pad = child<widgets::WalkPad>(*bench.view, "walkPad");
    QTest::keyPress(&pad, Qt::Key_W);
    QTest::keyPress(&pad, Qt::Key_D);
    bench.step();
    QCOMPARE(std::hypot(bench.motion().walk().x(), bench.motion().walk().y()), 0.08);
  }

  void headSlidersChooseAngles() {
    WalkSteering bench;
    auto& pan = child<QSlider>(*bench.view, "headPan");
    pan.setFocus();
    QTest::keyClick(&pan, Qt::Key_Right);
    QTest::keyClick(&pan, Qt::Key_Right);
    bench.step();
    QVERIFY(bench.requests.back().has_motion());
    const auto& head = bench.requests.back().motion().head();
    QCOMPARE(head.kind(), HeadMode::ANGLES);
    QCOMPARE(head.pan(), 2 * std::acos(-1.0) / 180);
  }

  void everySliderOfTheHeadMovesItsJoint() {
    WalkSteering bench;
    const double degree = std::acos(-1.0) / 180;
    using Angle = double (HeadMode::*)() const;
    const std::pair<const char*, Angle> joints[] = {{"headTilt", &HeadMode::tilt},
                                                    {"headPan", &HeadMode::pan},
                                                    {"headRoll", &HeadMode::roll},
                                                    {"headMouth", &HeadMode::mouth}};
    for (const auto& [name, angle] : joints) {
      auto& slider = child<QSlider>(*bench.view, name);
      slider.setFocus();
      QTest::keyClick(&slider, Qt::Key_Left);
      bench.step();
      const auto& head = bench.requests.back().motion().head();
      QCOMPARE(head.kind(), HeadMode::ANGLES);
      QCOMPARE((head.*angle)(), -degree);
      QCOMPARE(child<QLabel>(*bench.view, (std::string(name) + "Value").c_str()).text(),
               QStringLiteral("-1.0°"));
    }
  }

  void theHeadsModeIsChosenInItsBox() {
    WalkSteering bench;
    auto& mode = child<QComboBox>(*bench.view, "headMode");
    mode.setFocus();
    QTest::keyClick(&mode, Qt::Key_Down);
    bench.step();
    QCOMPARE(bench.requests.back().motion().head().kind(), HeadMode::SEARCH_BALL);
  }

  void theTurnSliderTurnsAsLongAsItIsHeld() {
    WalkSteering bench;
    auto& turn = child<QSlider>(*bench.view, "walkTurn");
    QTest::mousePress(&turn, Qt::LeftButton, {}, turn.rect().center());
    QMouseEvent move(QEvent::MouseMove, QPointF(turn.width() - 2.0, turn.height() / 2.0), Qt::NoButton,
                     Qt::LeftButton, {});
    QCoreApplication::sendEvent(&turn, &move);
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::WALK);
    QCOMPARE(bench.motion().walk().rotation(), -1.0);
    QTest::mouseRelease(&turn, Qt::LeftButton, {}, {turn.width() - 2, turn.height() / 2});
    QCOMPARE(turn.value(), 0);
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::STAND);
  }

  void theGreatestTurnIsTyped() {
    WalkSteering bench;
    auto& limit = child<QAbstractSpinBox>(*bench.view, "limitRotation");
    limit.setFocus();
    limit.selectAll();
    QTest::keyClicks(&limit, QStringLiteral("0.5"));
    QTest::keyClick(&limit, Qt::Key_Return);
    QTest::keyPress(&child<widgets::WalkPad>(*bench.view, "walkPad"), Qt::Key_Q);
    bench.step();
    QCOMPARE(bench.motion().walk().rotation(), 0.5);
  }

  void gettingUpIsAMotionOfItsOwn() {
    WalkSteering bench;
    click(child<QPushButton>(*bench.view, "motion-get-up"));
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::GET_UP);
  }

  void aMotionIsCommandedUntilTheRobotPlaysIt() {
    WalkSteering bench;
    const QStringList motions = widgets::MotionButtons::shippedMotions();
    QVERIFY(!motions.isEmpty());
    const QByteArray name = "motion-" + motions.first().toLatin1();
    click(child<QPushButton>(*bench.view, name.constData()));
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::KEY_FRAMES);
    QCOMPARE(bench.motion().motion(), motions.first().toStdString());
    robotcontrol::MotionStatus status;
    *status.mutable_executed() = bench.motion();
    bench.push("red1/motion/status", status, 3);
    bench.step(2);
    QCOMPARE(bench.motion().kind(), MotionRequest::STAND);
    QVERIFY(child<QPushButton>(*bench.view, name.constData()).isChecked());
  }

  void theGamepadWalksKicksAndStops() {
    WalkSteering bench;
    QCOMPARE(child<QLabel>(*bench.view, "gamepadState").text(),
             QStringLiteral("No gamepad; plug one in to use it"));
    bench.pad = {true, QStringLiteral("Pad"), {0.5, 0, 0.25}, false, false};
    bench.step();
    QCOMPARE(child<QLabel>(*bench.view, "gamepadState").text(), QStringLiteral("Gamepad: Pad"));
    QCOMPARE(bench.motion().walk().x(), 0.075);
    QCOMPARE(bench.motion().walk().rotation(), 0.25);
    bench.pad.axes = {};
    bench.pad.kick = true;
    bench.step();
    QCOMPARE(bench.motion().kind(), MotionRequest::KEY_FRAMES);
    QVERIFY(bench.motion().motion().starts_with("kick"));
    bench.pad.stop = true;
    bench.step();
    QVERIFY(std::any_of(bench.requests.begin(), bench.requests.end(),
                        [](const auto& request) { return request.has_stop() && request.stop().engaged(); }));
  }

  void stopShowsWhatThePlatformSays() {
    Bench bench;
    auto view = bench.open<widgets::MotionView>();
    auto& stop = child<QPushButton>(*view, "motionStop");
    click(stop);
    QVERIFY(bench.requests.back().stop().engaged());
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    robotcontrol::SimulationStatus status;
    bench.push("simulation", status, 1);
    bench.tick(*view);
    QVERIFY(!stop.isChecked());
    status.add_stopped_robots("red1");
    bench.push("simulation", status, 2);
    bench.tick(*view);
    QVERIFY(stop.isChecked());
    QCOMPARE(stop.text(), QStringLiteral("STOPPED: click to release"));
    click(stop);
    QVERIFY(!bench.requests.back().stop().engaged());
  }

  void theRobotThatIsSteeredIsNamed() {
    Bench bench;
    auto view = bench.open<widgets::MotionView>();
    bench.tick(*view);
    QCOMPARE(child<QLabel>(*view, "motionRobot").text(), QStringLiteral("red1"));
    QVERIFY(child<QPushButton>(*view, "motionStop").toolTip().contains(QStringLiteral("red1")));
    bench.session.selectRobot("blue1");
    bench.tick(*view);
    QCOMPARE(child<QLabel>(*view, "motionRobot").text(), QStringLiteral("blue1"));
  }

  void theTrueSpeedIsMeasuredInTheRobotsFrame() {
    Bench bench;
    auto view = bench.open<widgets::MotionView>();
    const double half = std::acos(-1.0) / 2;  // heads along y and walks along y: forwards
    for (int i = 0; i <= 25; ++i) pushPose(bench, i * 0.04, 1, i * 0.04 * 0.1, half);
    bench.tick(*view);
    QCOMPARE(child<QLabel>(*view, "speedMeasuredX").text(), QStringLiteral("100"));
    QCOMPARE(child<QLabel>(*view, "speedMeasuredY").text(), QStringLiteral("0"));
    QCOMPARE(child<QLabel>(*view, "speedMeasuredTurn").text(), QStringLiteral("0.00"));
    QCOMPARE(child<QLabel>(*view, "speedBelievedX").text(), QStringLiteral("–"));
  }

  void aGamepadMayComeAndGo() {
    widgets::Gamepad gamepad;
    QVERIFY(!gamepad.poll().connected);
    SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
    const int device = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, 6, 15, 0);
    if (device < 0) QSKIP("this SDL has no virtual joysticks");
    QVERIFY(gamepad.poll().connected);
    SDL_Joystick* joystick = SDL_JoystickOpen(device);
    SDL_JoystickSetVirtualAxis(joystick, 1, -32768);  // left stick forwards
    SDL_JoystickSetVirtualAxis(joystick, 2, 2000);    // right stick within the dead zone
    gamepad.poll();
    const auto state = gamepad.poll();
    QCOMPARE(state.axes.forward, 1.0);
    QCOMPARE(state.axes.turn, 0.0);
    SDL_JoystickClose(joystick);
    SDL_JoystickDetachVirtual(device);
    gamepad.poll();
    QVERIFY(!gamepad.poll().connected);
  }

  void aRobotThatIsKnownOnlyLaterGetsTheControlsOfItsKind() {
    WalkSteering bench;
    QVERIFY(child<QWidget>(*bench.view, "headPanel").isVisible());
    QVERIFY(!child<QWidget>(*bench.view, "motionMotors").isVisible());
    auto description = std::make_shared<robotlink::RobotDescription>();
    description->drive = robotlink::RobotDescription::Drive();
    description->drive->maximumSpeed = 0.7;
    bench.context.robots["red1"] = description;
    bench.step();
    QVERIFY(!child<QWidget>(*bench.view, "headPanel").isVisible());
    QVERIFY(child<QWidget>(*bench.view, "motionMotors").isVisible());
  }

  void nothingIsSentWhileTheConnectionIsLostAndTheViewSaysSo() {
    WalkSteering bench;
    robotcontrol::SteeringStatus status;
    status.set_who("RobotControl");
    status.set_client(1);
    status.set_own(true);
    bench.push("red1/steering", status, 3);
    bench.session.setRemoteRobots({{"red1", {"ws://10.0.0.1:8765", true}}});
    QTest::keyPress(&child<widgets::WalkPad>(*bench.view, "walkPad"), Qt::Key_W);
    bench.step(20);
    QVERIFY(bench.motions() > 0);
    QVERIFY(child<QWidget>(*bench.view, "steeringBar").isVisible());
    bench.session.setRemoteRobots({{"red1", {"ws://10.0.0.1:8765", false}}});
    bench.requests.clear();
    bench.step(20);
    QCOMPARE(bench.motions(), std::size_t{0});
    QVERIFY(!child<QWidget>(*bench.view, "steeringBar").isVisible());
    QVERIFY(child<QLabel>(*bench.view, "motionState").text().contains(QStringLiteral("is lost")));
    bench.session.setRemoteRobots({{"red1", {"ws://10.0.0.1:8765", true}}});
    bench.step(20);
    QVERIFY(bench.motions() > 0);
  }

  void whereItIsNarrowThePanelsAreBelowThePad() {
    WalkSteering bench;
    const auto& pad = child<WalkPad>(*bench.view, "walkPad");
    const auto& speeds = child<QWidget>(*bench.view, "speedPanel");
    const auto& scrolled = *bench.view->findChild<QScrollArea*>();
    const auto isBelow = [&] {
      return speeds.mapTo(bench.view.get(), QPoint()).y() >
             pad.mapTo(bench.view.get(), QPoint(0, pad.height())).y() - 1;
    };
    QVERIFY(!isBelow());
    bench.view->resize(400, 260);
    bench.step();
    QTRY_VERIFY(isBelow());
    QTRY_COMPARE(scrolled.horizontalScrollBar()->maximum(), 0);
    QVERIFY(scrolled.verticalScrollBar()->maximum() > 0);
    bench.view->resize(760, 560);
    bench.step();
    QTRY_VERIFY(!isBelow());
  }

  void whoElseSteersIsShownAndNothingIsSentMeanwhile() {
    WalkSteering bench;
    bench.session.setRemoteRobots({{"red1", {"ws://10.0.0.1:8765", true}}});
    std::vector<std::string> taken;
    bench.commands.add({"robot.steer",
                        "",
                        {{"robot", robotlink::CommandTable::Type::kText, ""},
                         {"on", robotlink::CommandTable::Type::kBool, ""}},
                        [&](const auto& values) -> robotlink::Result<void> {
                          taken.push_back(std::get<std::string>(values[0]) +
                                          (std::get<bool>(values[1]) ? " on" : " off"));
                          return {};
                        }});
    auto& bar = child<QWidget>(*bench.view, "steeringBar");
    QVERIFY(!bar.isVisible());
    robotcontrol::SteeringStatus status;
    status.set_who("RobotControl of anna at 10.0.0.7:5123");
    status.set_client(3);
    bench.push("red1/steering", status, 3);
    bench.step();
    QVERIFY(bar.isVisible());
    QVERIFY(child<QLabel>(bar, "steeringText")
                .text()
                .contains(QStringLiteral("anna at 10.0.0.7:5123 steers red1")));
    bench.requests.clear();
    bench.pad.connected = true;
    bench.pad.axes.forward = 1;
    bench.step(20);
    QCOMPARE(bench.motions(), std::size_t{0});
    QTest::mouseClick(bar.findChild<QToolButton*>(), Qt::LeftButton);
    QCOMPARE(taken, std::vector<std::string>{"red1 on"});
    status.set_own(true);
    bench.push("red1/steering", status, 4);
    bench.step(2);
    QVERIFY(child<QLabel>(bar, "steeringText").text().contains(QStringLiteral("You steer red1")));
    QVERIFY(bench.motions() > 0);
    QTest::mouseClick(bar.findChild<QToolButton*>(), Qt::LeftButton);
    QCOMPARE(taken.back(), std::string("red1 off"));
  }
};

const GuiTest<MotionViewTest> kMotionViewTest;

}  // namespace widgets::test

#include "MotionViewTest.moc"
