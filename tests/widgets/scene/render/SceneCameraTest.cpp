// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTest>

#include "robotcontrol/World.pb.h"
#include "tests/widgets/scene/ShownScene.h"

namespace widgets::test {
namespace {

using robotlink::Vector3;

}  // namespace

class SceneCameraTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() {
    if (!sceneCanBeDrawn()) QSKIP("no OpenGL here");
  }

  void draggingTurnsTheCamera() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const QImage before = s.picture();
    const SceneCamera camera = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, {30, 30}, {90, 50});
    QVERIFY(s.step());
    QVERIFY(s.canvas->camera().azimuth != camera.azimuth && s.canvas->camera().elevation > camera.elevation);
    QVERIFY(pictureDifference(before, s.picture()) > 0.1);
    QVERIFY(s.colorAt(kBall).hue() < 40);  // it is still where the camera says
    QVERIFY(s.world.requests.empty());
  }

  void theArrowKeysTurnAndMoveTheCamera() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const SceneCamera before = s.canvas->camera();
    QTest::keyClick(s.canvas, Qt::Key_Left);
    QVERIFY(!(s.canvas->camera() == before));
    QVERIFY(s.canvas->camera().target == before.target);
    QTest::keyClick(s.canvas, Qt::Key_Right);
    QTest::keyClick(s.canvas, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(s.canvas->camera().target != before.target);
    QTest::keyClick(s.canvas, Qt::Key_Down, Qt::ShiftModifier);
    QVERIFY((s.canvas->camera().target - before.target).norm() < 1e-6);
  }

  void theWholeFieldIsSeenWhateverTheSize() {
    ShownScene s;
    QVERIFY(s.placeThings());
    for (const QSize size : {QSize(300, 500), QSize(700, 300)}) {
      s.view.resize(size);
      QApplication::processEvents();
      for (const double x : {-2.25, 2.25}) {
        for (const double y : {-1.5, 1.5}) QVERIFY(s.canvas->rect().contains(s.at({x, y, 0.4})));
      }
    }
  }

  void theRightButtonMovesTheCamera() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const QPoint before = s.at({0, 0, 0});
    drag(*s.canvas, Qt::RightButton, {200, 200}, {240, 200});
    const QPoint moved = s.at({0, 0, 0}) - before;
    QVERIFY2(std::abs(moved.x() - 40) <= 3 && std::abs(moved.y()) <= 3,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
  }

  void theWheelZoomsToTheCursor() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const SceneCamera home = s.canvas->camera();
    const QPoint before = s.at({1, 0.5, 0});
    turnWheel(*s.canvas, before, 4);
    QVERIFY((s.at({1, 0.5, 0}) - before).manhattanLength() <= 4);
    QVERIFY(s.canvas->camera().distance < home.distance && !s.canvas->overview());
    QTest::keyClick(s.canvas, Qt::Key_R);
    QCOMPARE(s.canvas->camera(), home);
  }

  void presetsLookFromAboveAndFromBehind() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.click("sceneFromAbove");
    QVERIFY(s.canvas->camera().elevation > robotlink::radians(89));
    s.click("sceneBehind");
    QVERIFY(std::abs(robotlink::normalizedAngle(s.canvas->camera().azimuth - 0.3 - robotlink::kPi)) < 1e-9);
    const QPoint robot = s.at({-1, 0.5, 0.1});
    QVERIFY(s.canvas->rect().contains(robot));
  }

  void aNewViewIsNearTheRobotAndFollowsIt() {
    FieldBench world;
    SceneView view(world.context);
    auto* canvas = &child<SceneCanvas>(view, "sceneCanvas");
    view.resize(600, 500);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    world.pushScene();
    world.pushPoses({-1, 0.5, 0.3}, {kBall.x(), kBall.y()});
    world.advance();
    view.tick();
    QVERIFY(!canvas->overview());
    QVERIFY(canvas->camera().distance < 3);
    const auto seen = [&](double x, double y) {
      const auto at = canvas->camera().project(canvas->size(), {x, y, 0.05});
      return at && canvas->rect().adjusted(60, 60, -60, -60).contains(at->toPoint());
    };
    QVERIFY(seen(-1, 0.5));
    for (int i = 0; i < 100; ++i) {
      world.pushPoses({-1 + 0.02 * i, 0.5, 0.3}, {kBall.x(), kBall.y()});
      world.advance();
      view.tick();
      QVERIFY(seen(-1 + 0.02 * i, 0.5));
    }
    // The camera that a person chooses stays until he follows again.
    QTest::keyClick(canvas, Qt::Key_A);
    QVERIFY(canvas->camera().elevation > robotlink::radians(89));
    world.pushPoses({-1, -1, 0.3}, {kBall.x(), kBall.y()});
    world.advance();
    const SceneCamera above = canvas->camera();
    view.tick();
    QCOMPARE(canvas->camera(), above);
  }

  void theCameraFollowsTheRobotGently() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const Vector3 far(5, 5, 0);  // the ball plays no part
    s.world.pushPoses({-1, 0.5, 0.3}, {far.x(), far.y()});
    QVERIFY(s.step());
    QTest::keyClick(s.canvas, Qt::Key_F);
    const Vector3 before = s.canvas->camera().target;
    s.world.pushPoses({-0.6, 0.8, 0.3}, {far.x(), far.y()});
    s.world.advance();
    s.view.tick();
    const double first = (s.canvas->camera().target - before).norm();
    QVERIFY2(first > 0.02 && first < 0.25, qPrintable(QString::number(first)));
    s.settle();
    const Vector3 moved = s.canvas->camera().target - before;
    QVERIFY2((moved - Vector3(0.4, 0.3, 0)).norm() < 2e-3,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
    // At rest nothing is drawn for it.
    const SceneCamera still = s.canvas->camera();
    s.view.tick();
    QCOMPARE(s.canvas->camera(), still);
  }

  void theCameraOverTheShoulderTurnsWithTheRobot() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.click("sceneBehind");
    const SceneCamera before = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, {30, 30}, {60, 30});  // a little to the side, as a person likes it
    const double aside = robotlink::normalizedAngle(s.canvas->camera().azimuth - before.azimuth);
    s.world.pushPoses({-0.7, 0.5, 1.3}, {kBall.x(), kBall.y()});
    s.world.advance();
    s.settle();
    const double turned = robotlink::normalizedAngle(s.canvas->camera().azimuth - before.azimuth);
    QVERIFY2(std::abs(turned - aside - 1) < 0.01, qPrintable(QStringLiteral("%1 %2").arg(turned).arg(aside)));
    QVERIFY(s.canvas->rect().contains(s.at({-0.7, 0.5, 0.1})));
    // It is one or the other.
    s.click("sceneFollow");
    QVERIFY(!s.view.findChild<QAction*>(QStringLiteral("sceneBehindAction"))->isChecked());
  }

  void whatIsDraggedDoesNotTakeTheCameraAlong() {
    ShownScene s;
    s.world.session.setRobots({"red1"});
    QVERIFY(s.placeThings());
    QTest::keyClick(s.canvas, Qt::Key_F);
    s.settle();
    const Vector3 top(-1, 0.5, 0.17);
    const SceneCamera before = s.canvas->camera();
    moveMouse(*s.canvas, s.at(top));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(top));
    moveMouse(*s.canvas, s.at(top) + QPoint(60, 0), Qt::LeftButton);
    s.world.pushPoses({-0.6, 0.5, 0.3}, {kBall.x(), kBall.y()});
    QVERIFY(s.step());
    QCOMPARE(s.canvas->camera(), before);
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(top) + QPoint(60, 0));
    s.view.tick();
    QVERIFY(!(s.canvas->camera() == before));
  }

  void aClickSelectsARobotAndMovesNothing() {
    ShownScene s;
    s.world.session.setRobots({"blue1", "red1"});
    s.world.session.selectRobot("blue1");
    QVERIFY(s.placeThings());
    const Vector3 top(-1, 0.5, 0.17);
    moveMouse(*s.canvas, s.at(top));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(top));
    moveMouse(*s.canvas, s.at(top) + QPoint(2, 0), Qt::LeftButton);
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(top) + QPoint(2, 0));
    QCOMPARE(s.world.session.selectedRobot(), std::string("red1"));
    s.view.tick();
    QVERIFY(s.world.requests.empty());
  }

  void draggingTheBallPlacesIt() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.click("sceneZoomIn");  // a pixel is less than a centimeter now
    const Vector3 wanted(0.9, 0.2, kBall.z());
    const SceneCamera camera = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at(wanted), [&] { s.view.tick(); });
    QVERIFY(s.world.requests.size() >= 2);
    const auto& place = s.world.requests.back().place_model();
    QCOMPARE(place.model(), std::string("ball"));
    const auto& pose = place.pose_in_field();
    QVERIFY2(std::hypot(pose.x() - wanted.x(), pose.y() - wanted.y()) < 0.02,
             qPrintable(QStringLiteral("%1 %2").arg(pose.x()).arg(pose.y())));
    // The camera did not move.
    QCOMPARE(s.canvas->camera(), camera);
  }

  void aGhostShowsWhereTheRobotIsWantedAndTheWheelTurnsIt() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.click("sceneZoomIn");  // a pixel is less than a centimeter now
    const Vector3 top(-1, 0.5, 0.17), wanted(-0.3, 0.2, 0.17);
    moveMouse(*s.canvas, s.at(top));
    QTest::mousePress(s.canvas, Qt::LeftButton, {}, s.at(top));
    moveMouse(*s.canvas, s.at(wanted), Qt::LeftButton);
    turnWheel(*s.canvas, s.at(wanted), 2);
    QVERIFY(s.step());
    QVERIFY(!isNear(s.colorAt(wanted), s.named("green"), 30));
    keepPicture(s.view, "scene-drag");
    QTest::mouseRelease(s.canvas, Qt::LeftButton, {}, s.at(wanted));
    const auto& pose = s.world.requests.back().place_model().pose_in_field();
    QVERIFY(std::abs(pose.heading() - 0.3 - robotlink::radians(30)) < 1e-9);
    QVERIFY(std::hypot(pose.x() - wanted.x(), pose.y() - wanted.y()) < 0.02);
  }

  void withoutTheToolOnlyControlMoves() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.click("sceneMove");
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at(kBall) + QPoint(30, 0), [&] { s.view.tick(); });
    QVERIFY(s.world.requests.empty());
    drag(
        *s.canvas, Qt::LeftButton, s.at(kBall), s.at(kBall) + QPoint(30, 0), [&] { s.view.tick(); },
        Qt::ControlModifier);
    QVERIFY(!s.world.requests.empty());
  }

  void keysAndClicksAreSentToControllers() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.click("sceneSend");
    const SceneCamera camera = s.canvas->camera();
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at(kBall) + QPoint(30, 0), [&] { s.view.tick(); });
    QVERIFY(s.world.requests.size() >= 3U);
    const auto& pressed = s.world.requests.front().send_event();
    QVERIFY(pressed.kind() == robotcontrol::ViewEvent::MOUSE_PRESSED && pressed.button() == 1);
    // The ray goes through the ball.
    const Vector3 origin(pressed.origin().x(), pressed.origin().y(), pressed.origin().z());
    const Vector3 direction(pressed.direction().x(), pressed.direction().y(), pressed.direction().z());
    QVERIFY((kBall - origin).cross(direction.normalized()).norm() < 0.03);
    QVERIFY(s.world.requests.back().send_event().kind() == robotcontrol::ViewEvent::MOUSE_RELEASED);
    s.world.requests.clear();
    QTest::keyClick(s.canvas, Qt::Key_R);
    QVERIFY2(s.world.requests.size() == 2U, s.world.requests[0].ShortDebugString().c_str());
    QVERIFY(s.world.requests[0].send_event().key() == "R");
    QVERIFY(s.world.requests[1].send_event().kind() == robotcontrol::ViewEvent::KEY_RELEASED);
    QTest::keyClick(s.canvas, Qt::Key_F5);
    QTest::keyClick(s.canvas, Qt::Key_Escape, Qt::ShiftModifier);
    QCOMPARE(int(s.world.requests.size()), 2);
    QVERIFY(s.canvas->camera() == camera);
    s.click("sceneSend");
    QTest::keyClick(s.canvas, Qt::Key_Left);
    QVERIFY(!(s.canvas->camera() == camera));
    QCOMPARE(int(s.world.requests.size()), 2);
  }

  void aRefusedPlaceIsShown() {
    ShownScene s;
    QVERIFY(s.placeThings());
    s.world.refusal = "it would stand in a wall";
    const QImage before = s.canvas->grab().toImage();
    drag(*s.canvas, Qt::LeftButton, s.at(kBall), s.at({1.5, 1.3, kBall.z()}), [&] { s.view.tick(); });
    QVERIFY(s.step());
    QVERIFY(s.step());
    const QRect top(140, 8, 200, 20);
    QVERIFY(before.copy(top) != s.canvas->grab().toImage().copy(top));
  }

  void theContextMenuHasTheCamerasPlaces() {
    ShownScene s;
    QVERIFY(s.placeThings());
    const auto before = s.canvas->camera();
    QTest::mouseClick(s.canvas, Qt::RightButton, {}, {100, 100});
    auto* menu = &child<QMenu>(s.view, "sceneMenu");
    QVERIFY(menu->isVisible());
    auto* fromAbove = s.view.findChild<QAction*>(QStringLiteral("sceneFromAboveAction"));
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(fromAbove).center());
    QVERIFY(!(s.canvas->camera() == before));
  }
};

const GuiTest<SceneCameraTest> kSceneCameraTest;

}  // namespace widgets::test

#include "SceneCameraTest.moc"
