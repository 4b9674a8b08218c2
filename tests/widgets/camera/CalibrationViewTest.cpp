// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/CalibrationView.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListView>
#include <QSlider>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>
#include <QToolButton>

#include "robotcontrol/Sensing.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/robotlink/calibration/BoardPicture.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/image/ImageCanvas.h"

namespace widgets::test {

using robotlink::test::boardPicture;
using robotlink::test::boardPoses;
using robotlink::test::cameraAt;
using robotlink::test::pixelOf;

namespace {

const robotlink::LensModel kPictureLens{320, 240, 300, 300, 160, 120};
constexpr char kCalibratedStream[] = "red1/camera/image";

class CameraScene : public FieldBench {
 public:
  void show(const robotlink::Image& image) {
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, image.view(), now(), "camera");
    push(kCalibratedStream, message);
    advance();
  }
  void showBoard(const robotlink::Pose3& camera) { show(boardPicture({}, camera, kPictureLens)); }
  /// Ticks until it holds.
  template <typename Condition>
  bool until(View& view, Condition condition) {
    return QTest::qWaitFor([&] {
      tick(view);
      return condition();
    });
  }
  bool untilText(View& view, const char* label, const QString& part) {
    return until(view, [&] { return child<QLabel>(view, label).text().contains(part); });
  }
};

}  // namespace

class CalibrationViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aLensIsCalibratedByViewsThatAreTakenByItself() {
    CameraScene bench;
    auto view = bench.open<CalibrationView>({900, 500});
    auto& list = child<QListView>(*view, "lensViews");
    child<QAction>(*view, "lensAutomaticAction").setChecked(true);
    for (const robotlink::Pose3& pose : boardPoses()) {
      const int before = list.model()->rowCount();
      bench.showBoard(pose);
      QVERIFY(bench.until(*view, [&] { return list.model()->rowCount() > before; }));
    }
    QVERIFY(bench.untilText(*view, "lensResult", QStringLiteral("Opening angles 56.")));
    QVERIFY(list.model()->index(0, 0).data().toString().endsWith(QStringLiteral("px")));
    // The same view again adds nothing.
    const int count = list.model()->rowCount();
    bench.showBoard(boardPoses().back());
    QVERIFY(bench.untilText(*view, "cameraState", QStringLiteral("a board is seen")));
    QTest::qWait(50);
    bench.tick(*view);
    QCOMPARE(list.model()->rowCount(), count);
    keepPicture(*view, "camera-lens");
    list.setCurrentIndex(list.model()->index(0, 0));
    child<QAction>(*view, "lensRemoveAction").trigger();
    QCOMPARE(list.model()->rowCount(), count - 1);
    QVERIFY(bench.untilText(*view, "lensResult", QStringLiteral("Opening angles")));
    child<QAction>(*view, "lensClearAction").trigger();
    QVERIFY(!child<QAction>(*view, "lensUseAction").isEnabled());
  }

  void settingsAreChangedBySlidersAndNumbers() {
    CameraScene bench;
    auto view = bench.open<CalibrationView>({900, 500});
    child<QTabWidget>(*view, "cameraTabs").setCurrentIndex(2);
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "settingsNone").isVisible());
    auto settings = std::make_shared<robotcontrol::CameraSettings>();
    const auto add = [&](const char* name, const char* title, double value, double maximum, double step) {
      auto& setting = *settings->add_settings();
      setting.set_name(name), setting.set_title(title), setting.set_value(value);
      setting.set_maximum(maximum), setting.set_step(step);
    };
    add("exposure", "Exposure", 1, 4, 0.05);
    add("auto_focus", "Auto focus", 1, 1, 1);
    bench.push("red1/camera/settings", settings);
    bench.advance();
    bench.tick(*view);
    QVERIFY(!child<QLabel>(*view, "settingsNone").isVisible());
    auto& exposure = child<QDoubleSpinBox>(*view, "setting/exposure");
    QCOMPARE(exposure.value(), 1.0);
    QCOMPARE(exposure.decimals(), 2);
    auto& focus = child<QCheckBox>(*view, "setting/auto_focus");
    QVERIFY(focus.isChecked());
    keepPicture(*view, "camera-settings");
    child<QSlider>(*view, "setting/exposure/slider").setValue(30);
    QCOMPARE(bench.requests.back().set_camera().setting(), std::string("exposure"));
    QCOMPARE(bench.requests.back().set_camera().value(), 1.5);
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    QCOMPARE(exposure.value(), 1.5);
    // What comes meanwhile is older.
    bench.tick(*view);
    QCOMPARE(exposure.value(), 1.5);
    focus.click();
    QCOMPARE(bench.requests.back().set_camera().setting(), std::string("auto_focus"));
    QCOMPARE(bench.requests.back().set_camera().value(), 0.0);
    child<QAction>(*view, "cameraResetAction").trigger();
    QCOMPARE(exposure.value(), 0.0);
  }

  void rowsKeepTheirHeightsInALowDock() {
    CameraScene bench;
    auto view = bench.open<CalibrationView>({700, 220});
    const auto& number = child<QSpinBox>(*view, "lensColumns");
    QVERIFY2(number.height() >= number.minimumSizeHint().height(),
             qPrintable(QString::number(number.height())));
  }

  void withoutABoardNothingIsTaken() {
    CameraScene bench;
    auto view = bench.open<CalibrationView>();
    bench.show(robotlink::Image(320, 240, robotlink::PixelFormat::kYuyv));
    QVERIFY(bench.untilText(*view, "cameraState", QStringLiteral("no board is seen")));
    child<QAction>(*view, "lensTakeAction").trigger();
    QCOMPARE(child<QListView>(*view, "lensViews").model()->rowCount(), 0);
    QVERIFY(child<QLabel>(*view, "lensOutcome").text().contains(QStringLiteral("not seen")));
    // A board that looks the same from all sides says what is wrong with it.
    child<QSpinBox>(*view, "lensColumns").setValue(6);
    QVERIFY(bench.untilText(*view, "cameraState", QStringLiteral("different numbers of rows and columns")));
  }

  void aPlaceIsCalibratedByMarksThatAreClicked() {
    CameraScene bench;
    robotcontrol::CameraPose pose;
    pose.set_horizontal_angle(kPictureLens.horizontalAngle());
    bench.push("red1/camera/pose", std::make_shared<robotcontrol::CameraPose>(pose));
    auto view = bench.open<CalibrationView>({900, 500});
    bench.show(robotlink::Image(320, 240, robotlink::PixelFormat::kRgb8));
    child<QTabWidget>(*view, "cameraTabs").setCurrentIndex(1);
    bench.tick(*view);
    auto& canvas = child<ImageCanvas>(*view, "imageCanvas");
    auto& table = child<QTableView>(*view, "placeMarks");
    const auto place = cameraAt({0.5, 0.2, 1.4}, 0.1, 0.6, 0.05);
    int clicked = 0;
    for (int row = 0; row < table.model()->rowCount(); ++row) {
      const auto mark = fieldMarks(*bench.context.field)[static_cast<std::size_t>(row)];
      const robotlink::Vector2 pixel = pixelOf(mark.place, place, kPictureLens);
      const bool isAhead = (place.inverse() * mark.place).x() > 0;
      if (!isAhead || pixel.x() < 5 || pixel.y() < 5 || pixel.x() > 315 || pixel.y() > 235) continue;
      table.selectRow(row);
      QTest::mouseClick(&canvas, Qt::LeftButton, {},
                        canvas.transform().map(QPointF(pixel.x(), pixel.y())).toPoint());
      ++clicked;
    }
    QVERIFY2(clicked >= 4, "too few marks are seen");
    QVERIFY(bench.untilText(*view, "placeResult", QStringLiteral("Height 1.")));
    const QString result = child<QLabel>(*view, "placeResult").text();
    QVERIFY2(result.contains(QStringLiteral("On the field at 0.")), qPrintable(result));
    keepPicture(*view, "camera-place");
    // What was clicked is kept.
    const QJsonObject state = view->saveState();
    auto other = bench.open<CalibrationView>();
    other->restoreState(state);
    QCOMPARE(other->saveState(), state);
    // Also by a view that was there before the field.
    const auto field = std::exchange(bench.context.field, nullptr);
    auto early = bench.open<CalibrationView>();
    early->restoreState(state);
    QCOMPARE(child<QTableView>(*early, "placeMarks").model()->rowCount(), 0);
    QCOMPARE(early->saveState(), state);
    bench.context.field = field;
    bench.tick(*early);
    QVERIFY(child<QTableView>(*early, "placeMarks").model()->rowCount() > 0);
    QCOMPARE(early->saveState(), state);
    child<QAction>(*view, "placeClearAction").trigger();
    QVERIFY(!child<QAction>(*view, "placeUseAction").isEnabled());
    // Without a selected mark a click picks nothing.
    table.selectionModel()->clear();
    QTest::mouseClick(&canvas, Qt::LeftButton, {}, canvas.rect().center());
    QVERIFY(child<QLabel>(*view, "placeOutcome").text().contains(QStringLiteral("Select a mark")));
  }

  void aBoardOnTheGroundTellsThePlaceAndParametersAreSet() {
    CameraScene bench;
    auto view = bench.open<CalibrationView>({900, 500});
    child<QTabWidget>(*view, "cameraTabs").setCurrentIndex(1);
    child<QComboBox>(*view, "placeBy").setCurrentIndex(1);
    bench.showBoard(boardPoses()[1]);
    QVERIFY(bench.untilText(*view, "cameraState", QStringLiteral("a board is seen")));
    child<QAction>(*view, "placeTakeAction").trigger();
    QVERIFY(child<QLabel>(*view, "placeResult").text().contains(QStringLiteral("Calibrate the lens")));
    robotcontrol::CameraPose pose;
    pose.set_horizontal_angle(kPictureLens.horizontalAngle());
    bench.push("red1/camera/pose", std::make_shared<robotcontrol::CameraPose>(pose));
    bench.advance();
    child<QAction>(*view, "placeTakeAction").trigger();
    QVERIFY(bench.untilText(*view, "placeResult", QStringLiteral("Height 0.3")));
    // The robot has no solution of camera-pose yet.
    child<QAction>(*view, "placeUseAction").trigger();
    QVERIFY(child<QLabel>(*view, "placeOutcome").text().contains(QStringLiteral("mounted")));
  }

  void withoutARobotItSaysHowToGetOne() {
    Bench bench({.robots = {}});
    auto view = bench.open<CalibrationView>();
    keepPicture(*view, "camera-empty");
    QVERIFY(!child<QAction>(*view, "lensUseAction").isEnabled());
    QVERIFY(!child<QAction>(*view, "placeUseAction").isEnabled());
  }
};

const GuiTest<CalibrationViewTest> kCalibrationViewTest;

}  // namespace widgets::test

#include "CalibrationViewTest.moc"
