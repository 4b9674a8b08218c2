// SPDX-License-Identifier: GPL-3.0-or-later
// Comparing and measuring in the view of images, as a user does it.
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSlider>
#include <QTest>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/image/CompareRow.h"
#include "widgets/image/FloorPoint.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageComparison.h"
#include "widgets/image/ImageStreamView.h"
#include "widgets/picture/Measurement.h"

namespace widgets::test {
namespace {

constexpr robotlink::YCbCr kLow{50, 128, 128}, kHigh{200, 128, 128};
const QSize kToolImage(80, 60);

/// Two cameras: red1's is dark, blue1's is bright with a dark pixel.
struct TwoImages {
  FieldBench world;
  ImageStreamView view{world.context};
  ImageCanvas* canvas = &child<ImageCanvas>(view, "imageCanvas");

  TwoImages() {
    world.session.setRobots({"red1", "blue1"});
    view.resize(900, 500);
    view.show();
    if (!QTest::qWaitForWindowActive(&view)) qFatal("the view's window never became active");
    world.pushImage("red1/camera/image", kToolImage, kLow);
    world.pushImage("blue1/camera/image", kToolImage, kHigh, {10, 5}, kLow);
    step();
  }
  void step() {
    world.advance();
    view.tick();
  }
  /// Chooses the second stream and the mode in the row, as with the keyboard.
  void compareWith(const QString& stream, int mode) {
    if (!child<QAction>(view, "imageCompareAction").isChecked()) click(view, "imageCompare");
    auto& streams = child<QComboBox>(view, "imageCompareStream");
    streams.setFocus();
    QTest::keyClick(&streams, Qt::Key_Home);
    for (int i = 0; i < streams.count() && streams.currentData().toString() != stream; ++i)
      QTest::keyClick(&streams, Qt::Key_Down);
    child<QComboBox>(view, "imageCompareMode").setCurrentIndex(mode);
    step();
  }
  int grayAt(double x, double y) const {
    return qGray(canvas->picture().pixels.pixel(static_cast<int>(x), static_cast<int>(y)));
  }
  QPoint at(double x, double y) const { return canvas->transform().map(QPointF(x, y)).toPoint(); }
  void clickAt(double x, double y) { QTest::mouseClick(canvas, Qt::LeftButton, {}, at(x, y)); }
  QString text(const char* label) const { return child<QLabel>(view, label).text(); }
};

int grayOf(robotlink::YCbCr color) {
  const auto rgb = robotlink::toRgb(color);
  return qGray(rgb.r, rgb.g, rgb.b);
}

}  // namespace

class ImageToolsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void twoImagesAreShownBesideEachOther() {
    TwoImages s;
    s.compareWith(QStringLiteral("blue1/camera/image"), 0);
    QVERIFY(s.canvas->second().has_value());
    QCOMPARE(s.canvas->second()->pixels.size(), kToolImage);
    const QImage shown = s.canvas->grab().toImage();
    QVERIFY(std::abs(qGray(shown.pixel(shown.width() / 4, shown.height() / 2)) - grayOf(kLow)) < 6);
    QVERIFY(std::abs(qGray(shown.pixel(shown.width() * 3 / 4, shown.height() / 2)) - grayOf(kHigh)) < 6);
    keepPicture(s.view, "image-side-by-side");
    // Both show the same part: the cursor in the right one is at the same pixel.
    const QPoint right = s.at(10.5, 5.5) + QPoint(s.canvas->width() / 2 + 2, 0);
    moveMouse(*s.canvas, right);
    QVERIFY2(s.text("imagePixel").contains(QStringLiteral("x  10  y   5")), qPrintable(s.text("imagePixel")));
    QVERIFY(s.text("imagePixel").contains(QStringLiteral("second R")));
    click(s.view, "imageCompare");
    QVERIFY(!s.canvas->second().has_value());
  }

  void aHighViewShowsThemAboveEachOther() {
    TwoImages s;
    s.view.resize(400, 900);
    s.compareWith(QStringLiteral("blue1/camera/image"), 0);
    const QImage shown = s.canvas->grab().toImage();
    QVERIFY(std::abs(qGray(shown.pixel(shown.width() / 2, shown.height() / 4)) - grayOf(kLow)) < 6);
    QVERIFY(std::abs(qGray(shown.pixel(shown.width() / 2, shown.height() * 3 / 4)) - grayOf(kHigh)) < 6);
  }

  void theSliderBlendsThem() {
    TwoImages s;
    s.compareWith(QStringLiteral("blue1/camera/image"), 1);
    auto& slider = child<QSlider>(s.view, "imageCompareBlend");
    QVERIFY(slider.isVisible());
    QVERIFY(std::abs(s.grayAt(40, 30) - (grayOf(kLow) + grayOf(kHigh)) / 2) < 4);
    slider.setFocus();
    QTest::keyClick(&slider, Qt::Key_End);
    QVERIFY(std::abs(s.grayAt(40, 30) - grayOf(kHigh)) < 3);
    QTest::keyClick(&slider, Qt::Key_Home);
    QVERIFY(std::abs(s.grayAt(40, 30) - grayOf(kLow)) < 3);
  }

  void theDifferenceIsBlackWhereBothAreTheSame() {
    TwoImages s;
    s.compareWith(QStringLiteral("blue1/camera/image"), 2);
    auto& gain = child<QSlider>(s.view, "imageCompareGain");
    QVERIFY(gain.isVisible());
    gain.setValue(1);
    QVERIFY(std::abs(s.grayAt(40, 30) - (grayOf(kHigh) - grayOf(kLow))) < 3);
    QCOMPARE(s.grayAt(10, 5), 0);
    gain.setValue(16);
    QCOMPARE(s.grayAt(40, 30), 255);
    keepPicture(s.view, "image-difference");
  }

  void anotherTimeOfTheSameStream() {
    TwoImages s;
    for (int i = 0; i < 10; ++i) {
      s.world.pushImage("red1/camera/image", kToolImage, kHigh);
      s.step();
    }
    s.compareWith(QStringLiteral("red1/camera/image"), 2);
    child<QSlider>(s.view, "imageCompareGain").setValue(1);
    QCOMPARE(s.grayAt(40, 30), 0);
    auto& shift = child<QDoubleSpinBox>(s.view, "imageCompareShift");
    shift.setFocus();
    shift.setValue(-0.4);
    s.step();
    QVERIFY(std::abs(s.grayAt(40, 30) - (grayOf(kHigh) - grayOf(kLow))) < 3);
    shift.setValue(-50);
    s.step();
    QVERIFY2(s.grayAt(40, 30) > 100, "the first image alone: there is no second one of that time");
  }

  void aHeldImageStaysWhileTheFirstGoesOn() {
    TwoImages s;
    s.compareWith(QStringLiteral("red1/camera/image"), 2);
    child<QSlider>(s.view, "imageCompareGain").setValue(1);
    QCOMPARE(s.grayAt(40, 30), 0);
    click(s.view, "imageCompareHold");
    s.world.pushImage("red1/camera/image", kToolImage, kHigh);
    s.step();
    QVERIFY(std::abs(s.grayAt(40, 30) - (grayOf(kHigh) - grayOf(kLow))) < 3);
    s.world.session.restart();  // a log was moved
    s.world.pushImage("red1/camera/image", kToolImage, kHigh);
    s.step();
    QVERIFY(std::abs(s.grayAt(40, 30) - (grayOf(kHigh) - grayOf(kLow))) < 3);
  }

  void theComparisonIsKeptWithTheLayout() {
    TwoImages s;
    s.compareWith(QStringLiteral("blue1/camera/image"), 1);
    child<QSlider>(s.view, "imageCompareBlend").setValue(100);
    const QJsonObject state = s.view.saveState();
    ImageStreamView other(s.world.context);
    other.restoreState(state);
    other.tick();
    QVERIFY(child<QAction>(other, "imageCompareAction").isChecked());
    QVERIFY(std::abs(qGray(child<ImageCanvas>(other, "imageCanvas").picture().pixels.pixel(40, 30)) -
                     grayOf(kHigh)) < 3);
  }

  void drawingsOfALoggedRobotAreItsOwn() {
    QCOMPARE(drawingRobot("red1/camera/image"), std::string("red1"));
    QCOMPARE(drawingRobot("red1/logged/images/segmented"), std::string("red1/logged"));
    QCOMPARE(drawingRobot("red1"), std::string("red1"));
  }

  void aScaledImageIsCompared() {
    QImage large(8, 8, QImage::Format_RGB32), small(4, 4, QImage::Format_RGB32);
    large.fill(Qt::white);
    small.fill(Qt::black);
    QCOMPARE(blended(large, small, 1).size(), QSize(8, 8));
    QCOMPARE(qGray(blended(large, small, 1).pixel(7, 7)), 0);
    QCOMPARE(qGray(difference(large, small, 1).pixel(7, 7)), 255);
    QCOMPARE(statisticsOf(large, small).share, 1.0);
    QCOMPARE(statisticsOf(large, large).largest, 0);
  }

  void distanceAndColorsAreMeasured() {
    TwoImages s;
    click(s.view, "imageMeasure");
    QVERIFY(child<QWidget>(s.view, "imageMeasureBar").isVisible());
    s.clickAt(10.5, 20.5);
    s.clickAt(40.5, 60 - 0.5);
    const QString text = s.text("imageMeasureText");
    QVERIFY2(text.contains(QStringLiteral("A (10, 20) ")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("B (40, 59) ")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("AB 49.2 px (30, 39), -52.4°")), qPrintable(text));
    const auto rgb = robotlink::toRgb(kLow);
    QVERIFY(text.contains(QColor(rgb.r, rgb.g, rgb.b).name()));
    QVERIFY2(!text.contains(QStringLiteral("floor")), "the camera's pose is not known");
    keepPicture(s.view, "image-measure");
    s.clickAt(70.5, 20.5);
    QVERIFY2(s.text("imageMeasureText").contains(QStringLiteral("angle at B 75.1°")),
             qPrintable(s.text("imageMeasureText")));
    click(s.view, "imageMeasureCopy");
    QCOMPARE(QApplication::clipboard()->text(), s.text("imageMeasureText"));
    s.clickAt(5.5, 5.5);
    QVERIFY2(!s.text("imageMeasureText").contains(QStringLiteral("B (")), "a fourth click starts over");
  }

  void aDragMeasuresAndEscapeEndsIt() {
    TwoImages s;
    const QPointF before = s.canvas->viewport().center;
    s.canvas->setFocus();
    QTest::keyClick(s.canvas, Qt::Key_L);
    drag(*s.canvas, Qt::LeftButton, s.at(10.5, 10.5), s.at(20.5, 10.5));
    QVERIFY2(s.text("imageMeasureText").contains(QStringLiteral("AB 10.0 px (10, 0), 0.0°")),
             qPrintable(s.text("imageMeasureText")));
    QCOMPARE(s.canvas->viewport().center, before);
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QVERIFY(child<QAction>(s.view, "imageMeasureAction").isChecked());
    QVERIFY(!child<QAction>(s.view, "imageMeasureCopyAction").isEnabled());
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QVERIFY(!child<QAction>(s.view, "imageMeasureAction").isChecked());
    QVERIFY(!child<QWidget>(s.view, "imageMeasureBar").isVisible());
    s.clickAt(5.5, 5.5);
    QVERIFY(s.text("imageMeasureText").isEmpty() || !child<QWidget>(s.view, "imageMeasureBar").isVisible());
  }

  void thePlaceOnTheFloorNeedsTheCamerasPose() {
    TwoImages s;
    auto camera = std::make_shared<robotcontrol::CameraPose>();
    camera->mutable_camera_in_robot()->mutable_position()->set_z(0.2);
    // Tilted down by 45 degrees.
    camera->mutable_camera_in_robot()->mutable_orientation()->set_y(std::sin(M_PI / 8));
    camera->mutable_camera_in_robot()->mutable_orientation()->set_w(std::cos(M_PI / 8));
    camera->set_horizontal_angle(1);
    camera->set_vertical_angle(0.8);
    s.world.push("red1/camera/pose", camera);
    s.world.pushImage("red1/camera/image", kToolImage, kLow);
    s.step();
    // The optical axis meets the floor as far away as the camera is high.
    const auto middle = floorPoint(*camera, QSizeF(kToolImage), {40, 30});
    QVERIFY(middle.has_value());
    QVERIFY(std::abs(middle->x() - 0.2) < 1e-6 && std::abs(middle->y()) < 1e-6);
    const auto left = floorPoint(*camera, QSizeF(kToolImage), {0, 30});
    QVERIFY(left.has_value() && left->y() > 0.1);
    robotcontrol::CameraPose level = *camera;
    level.mutable_camera_in_robot()->mutable_orientation()->set_y(0);
    level.mutable_camera_in_robot()->mutable_orientation()->set_w(1);
    QVERIFY2(!floorPoint(level, QSizeF(kToolImage), {40, 20}), "it is above the horizon");
    click(s.view, "imageMeasure");
    s.clickAt(39.5, 29.5);
    s.clickAt(39.5, 50.5);
    const QString text = s.text("imageMeasureText");
    QVERIFY2(
        text.contains(QStringLiteral("A (39, 29) ")) && text.contains(QStringLiteral(" on the floor (2")),
        qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral(" mm ")), qPrintable(text));
  }

  void anglesAndDirectionsAreComputed() {
    QCOMPARE(angleAt({{1, 0}, {0, 0}, {0, 1}}), M_PI / 2);
    QCOMPARE(angleAt({{1, 0}, {0, 0}}), 0.0);
    QCOMPARE(directionDeg({0, 0}, {0, 1}, false), 90.0);
    QCOMPARE(directionDeg({0, 0}, {0, 1}, true), -90.0);
    QCOMPARE(directionDeg({0, 0}, {-1, 0}, false), 180.0);
  }

  void aTipNamesTheDrawingsUnderTheCursor() {
    TwoImages s;
    s.world.pushFrame({imageDrawing("ball-percept/circle", [](robotlink::ImageDrawing& d) {
      d.circle({20, 30}, 5, robotlink::colors::kPink, 1, robotlink::colors::kPink);
      d.dot({60.5, 10.5}, robotlink::colors::kBlue, 6);
    })});
    s.step();
    const QString circle = shownTip(*s.canvas, s.at(20, 30));
    QVERIFY2(circle.contains(QStringLiteral("<b>circle</b>")) &&
                 circle.contains(QStringLiteral("robot red1, debug key ball-percept/circle")) &&
                 circle.contains(QStringLiteral("circle at (20.0, 30.0), diameter 10.0")),
             qPrintable(circle));
    QVERIFY(shownTip(*s.canvas, s.at(60.5, 10.5)).contains(QStringLiteral("point (60.5, 10.5)")));
    QVERIFY(!shownTip(*s.canvas, s.at(70, 50)).contains(QStringLiteral("ball-percept")));
  }
};

const GuiTest<ImageToolsTest> kImageToolsTest;

}  // namespace widgets::test

#include "ImageToolsTest.moc"
