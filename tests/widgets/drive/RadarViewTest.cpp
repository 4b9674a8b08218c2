// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/RadarView.h"

#include <QLabel>
#include <QListView>
#include <QPainter>

#include "foxglove/Scene.pb.h"
#include "tests/widgets/FieldBench.h"
#include "tests/widgets/drive/DriveBench.h"
#include "widgets/RobotChoice.h"
#include "widgets/drive/RadarCanvas.h"

namespace widgets::test {
namespace {

QPalette whitePalette() {
  QPalette palette;
  palette.setColor(QPalette::Base, Qt::white);
  palette.setColor(QPalette::Text, Qt::black);
  return palette;
}

/// 200 by 200 pixels, 25 for a meter, the robot in the middle.
struct Painted {
  Painted(const RadarReadings& readings, bool northUp = false) : heading(readings.heading) {
    look.size = {200, 200};
    look.range = 4;
    look.northUp = northUp;
    QPainter painter(&picture);
    widgets::paintRadar(painter, readings, look, whitePalette());
  }
  QPoint at(double x, double y) const {
    return widgets::robotToWidget(look, heading).map(QPointF(x, y)).toPoint();
  }
  QColor colorAt(double x, double y) const { return picture.pixelColor(at(x, y)); }
  RadarLook look;
  double heading;
  QImage picture{200, 200, QImage::Format_RGB32};
};

RadarReadings::Echo echo(double range, double age) {
  RadarReadings::Echo echo;
  echo.sensorInRobot = {0.2, 0, 0};
  echo.range = range;
  echo.newest = true;
  echo.age = age;
  return echo;
}

bool isBlue(const QColor& color) {
  return color.blue() > color.red() + 25;
}

}  // namespace

class RadarViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anEchoIsWhereItsSonarMeasuredAndFades() {
    RadarReadings readings;
    readings.openingAngle = robotlink::radians(30);
    readings.echoes = {echo(2, 0)};
    const Painted fresh(readings);
    QVERIFY(isBlue(fresh.colorAt(2.2, 0)));
    QVERIFY(isBlue(fresh.colorAt(1.2, 0)));  // the cone, paler
    QVERIFY(!isBlue(fresh.colorAt(2.6, 0.1)));
    QVERIFY(!isBlue(fresh.colorAt(-1.9, 0.1)));
    readings.echoes = {echo(2, 1.8)};
    const Painted old(readings);
    QVERIFY(old.colorAt(2.2, 0).lightness() > fresh.colorAt(2.2, 0).lightness() + 30);
  }

  void aheadIsUpOrAsOnTheMap() {
    RadarReadings readings;
    readings.laser = {{2, 1}};
    QCOMPARE(Painted(readings).at(2, 0), QPoint(100, 50));
    QCOMPARE(Painted(readings, true).at(2, 0), QPoint(150, 100));  // it looks along the map's x
    readings.heading = robotlink::kPi / 2;
    QCOMPARE(Painted(readings, true).at(2, 0), QPoint(100, 50));
    const Painted painted(readings);
    QVERIFY(painted.colorAt(2, 1).red() > painted.colorAt(2, 1).blue() + 60);  // a hit of the laser
  }

  void bumpersAndStallAreRed() {
    RadarReadings readings;
    readings.frontBumpers = {false, true, false};
    readings.rearBumpers = {false, false, false};
    readings.leftStalled = true;
    RadarLook look;
    look.size = {400, 400};
    look.range = 0.5;
    QImage picture(400, 400, QImage::Format_RGB32);
    QPainter painter(&picture);
    widgets::paintRadar(painter, readings, look, whitePalette());
    const auto colorAt = [&](double x, double y) {
      return picture.pixelColor(widgets::robotToWidget(look, 0).map(QPointF(x, y)).toPoint());
    };
    const auto isRed = [](const QColor& color) { return color.red() > color.blue() + 80; };
    QVERIFY(isRed(colorAt(0.28, 0)) && !isRed(colorAt(0.28, 0.16)) && !isRed(colorAt(-0.28, 0)));
    QVERIFY(isRed(colorAt(0.105, 0.19)) && !isRed(colorAt(0.105, -0.19)));  // the left and the right wheel
  }

  void olderEchoesStayWhereTheyWereWhileTheRobotDrives() {
    DriveBench world;
    world.push("p3at1/drive/state", DriveBench::state(), 1);
    world.push("p3at1/range/sonar", world.sonar({{3, 2.0}}), 1);
    auto state = DriveBench::state();
    state.mutable_odometry()->set_x(0.5);
    world.push("p3at1/drive/state", state, 2);
    world.push("p3at1/range/sonar", world.sonar({{3, 1.5}, {12, 5.0}}), 2);
    auto view = world.open<widgets::RadarView>();
    const auto& echoes = child<widgets::RadarCanvas>(*view, "radarCanvas").readings().echoes;
    QCOMPARE(echoes.size(), std::size_t{3});
    const auto x = [](const RadarReadings::Echo& e) {
      return e.sensorInRobot.x + e.range * std::cos(e.sensorInRobot.heading);
    };
    QVERIFY(!echoes[0].newest && echoes[1].newest && echoes[2].nothing);
    QVERIFY(std::abs(echoes[0].age - 1) < 1e-6);
    QVERIFY(std::abs(x(echoes[0]) - x(echoes[1])) < 0.02);  // the same wall
    QCOMPARE(child<QLabel>(*view, "radarNearest").text(), QStringLiteral("nearest: sonar 1.50 m"));
  }

  void aSilentRobotIsPaleAndItsAgeIsShown() {
    DriveBench world;
    auto state = DriveBench::state();
    state.mutable_velocity()->set_x(0.4);
    world.push("p3at1/drive/state", state, 1);
    auto view = world.open<widgets::RadarView>();
    auto& reported = child<QLabel>(*view, "radarState");
    auto& canvas = child<widgets::RadarCanvas>(*view, "radarCanvas");
    QVERIFY(!reported.isVisible());
    const QImage heard = canvas.rendered();
    // Time goes on, the base says nothing.
    world.push("simulation", robotcontrol::SimulationStatus(), 13);
    world.tick(*view);
    QCOMPARE(reported.text(), QStringLiteral("p3at1 last heard 12 s ago"));
    QVERIFY(reported.isVisible());
    QVERIFY(canvas.rendered() != heard);
    world.push("p3at1/drive/state", state, 13.1);
    world.tick(*view);
    QVERIFY(!reported.isVisible());
    QCOMPARE(canvas.rendered(), heard);
  }

  void nothingOfASilentRobotLooksAsIfItWereNow() {
    RadarReadings readings;
    readings.speed = 1;
    readings.laser = {{2, 1}};
    const Painted heard(readings);
    readings.silence = 5;
    const Painted silent(readings);
    QVERIFY(silent.colorAt(2, 1).lightness() > heard.colorAt(2, 1).lightness() + 40);
    QVERIFY(silent.colorAt(0.8, 0) != heard.colorAt(0.8, 0));  // no arrow says where it goes
  }

  void itAsksForItsPackagesOnce() {
    DriveBench world;
    world.pushKeys({"drive/state", "range/sonar", "range/laser", "models/ball"}, 1);
    auto view = world.open<widgets::RadarView>();
    world.tick(*view);
    QCOMPARE(world.requests.size(), std::size_t{3});
    QCOMPARE(world.requests[1].set_key().name(), std::string("package/range/sonar"));
    QCOMPARE(world.requests[1].set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
  }

  void wheelKeysAndButtonsZoom() {
    DriveBench world;
    world.push("p3at1/drive/state", DriveBench::state(), 1);
    auto view = world.open<widgets::RadarView>();
    auto& canvas = child<widgets::RadarCanvas>(*view, "radarCanvas");
    QCOMPARE(child<QLabel>(*view, "radarRange").text(), QStringLiteral("4.0 m around"));
    turnWheel(canvas, {100, 100}, 2);
    QVERIFY(std::abs(canvas.look().range - 4 / 1.44) < 1e-9);
    click(*view, "radarZoomOut");
    QVERIFY(std::abs(canvas.look().range - 4 * std::sqrt(2.0) / 1.44) < 1e-9);
    for (int i = 0; i < 12; ++i) QTest::keyClick(&canvas, Qt::Key_Plus);
    QCOMPARE(canvas.look().range, RadarLook::kMinRange);
    moveMouse(canvas, {canvas.width() / 2, 0});
    QVERIFY(child<QLabel>(*view, "radarCursor").text().endsWith(QStringLiteral("at 0°")));
    QTest::keyClick(&canvas, Qt::Key_N);
    QVERIFY(canvas.look().northUp);
  }

  void whatTheProgramDrawsLiesOnTop() {
    DriveBench world;
    world.push("p3at1/drive/state", DriveBench::state(), 1);
    foxglove::SceneUpdate update;
    auto& entity = *update.add_entities();
    entity.set_id("avoid/goal");
    entity.set_frame_id("p3at1");
    auto& cylinder = *entity.add_cylinders();
    cylinder.mutable_pose()->mutable_position()->set_x(2);
    cylinder.mutable_pose()->mutable_orientation()->set_w(1);
    cylinder.mutable_size()->set_x(0.6);
    cylinder.mutable_size()->set_y(0.6);
    cylinder.mutable_color()->set_r(1);
    cylinder.mutable_color()->set_b(1);
    cylinder.mutable_color()->set_a(1);
    world.push("p3at1/drawings/robot/avoid/goal", update, 1);
    auto view = world.open<widgets::RadarView>();
    auto& canvas = child<widgets::RadarCanvas>(*view, "radarCanvas");
    const QPoint at = widgets::robotToWidget(canvas.look(), 0).map(QPointF(2, 0)).toPoint();
    QVERIFY(isNear(canvas.rendered().pixelColor(at), QColor(255, 0, 255)));
    click(*view, "radarDrawings");
    click(*view, "drawingsNone");
    QVERIFY(!isNear(canvas.rendered().pixelColor(at), QColor(255, 0, 255)));
  }

  void anEmptyRadarSaysWhatToDo() {
    DriveBench world;
    auto view = world.open<widgets::RadarView>();
    const QImage empty = child<widgets::RadarCanvas>(*view, "radarCanvas").grab().toImage();
    world.push("p3at1/drive/state", DriveBench::state(), 1);
    world.tick(*view);
    QVERIFY(child<widgets::RadarCanvas>(*view, "radarCanvas").grab().toImage() != empty);
  }

  void whatWasChosenSurvives() {
    DriveBench world;
    auto view = world.open<widgets::RadarView>();
    click(*view, "radarNorthUp");
    click(*view, "radarZoomIn");
    auto& robot = child<widgets::RobotChoice>(*view, "radarRobot");
    robot.setFocus();
    QTest::keyClick(&robot, Qt::Key_End);
    QCOMPARE(robot.currentText(), QStringLiteral("p3at2"));
    const QJsonObject state = view->saveState();
    auto other = world.open<widgets::RadarView>();
    other->restoreState(state);
    QCOMPARE(other->saveState(), state);
    other->restoreState({});
  }

  void showsAWholePicture() {
    DriveBench world;
    auto state = DriveBench::state();
    state.mutable_velocity()->set_x(0.4);
    state.mutable_velocity()->set_rotation(0.5);
    state.set_front_bumpers(0, true);
    state.set_right_stalled(true);
    for (int i = 0; i < 20; ++i) {
      state.mutable_odometry()->set_x(0.04 * i);
      world.push("p3at1/drive/state", state, 1 + 0.1 * i);
      const int a = i % 8, b = 8 + (i + 3) % 8;
      world.push("p3at1/range/sonar",
                 world.sonar({{a, 1.2 + 0.25 * a - 0.04 * i},
                              {b, b == 12 ? 5.0 : 3.4 - 0.2 * (b - 8) + 0.04 * i},
                              {(a + 4) % 8, 1.9}}),
                 1 + 0.1 * i);
    }
    world.push("p3at1/range/laser", DriveBench::laser([](double angle) {
                 return std::min(1.7 / std::max(0.02, std::abs(std::cos(angle))),
                                 2.1 / std::max(0.02, std::abs(std::sin(angle))));
               }),
               2.9);
    auto view = world.open<widgets::RadarView>({560, 600});
    keepPicture(*view, "radar-view");
    QVERIFY(countNear(child<widgets::RadarCanvas>(*view, "radarCanvas").rendered(), QColor(168, 93, 0), 40) >
            100);
  }
};

const GuiTest<RadarViewTest> kRadarViewTest;

}  // namespace widgets::test

#include "RadarViewTest.moc"
