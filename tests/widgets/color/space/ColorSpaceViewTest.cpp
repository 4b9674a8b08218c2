// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <set>

#include "tests/widgets/CameraBench.h"
#include "widgets/color/space/ColorSpaceCanvas.h"
#include "widgets/color/space/ColorSpaceView.h"

namespace widgets::test {
namespace {

using colortool::CellSet;
using colortool::ColorTable;

// The middles of the world's four quarters (SampleFixture.h).
constexpr robotlink::YCbCr kOrangeColor{140, 60, 200}, kGreen{90, 110, 90}, kWhite{220, 128, 128};

/// The view on a bench with a stroke of orange and one of green.
struct ShownSpace {
  CameraBench world;
  ColorBench& bench = colorBench(world.context);
  ColorSpaceView view{world.context};
  ColorSpaceCanvas* canvas = &child<ColorSpaceCanvas>(view, "colorSpaceCanvas");

  explicit ShownSpace(bool withColors = true) {
    view.resize(560, 420);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
    if (!withColors) return;
    // Near black and white shades of all colors meet, which is not what is looked at here.
    colortool::Samples samples = bench.samples();
    samples.settings.votes.shading = 0;
    bench.setDocument(samples);
    bench.setFrame(world.frame());
    stroke("orange", 8, 7);
    stroke("green", 30, 7);
    if (!step()) qFatal("no picture");
  }
  void stroke(const char* name, double x, double y) {
    bench.setCurrentClass(bench.samples().classes.index(name));
    const colortool::ImagePoint at[] = {{x, y}};
    bench.addStroke(colortool::brushArea(40, 30, at, 3), "brush");
  }
  /// Waits, at true thread boundaries, for the picture of what there is now.
  bool step() {
    if (!QTest::qWaitFor([this] { return bench.upToDate(); })) return false;
    for (int i = 0; i < 4; ++i) view.tick();
    return QTest::qWaitFor([this] { return canvas->upToDate(); });
  }
  QImage picture() const { return canvas->picture().image.copy(); }
  QPoint at(robotlink::YCbCr color) const { return canvas->pointOf(ColorTable::cellOf(color))->toPoint(); }
  QColor classColor(const char* name) const {
    const auto rgb = bench.samples().classes.shownColor(bench.samples().classes.index(name));
    return {rgb.r, rgb.g, rgb.b};
  }
  /// Whether a pixel has the hue of a class, and color enough to have one.
  bool looksLike(const QColor& color, const char* className) const {
    const int apart = std::abs(color.hue() - classColor(className).hue());
    return color.alpha() > 60 && color.saturation() > 100 && std::min(apart, 360 - apart) < 12;
  }
  int countLike(const char* className) const {
    const QImage image = canvas->picture().image;
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) count += looksLike(image.pixelColor(x, y), className) ? 1 : 0;
    }
    return count;
  }
  bool orangeIsInItsPlace() const { return looksLike(picture().pixelColor(at(kOrangeColor)), "orange"); }
  void toggleClass(const char* name) {
    auto* list = &child<QListWidget>(view, "colorSpaceClasses");
    const int row = bench.samples().classes.index(name);
    const QRect item = list->visualItemRect(list->item(row));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, item.topLeft() + QPoint(10, item.height() / 2));
  }
  /// A lasso around a place.
  void lasso(const QPoint& middle, int side = 30, Qt::KeyboardModifiers more = {}) {
    const auto keys = Qt::ShiftModifier | more;
    const QPoint corners[] = {{-side, -side}, {side, -side}, {side, side}, {-side, side}};
    QTest::mousePress(canvas, Qt::LeftButton, keys, middle + corners[0]);
    for (const QPoint& corner : corners) moveMouse(*canvas, middle + corner, Qt::LeftButton, keys);
    QTest::mouseRelease(canvas, Qt::LeftButton, keys, middle + corners[3]);
  }
  void toggle(const char* button) { click(view, button); }
  /// An image of a real robot, and a stroke in each class of its labels.
  bool learnFromARealRobot() {
    const QString folder = QStringLiteral(ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour/bhuman2009/");
    QFile file(QDir(folder + QStringLiteral("yuyv")).filePath(QStringLiteral("000.yuyv")));
    const QImage labels =
        QImage(folder + QStringLiteral("labels/000.png")).convertToFormat(QImage::Format_Grayscale8);
    if (labels.isNull() || !file.open(QIODevice::ReadOnly)) return false;
    robotlink::Image image(640, 240,  // each of the log's pixels has two values of Y
                           robotlink::PixelFormat::kYuyv);
    const QByteArray bytes = file.readAll();
    std::copy_n(bytes.begin(), std::min<std::size_t>(image.data.size(), std::size_t(bytes.size())),
                image.data.begin());
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, image.view(), {}, "camera");
    bench.setFrame(std::make_shared<ColorFrame>(message, CameraBench::kStream, "", world.now()));
    constexpr std::pair<int, const char*> kLabels[] = {
        {1, "orange"}, {3, "blue"}, {4, "white"}, {5, "green"}};
    for (const auto& [label, name] : kLabels) {
      colortool::PixelArea area;
      for (int y = 0; y < 240; ++y) {
        for (int x = 0; x < 320; x += 2) {
          if (labels.constScanLine(y)[x] == label && (x + y) % 16 == 0) area.push_back({y, 2 * x, 2 * x + 2});
        }
      }
      bench.setCurrentClass(bench.samples().classes.index(name));
      bench.addStroke(area, "brush");
    }
    return true;
  }
  /// Pictures for people to look at.
  void keep(const char* name) {
    for (int i = 0; i < 8; ++i) view.tick();
    if (!step()) qFatal("no picture");
    for (int i = 0; i < 8; ++i) view.tick();
    if (!step()) qFatal("no picture");
    keepPicture(view, qPrintable(QStringLiteral("color-space-") + QLatin1String(name)));
  }
  bool hasSelected(robotlink::YCbCr color) const {
    return bench.hasSelection() && bench.selection().contains(ColorTable::cellOf(color));
  }
};

}  // namespace

class ColorSpaceViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutColorsItIsSaidWhatToDo() {
    ShownSpace s(false);
    QVERIFY(s.step());
    auto* hint = &child<QLabel>(*s.canvas, "emptyHint");
    QVERIFY(hint->isVisible() && hint->text().contains(QStringLiteral("draw strokes")));
    s.bench.setFrame(s.world.frame());
    QVERIFY(s.step());
    QVERIFY(!hint->isVisible());
  }

  void pixelsAreSeenInTheirOwnColorWhereTheyAre() {
    ShownSpace s;
    s.toggle("colorSpaceTable");
    s.toggle("colorSpaceSamples");
    QVERIFY(s.step());
    const robotlink::Rgb white = robotlink::toRgb(kWhite);
    QVERIFY(isNear(s.picture().pixelColor(s.at(kWhite)), QColor(white.r, white.g, white.b)));
    s.toggle("colorSpacePixels");
    QVERIFY(s.step());
    QCOMPARE(s.picture().pixelColor(s.at(kWhite)).alpha(), 0);
  }

  void samplesAndSurfacesHaveTheirClassesColor() {
    ShownSpace s;
    QVERIFY(s.orangeIsInItsPlace());
    s.toggle("colorSpacePixels");
    s.toggle("colorSpaceSamples");
    QVERIFY(s.step());
    QVERIFY(s.countLike("orange") > 300);
    QVERIFY(s.countLike("green") > 300);
    s.toggle("colorSpaceTable");
    QVERIFY(s.step());
    QCOMPARE(s.countLike("orange"), 0);
  }

  void aClassThatIsOffIsNotSeen() {
    ShownSpace s;
    const int orange = s.countLike("orange"), green = s.countLike("green");
    s.toggleClass("orange");
    QVERIFY(s.step());
    QCOMPARE(s.countLike("orange"), 0);
    QVERIFY(std::abs(s.countLike("green") - green) < green / 5);
    s.toggleClass("orange");
    QVERIFY(s.step());
    QCOMPARE(s.countLike("orange"), orange);
    click(s.view, "colorSpaceNoClasses");
    QVERIFY(s.step());
    QCOMPARE(s.countLike("green"), 0);
    click(s.view, "colorSpaceAllClasses");
    QVERIFY(s.step());
    QCOMPARE(s.countLike("orange"), orange);
  }

  void draggingTurnsAndKeysTurnAndReset() {
    ShownSpace s;
    const QImage before = s.picture();
    const QPoint orange = s.at(kOrangeColor);
    drag(*s.canvas, Qt::LeftButton, {200, 150}, {260, 170});
    QVERIFY(s.step());
    QVERIFY(s.picture() != before && s.at(kOrangeColor) != orange);
    QVERIFY(s.orangeIsInItsPlace());
    QVERIFY(!s.bench.hasSelection());
    QTest::keyClick(s.canvas, Qt::Key_Home);
    QVERIFY(s.step());
    QCOMPARE(s.canvas->camera(), ColorSpaceCamera());
    QCOMPARE(s.picture(), before);
    QTest::keyClick(s.canvas, Qt::Key_Left);
    QVERIFY(s.step());
    QVERIFY(s.picture() != before);
    QTest::mouseDClick(s.canvas, Qt::LeftButton, {}, {50, 50});
    QCOMPARE(s.canvas->camera(), ColorSpaceCamera());
  }

  void theWheelZoomsToTheCursorAndTheRightButtonMoves() {
    ShownSpace s;
    const QPoint before = s.at(kOrangeColor);
    turnWheel(*s.canvas, before, 3);
    QVERIFY(s.canvas->camera().zoom > 1.5);
    QVERIFY((s.at(kOrangeColor) - before).manhattanLength() < 60);
    QTest::keyClick(s.canvas, Qt::Key_Minus);
    QTest::keyClick(s.canvas, Qt::Key_Home);
    drag(*s.canvas, Qt::RightButton, {100, 100}, {140, 90});
    const QPoint moved = s.at(kOrangeColor) - before;
    QVERIFY2((moved - QPoint(40, -10)).manhattanLength() <= 2,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
  }

  void aLassoSelectsWhatIsShown() {
    ShownSpace s;
    s.lasso(s.at(kOrangeColor));
    QVERIFY(s.hasSelected(kOrangeColor));
    QVERIFY(!s.hasSelected(kGreen));
    // What is inside of a surface, too, but nothing that is not shown.
    QVERIFY(s.bench.selection().size() > 20);
    const std::size_t first = s.bench.selection().size();
    QVERIFY(s.step());
    s.lasso(s.at(kGreen), 30, Qt::ControlModifier);
    QVERIFY(s.hasSelected(kOrangeColor) && s.hasSelected(kGreen));
    QVERIFY(s.bench.selection().size() > first);
    QVERIFY(s.step());
    s.lasso(s.at(kOrangeColor), 30, Qt::AltModifier);
    QVERIFY(!s.hasSelected(kOrangeColor) && s.hasSelected(kGreen));
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QVERIFY(!s.bench.hasSelection());
  }

  void aLassoPassesOverWhatIsOff() {
    ShownSpace s;
    s.toggleClass("orange");
    QVERIFY(s.step());
    s.lasso(s.at(kOrangeColor));
    QVERIFY(!s.hasSelected(kOrangeColor));
  }

  void aClickWithShiftSelectsACell() {
    ShownSpace s;
    QTest::mouseClick(s.canvas, Qt::LeftButton, Qt::ShiftModifier, s.at(kOrangeColor));
    QVERIFY(s.hasSelected(kOrangeColor));
    QCOMPARE(s.bench.selection().size(), std::size_t{1});
  }

  void escapeEndsALassoOnly() {
    ShownSpace s;
    s.lasso(s.at(kGreen));
    QTest::mousePress(s.canvas, Qt::LeftButton, Qt::ShiftModifier, {10, 10});
    moveMouse(*s.canvas, {200, 200}, Qt::LeftButton, Qt::ShiftModifier);
    QTest::keyClick(s.canvas, Qt::Key_Escape);
    QTest::mouseRelease(s.canvas, Qt::LeftButton, Qt::ShiftModifier, {200, 200});
    QVERIFY(s.hasSelected(kGreen));
  }

  void aSelectionFromElsewhereIsSeen() {
    ShownSpace s;
    const QImage before = s.picture();
    QVERIFY(s.looksLike(before.pixelColor(s.at(kGreen)), "green"));
    CellSet cells;
    cells.set(ColorTable::cellOf(kOrangeColor));
    s.bench.select(cells);
    QVERIFY(s.step());
    QVERIFY(s.orangeIsInItsPlace());
    QVERIFY(!s.looksLike(s.picture().pixelColor(s.at(kGreen)), "green"));  // dimmed
    auto* text = &child<QLabel>(s.view, "colorSpaceSelection");
    QVERIFY2(text->text().contains(QStringLiteral("1 cell, 300 pixels")), qPrintable(text->text()));
    click(s.view, "colorSpaceClear");
    QVERIFY(s.step());
    QVERIFY(!s.bench.hasSelection());
    QCOMPARE(s.picture(), before);
  }

  void selectedCellsWithoutAnythingAreSeen() {
    ShownSpace s;
    CellSet cells;
    const robotlink::YCbCr nothing{60, 200, 60};
    cells.set(ColorTable::cellOf(nothing));
    QCOMPARE(s.picture().pixelColor(s.at(nothing)).alpha(), 0);
    s.bench.select(cells);
    QVERIFY(s.step());
    QCOMPARE(s.picture().pixelColor(s.at(nothing)).alpha(), 255);
  }

  void spacesDiffer() {
    ShownSpace s;
    auto* choice = &child<QComboBox>(s.view, "colorSpaceChoice");
    std::set<std::pair<int, int>> places;
    std::vector<QImage> pictures;
    for (int i = 0; i < choice->count(); ++i) {
      choice->setCurrentIndex(i);
      QVERIFY(s.step());
      for (const QImage& other : pictures) QVERIFY(s.picture() != other);
      pictures.push_back(s.picture());
      places.insert({s.at(kOrangeColor).x(), s.at(kOrangeColor).y()});
      QVERIFY2(s.orangeIsInItsPlace(), qPrintable(choice->currentText()));
    }
    QCOMPARE(places.size(), std::size_t{4});
  }

  void whatDiffersFromAReferenceIsSeenAlone() {
    ShownSpace s;
    auto* surfaces = &child<QComboBox>(s.view, "colorSpaceSurfaces");
    QVERIFY(!surfaces->isEnabled());
    s.bench.setReference(s.bench.colors()->table, QStringLiteral("yesterday"));
    s.stroke("skyblue", 8, 22);  // was white
    s.toggle("colorSpacePixels");
    s.toggle("colorSpaceSamples");
    QVERIFY(s.step());
    QVERIFY(surfaces->isEnabled());
    QVERIFY(s.countLike("orange") > 300 && s.countLike("skyblue") > 300);
    surfaces->setFocus();
    QTest::keyClick(surfaces, Qt::Key_Down);
    QVERIFY(s.step());
    QVERIFY(s.countLike("orange") > 300);
    QCOMPARE(s.countLike("skyblue"), 0);  // not in the reference
    QTest::keyClick(surfaces, Qt::Key_Down);
    QVERIFY(s.step());
    QVERIFY(s.countLike("skyblue") > 300);
    QVERIFY(s.countLike("orange") < s.countLike("skyblue") / 5);
    moveMouse(*s.canvas, s.at(kWhite));
    const QString text = child<QLabel>(s.view, "colorSpacePointed").text();
    QVERIFY2(text.contains(QStringLiteral("skyblue   reference: background")), qPrintable(text));
  }

  void theColorThatAnImageViewPointsToIsMarked() {
    ShownSpace s;
    const QImage before = s.canvas->rendered();
    s.bench.setPointed(kGreen);
    const QImage marked = s.canvas->rendered();
    QVERIFY(marked != before);
    const QRect around(s.at(kGreen) - QPoint(12, 12), QSize(25, 25));
    QVERIFY(marked.copy(around) != before.copy(around));
    s.bench.setPointed({});
    QCOMPARE(s.canvas->rendered(), before);
  }

  void aCutTakesAPartAway() {
    ShownSpace s;
    auto* cut = &child<QComboBox>(s.view, "colorSpaceCut");
    cut->setFocus();
    QTest::keyClick(cut, Qt::Key_End);  // at Cr
    QCOMPARE(cut->currentText(), QStringLiteral("cut at Cr"));
    QVERIFY(s.step());
    QCOMPARE(s.countLike("orange"), 0);  // Cr is 200, the cut at a half
    QVERIFY(s.countLike("green") > 300);
    QTest::keyClick(&child<QWidget>(s.view, "colorSpaceCutOther"), Qt::Key_Space);
    QVERIFY(s.step());
    QVERIFY(s.countLike("orange") > 300);
    QCOMPARE(s.countLike("green"), 0);
    child<QSlider>(s.view, "colorSpaceCutAt").setValue(0);
    QVERIFY(s.step());
    QVERIFY(s.countLike("orange") > 300 && s.countLike("green") > 300);
  }

  void aCutAcrossTheViewFollowsTheCamera() {
    ShownSpace s;
    child<QComboBox>(s.view, "colorSpaceCut").setCurrentIndex(1);
    for (int i = 0; i < 8; ++i) QTest::keyClick(s.canvas, Qt::Key_Left);  // from one side
    QVERIFY(s.step());
    const bool orange = s.countLike("orange") > 0;
    for (int i = 0; i < 15; ++i) QTest::keyClick(s.canvas, Qt::Key_Left);  // from the other
    QVERIFY(s.step());
    QCOMPARE(s.countLike("orange") > 0, !orange);
  }

  void theCellUnderTheCursorIsDescribed() {
    ShownSpace s;
    QTRY_VERIFY(s.bench.colors()->margins != nullptr);
    moveMouse(*s.canvas, s.at(kOrangeColor));
    const QString text = child<QLabel>(s.view, "colorSpacePointed").text();
    for (const char* part : {"Y 140-143", "Cb 60-63", "Cr 200-203", "orange", "margin", "pixels: 300"})
      QVERIFY2(text.contains(QLatin1String(part)), qPrintable(text));
    moveMouse(*s.canvas, {2, 2});
    QVERIFY(child<QLabel>(s.view, "colorSpacePointed").text().isEmpty());
  }

  void imagesOfACameraAreFollowedNowAndThenAndNothingIsDrawnInBetween() {
    ShownSpace s;
    QSignalSpy pictures(s.canvas, &ColorSpaceCanvas::pictureShown);
    for (int i = 0; i < 30; ++i) {
      s.bench.setFrame(s.world.frame(40, 30, i % 2));
      s.view.tick();
      QCoreApplication::processEvents();
    }
    QVERIFY(s.step());
    QVERIFY2(pictures.count() >= 1 && pictures.count() <= 12, qPrintable(QString::number(pictures.count())));
    for (int i = 0; i < 20; ++i) s.view.tick();
    QVERIFY(s.step());  // smooth now
    pictures.clear();
    for (int i = 0; i < 20; ++i) s.view.tick();
    QVERIFY2(s.canvas->upToDate(), "another picture was asked for");
    QCOMPARE(pictures.count(), 0);
  }

  void theColorsOfARealRobotAreSeen() {
    ShownSpace s(false);
    if (!s.learnFromARealRobot()) QSKIP("../shared/data/colour/bhuman2009 is missing");
    QVERIFY(s.step());
    for (const char* name : {"orange", "blue", "green"}) QVERIFY2(s.countLike(name) > 300, name);
    for (int i = 0; i < 8; ++i) s.view.tick();
    QVERIFY(s.step());
    s.keep("pixels-and-surfaces");
    s.toggle("colorSpacePixels");
    child<QSlider>(s.view, "colorSpaceOpacity").setValue(200);
    s.keep("surfaces");
    child<QComboBox>(s.view, "colorSpaceCut").setCurrentIndex(2);
    child<QSlider>(s.view, "colorSpaceCutAt").setValue(100);
    s.keep("cut");
    child<QComboBox>(s.view, "colorSpaceCut").setCurrentIndex(0);
    child<QSlider>(s.view, "colorSpaceOpacity").setValue(90);
    s.toggle("colorSpacePixels");
    for (const int space : {1, 2, 3}) {
      child<QComboBox>(s.view, "colorSpaceChoice").setCurrentIndex(space);
      s.keep(qPrintable(child<QComboBox>(s.view, "colorSpaceChoice").currentText()));
    }
    child<QComboBox>(s.view, "colorSpaceChoice").setCurrentIndex(0);
    QVERIFY(s.step());
    s.lasso(s.at(kOrangeColor), 40);
    s.keep("selection");
  }

  void whatTheUserChoseSurvives() {
    ShownSpace a;
    child<QComboBox>(a.view, "colorSpaceChoice").setCurrentIndex(2);
    child<QComboBox>(a.view, "colorSpaceCut").setCurrentIndex(4);
    child<QSlider>(a.view, "colorSpaceCutAt").setValue(60);
    child<QSlider>(a.view, "colorSpaceOpacity").setValue(20);
    a.toggle("colorSpacePixels");
    a.toggleClass("green");
    QTest::keyClick(a.canvas, Qt::Key_Up);
    turnWheel(*a.canvas, {100, 100}, 2);
    const QJsonObject state = a.view.saveState();
    ShownSpace b;
    b.view.restoreState(state);
    QCOMPARE(b.view.saveState(), state);
    QVERIFY(a.step() && b.step());
    QCOMPARE(b.picture(), a.picture());
    b.view.restoreState({});  // harmless
    QCOMPARE(b.canvas->camera(), ColorSpaceCamera());
  }
};

const GuiTest<ColorSpaceViewTest> kColorSpaceViewTest;

}  // namespace widgets::test

#include "ColorSpaceViewTest.moc"
