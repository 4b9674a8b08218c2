// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/RadarPainter.h"

#include <QPainter>
#include <numbers>

#include "tests/widgets/Bench.h"
#include "tests/widgets/GuiTest.h"
#include "widgets/Theme.h"
#include "widgets/drive/RadarReadings.h"

namespace widgets::test {
namespace {

RadarLook squareLook() {
  RadarLook radar;
  radar.size = {400, 400};
  radar.range = 4;
  return radar;
}

QImage radarPicture(const RadarReadings& readings, const RadarLook& radar = squareLook()) {
  QImage picture(radar.size.toSize(), QImage::Format_RGB32);
  picture.fill(QApplication::palette().color(QPalette::Base));
  QPainter painter(&picture);
  paintRadar(painter, readings, radar, QApplication::palette());
  return picture;
}

/// The pixels around a place (m, in the robot's frame) that two pictures do not have in common.
int differencesAt(const QImage& a, const QImage& b, const QPointF& place) {
  const QPoint middle = robotToWidget(squareLook(), 0).map(place).toPoint();
  int count = 0;
  for (int y = middle.y() - 4; y <= middle.y() + 4; ++y) {
    for (int x = middle.x() - 4; x <= middle.x() + 4; ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  }
  return count;
}

}  // namespace

class RadarPainterTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theRobotLooksUpUnlessTheMapDoes() {
    RadarLook radar = squareLook();
    QCOMPARE(radar.scale(), 50.0);
    QCOMPARE(robotToWidget(radar, 1).map(QPointF(1, 0)), QPointF(200, 150));
    QCOMPARE(robotToWidget(radar, 1).map(QPointF(0, 1)), QPointF(150, 200));
    radar.northUp = true;
    const QPointF east = robotToWidget(radar, 0).map(QPointF(1, 0));
    QVERIFY2(std::hypot(east.x() - 250, east.y() - 200) < 1e-6, "heading 0 is to the right of the map");
    const QPointF north = robotToWidget(radar, std::numbers::pi / 2).map(QPointF(1, 0));
    QVERIFY(std::hypot(north.x() - 200, north.y() - 150) < 1e-6);
  }

  void whatTheLaserHitsIsMarkedWhereItIs() {
    RadarReadings readings;
    const QImage before = radarPicture(readings);
    readings.hasLaser = true;
    readings.laser.push_back({2.1, 1.3});
    const QImage after = radarPicture(readings);
    QVERIFY(differencesAt(before, after, {2.1, 1.3}) >= 6);
    QCOMPARE(differencesAt(before, after, {2.1, -1.3}), 0);
  }

  void anEchoIsABandInItsDirectionAndPalesWithItsAge() {
    RadarReadings readings;
    const QImage before = radarPicture(readings);
    RadarReadings::Echo echo;
    echo.sensorInRobot = {0, 0, std::numbers::pi / 2};  // to the left
    echo.range = 2;
    echo.newest = true;
    readings.echoes = {echo};
    const QImage fresh = radarPicture(readings);
    QVERIFY(differencesAt(before, fresh, {0.2, 2}) > 0);
    QCOMPARE(differencesAt(before, fresh, {0.2, -2}), 0);
    readings.echoes[0].age = 1.9;
    const QImage old = radarPicture(readings);
    const QColor note = colorOf(Meaning::kNote, QApplication::palette());
    QVERIFY(countNear(fresh, note, 60) > countNear(old, note, 60));
  }

  void pressedBumpersAndStalledWheelsAreRed() {
    const QColor bad = colorOf(Meaning::kBad, QApplication::palette());
    RadarReadings readings;
    readings.frontBumpers = {false, false, false};
    QCOMPARE(countNear(radarPicture(readings), bad, 10), 0);
    readings.frontBumpers[1] = true;
    const int pressed = countNear(radarPicture(readings), bad, 10);
    QVERIFY(pressed > 0);
    readings.leftStalled = true;
    QVERIFY(countNear(radarPicture(readings), bad, 10) > pressed);
  }

  void aSilentRobotIsPale() {
    const QColor bad = colorOf(Meaning::kBad, QApplication::palette());
    RadarReadings readings;
    readings.frontBumpers = {true, true, true};
    QVERIFY(countNear(radarPicture(readings), bad, 10) > 0);
    readings.silence = 5;
    QCOMPARE(countNear(radarPicture(readings), bad, 10), 0);
  }
};

const GuiTest<RadarPainterTest> kRadarPainterTest;

}  // namespace widgets::test

#include "RadarPainterTest.moc"
