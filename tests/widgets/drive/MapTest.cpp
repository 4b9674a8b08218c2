// SPDX-License-Identifier: GPL-3.0-or-later
// The Field view on maps: ground, places, goals, paths, robots on wheels.
#include <QLabel>
#include <QSignalSpy>
#include <QToolButton>

#include "tests/widgets/FieldBench.h"
#include "tests/widgets/drive/DriveBench.h"
#include "widgets/field/FieldCanvas.h"
#include "widgets/field/FieldView.h"
#include "widgets/field/PlaceNotice.h"
#include "widgets/world/RobotBeliefs.h"

namespace widgets::test {
namespace {

struct ShownMapView : DriveBench {
  explicit ShownMapView(const robotcontrol::GroundMap& map = room(), QSize size = {840, 660}) {
    push("map", map, 0);
    view = open<widgets::FieldView>(size);
    canvas = &child<widgets::FieldCanvas>(*view, "fieldCanvas");
  }
  QPoint at(double x, double y) const { return canvas->transform().map(QPointF(x, y)).toPoint(); }
  QColor colorAt(double x, double y) const { return canvas->rendered().pixelColor(at(x, y)); }
  bool isGround(double x, double y) const {
    return isNear(colorAt(x, y), canvas->palette().color(QPalette::Base), 8);
  }
  void press(double x, double y, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(canvas, Qt::LeftButton, modifiers, at(x, y));
  }
  void move(double x, double y) { moveMouse(*canvas, at(x, y), Qt::LeftButton); }
  void release(double x, double y) { QTest::mouseRelease(canvas, Qt::LeftButton, {}, at(x, y)); }
  const robotcontrol::DriveGoal& goal() const { return requests.back().set_goal(); }

  std::unique_ptr<widgets::FieldView> view;
  widgets::FieldCanvas* canvas = nullptr;
};

}  // namespace

class MapTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aMapIsTheGround() {
    DriveBench world;
    world.push("map", DriveBench::room(), 0);
    world.session.tick();
    widgets::FieldView view(world.context);  // also of a view that is made while the map is there
    QSignalSpy titles(&view, &widgets::View::titleChanged);
    world.tick(view);
    world.tick(view);
    QCOMPARE(titles.size(), 1);
    QCOMPARE(titles[0][0].toString(), QStringLiteral("Map: room"));
    world.session.restart();
    world.tick(view);
    QCOMPARE(titles[1][0].toString(), QStringLiteral("Field"));
  }

  void wallsAreLinesAndPoints() {
    ShownMapView s;
    QVERIFY(!s.isGround(2, 0) && !s.isGround(8, 3));                            // lines
    QVERIFY(!s.isGround(4, 1.5) && !s.isGround(4, 2.9) && s.isGround(4, 3.4));  // points
    QVERIFY(s.isGround(2, 3));
    int forbidden = 0;
    for (int i = 0; i < 40; ++i) forbidden += s.isGround(5.5 + 0.02 * i, 1) ? 0 : 1;
    QVERIFY(forbidden > 4 && !s.isGround(5, 1));  // hatched, with an edge
    // Zoomed in by sixteen, the wall is still where it was, and as thick as its points are apart.
    for (int i = 0; i < 8; ++i) click(*s.view, "fieldZoomIn");
    s.canvas->setViewport({false, s.canvas->viewport().scale, {4, 1.5}, 0});
    QVERIFY(!s.isGround(4, 1.5) && s.isGround(4.05, 1.5) && !s.isGround(4, 1.61));
  }

  void aSilentRobotIsGrayAndItsAgeIsShown() {
    ShownMapView s;
    s.push("p3at1/drive/state", DriveBench::state(), 1);
    robotcontrol::RobotPose pose;
    robotlink::assign(*pose.mutable_robot_in_field(), robotlink::Pose2{6, 3, 0});
    s.push("p3at1/models/pose", pose, 1);
    s.tick(*s.view);
    auto& reported = child<QLabel>(*s.view, "fieldState");
    QVERIFY(!reported.isVisible());
    const auto colored = [&] {
      const QImage picture = s.canvas->rendered();
      const QPoint middle = s.at(6, 3);
      int saturation = 0;
      for (int x = -20; x <= 20; ++x)
        saturation = std::max(saturation, picture.pixelColor(middle.x() + x, middle.y()).saturation());
      return saturation;
    };
    const int heard = colored();
    s.push("simulation", robotcontrol::SimulationStatus(), 8);
    s.tick(*s.view);
    QCOMPARE(reported.text(), QStringLiteral("p3at1 last heard 7 s ago"));
    QVERIFY(reported.isVisible());
    QVERIFY2(colored() < heard, "it may be elsewhere by now");
    s.push("p3at1/drive/state", DriveBench::state(), 8.1);
    s.tick(*s.view);
    QVERIFY(!reported.isVisible());
    QCOMPARE(colored(), heard);
  }

  void allOfABuildingIsSeenAtFirst() {
    ShownMapView s;
    for (const auto& [x, y] : {std::pair(0.0, 0.0), {8.0, 6.0}})
      QVERIFY(s.canvas->rect().contains(s.at(x, y)));
    QVERIFY(s.at(4, 3).x() - s.canvas->rect().center().x() <= 1);
  }

  void aRobotThatDoesNotKnowWhereItIsSaysWhatToDo() {
    ShownMapView s;
    widgets::RobotBelief lost;
    lost.robot = "p3at1";
    auto base = DriveBench::state();
    const auto notice = [&](bool onMap) { return widgets::placeNotice(lost, &base, onMap); };
    QVERIFY(notice(true).contains(QStringLiteral("send it anywhere")));
    base.set_motors_on(false);
    QVERIFY(notice(true).contains(QStringLiteral("switch its motors on")));
    QVERIFY(notice(false).contains(QStringLiteral("has no map")));
    base.set_emergency_stop(true);
    QVERIFY(notice(true).contains(QStringLiteral("release its stop button")));
    lost.estimate = robotlink::Pose2{1, 2, 0};
    lost.positionDeviation = 3;
    QVERIFY(!notice(true).isEmpty());
    lost.positionDeviation = 0.2;
    QVERIFY(notice(true).isEmpty());
    // In the view: a sentence at the top, until it has found itself.
    s.push("p3at1/drive/state", DriveBench::state(), 1);
    s.tick(*s.view);
    const QImage reported = s.canvas->grab().toImage();
    keepPicture(*s.view, "map-lost");
    s.pushEstimate("p3at1", {2, 3, 0}, 1);
    s.tick(*s.view);
    const QImage known = s.canvas->grab().toImage();
    const QRect top(0, 0, reported.width(), reported.height() / 12);
    QVERIFY(reported.copy(top) != known.copy(top));
  }

  void aClickSendsTheRobotThere() {
    ShownMapView s;
    s.press(2, 3);
    s.release(2, 3);
    QVERIFY(s.requests.empty());  // without the tool a drag moves the picture
    click(*s.view, "fieldSend");
    s.press(2, 3);
    s.release(2, 3);
    QCOMPARE(s.requests.size(), std::size_t{1});
    QCOMPARE(s.requests.back().robot(), std::string("p3at1"));
    QVERIFY(std::abs(s.goal().pose_in_field().x() - 2) < 0.02 &&
            std::abs(s.goal().pose_in_field().y() - 3) < 0.02);
    QVERIFY(s.goal().any_heading() && !s.goal().cancelled());
  }

  void draggingSaysWhereToLookThen() {
    ShownMapView s;
    s.press(2, 3, Qt::ControlModifier);
    s.move(2, 4);
    s.release(2, 4);
    QVERIFY(!s.goal().any_heading());
    QVERIFY(std::abs(s.goal().pose_in_field().heading() - robotlink::kPi / 2) < 0.02);
    QVERIFY(std::abs(s.goal().pose_in_field().y() - 3) < 0.02);
  }

  void aPlaceIsTakenWithItsNameAndHeading() {
    ShownMapView s;
    click(*s.view, "fieldSend");
    const QPoint near = s.at(6, 4.5) + QPoint(3, -3);
    QTest::mouseClick(s.canvas, Qt::LeftButton, {}, near);
    QCOMPARE(s.goal().name(), std::string("Desk"));
    QCOMPARE(s.goal().pose_in_field().x(), 6.0);
    QVERIFY(!s.goal().any_heading());
    QCOMPARE(s.goal().pose_in_field().heading(), robotlink::kPi / 2);
  }

  void escapeAbandonsTheAimAndThenTheGoal() {
    ShownMapView s;
    click(*s.view, "fieldSend");
    auto& cancel = child<QToolButton>(*s.view, "fieldCancelGoal");
    QVERIFY(!cancel.isEnabled());
    s.press(2, 3);
    s.canvas->setFocus();
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    s.release(2, 3);
    QVERIFY(s.requests.empty());
    robotcontrol::DrivePath path;
    path.mutable_goal()->mutable_pose_in_field()->set_x(6);
    s.push("p3at1/models/path", path, 1);
    s.tick(*s.view);
    QVERIFY(cancel.isEnabled());
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QVERIFY(s.goal().cancelled());
    path.clear_goal();
    s.push("p3at1/models/path", path, 2);
    s.tick(*s.view);
    QVERIFY(!cancel.isEnabled());
  }

  void aRefusedGoalSaysWhy() {
    ShownMapView s;
    s.press(2, 3, Qt::ControlModifier);
    s.release(2, 3);
    const QImage before = s.canvas->grab().toImage();
    s.answer(false, "its program takes no goals");
    s.tick(*s.view);
    QVERIFY(s.canvas->grab().toImage().copy(100, 0, 400, 40) != before.copy(100, 0, 400, 40));
  }

  void thePathToTheGoalIsSeen() {
    ShownMapView s;
    s.pushTruth({{"p3at1", {1, 3, 0}}}, 1);
    QVERIFY(s.isGround(2.5, 3.5));
    robotcontrol::DrivePath path;
    for (int i = 0; i <= 40; ++i) {
      auto& point = *path.add_points_in_field();
      point.set_x(1 + 0.05 * i);
      point.set_y(3.5);
    }
    path.mutable_goal()->mutable_pose_in_field()->set_x(3);
    path.mutable_goal()->mutable_pose_in_field()->set_y(3.5);
    path.mutable_goal()->set_any_heading(true);
    s.push("p3at1/models/path", path, 1);
    s.tick(*s.view);
    int dots = 0;
    for (int i = 0; i < 40; ++i) dots += s.isGround(1.5 + 0.02 * i, 3.5) ? 0 : 1;
    QVERIFY(dots > 8);
    QVERIFY(!s.isGround(3, 3.5 + 12.0 / s.canvas->transform().m11()));  // the flag
  }

  void robotsOnWheelsHaveTheirSizeAndAColorEach() {
    ShownMapView s;
    s.pushTruth({{"p3at1", {2, 3, 0}}, {"p3at2", {6, 3, 0}}}, 1);
    s.pushEstimate("p3at1", {2.1, 3.3, 0.2}, 1);
    s.tick(*s.view);
    const QColor first = s.colorAt(1.85, 3.05), second = s.colorAt(5.85, 3.05);
    QVERIFY(first.red() > first.blue() + 60 && second.blue() > second.red() + 60);
    QVERIFY(s.isGround(5.55, 3) && !s.isGround(6 - 0.28, 3));
    // Only its own program knows where a real robot is: then that is its trail.
    s.session.restart();
    s.push("map", DriveBench::room(), 0);
    for (int i = 0; i < 30; ++i) s.pushEstimate("p3at1", {1 + 0.1 * i, 4, 0}, 1 + 0.2 * i, 0);
    s.tick(*s.view);
    QVERIFY(s.isGround(2, 4));
    click(*s.view, "fieldTrails");
    QVERIFY(!s.isGround(2, 4));
  }

  void showsTheShippedHouse() {
    const auto map = DriveBench::mapOf("resources/scenes/house.map");
    ShownMapView s(map, {840, 660});
    QCOMPARE(s.canvas->map()->lines_size(), 80);
    s.pushTruth({{"p3at1", {2.6, 5.5, 0}}}, 1);
    robotcontrol::DrivePath path;
    for (const auto& [x, y] : {std::pair(2.6, 5.5), {8, 5.5}, {8, 3.2}}) {
      auto& point = *path.add_points_in_field();
      point.set_x(x);
      point.set_y(y);
    }
    path.mutable_goal()->mutable_pose_in_field()->set_x(8);
    path.mutable_goal()->mutable_pose_in_field()->set_y(3.2);
    s.push("p3at1/models/path", path, 1);
    s.tick(*s.view);
    QVERIFY2(!s.isGround(5, 4.5) && !s.isGround(16, 8), "walls");
    QVERIFY2(!s.isGround(5, 5.5), "the path");
    QVERIFY2(s.isGround(14, 2), "the floor of a room");
    keepPicture(*s.view, "map-house");
    for (int i = 0; i < 5; ++i) click(*s.view, "fieldZoomIn");
    s.canvas->setViewport({false, s.canvas->viewport().scale, {12, 8}, 0});
    s.press(12, 8, Qt::ControlModifier);
    s.move(12.8, 8.6);
    s.release(12.8, 8.6);
    QVERIFY(!s.goal().any_heading());
    QVERIFY(std::abs(s.goal().pose_in_field().x() - 12) < 0.05);
  }

  void showsARealBuilding() {
    const auto map = DriveBench::mapOf("../shared/data/arcos/columbia.map");
    if (map.lines_size() == 0) QSKIP("../shared/data/arcos/columbia.map is not there");
    ShownMapView s(map, {760, 900});
    QCOMPARE(s.canvas->map()->points_size(), 2 * 63311);
    s.pushTruth({{"p3at1", {-2, 6, 1.2}}, {"p3at2", {14, 18.4, 3.1}}}, 1);
    s.pushEstimate("p3at1", {-1.8, 5.8, 1.3}, 1, 0.4);
    robotcontrol::DrivePath path;
    for (const auto& [x, y] : {std::pair(-2.0, 6.0), {-1.6, 8.0}, {0.0, 8.4}, {0.2, 17.0}, {1.7, 18.32}}) {
      auto& point = *path.add_points_in_field();
      point.set_x(x);
      point.set_y(y);
    }
    path.mutable_goal()->mutable_pose_in_field()->set_x(1.7);
    path.mutable_goal()->mutable_pose_in_field()->set_y(18.32);
    path.mutable_goal()->set_name("Hallway 1");
    s.push("p3at1/models/path", path, 1);
    s.tick(*s.view);
    keepPicture(*s.view, "map-building");
    for (int i = 0; i < 5; ++i) click(*s.view, "fieldZoomIn");
    s.canvas->setViewport({false, s.canvas->viewport().scale, {0, 8}, 0});
    s.press(0, 10.5, Qt::ControlModifier);
    s.move(0.8, 11.2);
    keepPicture(*s.view, "map-near");
    s.release(0.8, 11.2);
    QVERIFY(!s.goal().any_heading());
  }
};

const GuiTest<MapTest> kMapTest;

}  // namespace widgets::test

#include "MapTest.moc"
