// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageStreamView.h"

namespace widgets::test {
namespace {

using robotlink::ImageDrawing;
using robotlink::Rgb;
using robotlink::toRgb;
using robotlink::YCbCr;
namespace colors = robotlink::colors;

constexpr YCbCr kGrass{100, 100, 90};
constexpr YCbCr kOrange{150, 60, 200};
const QSize kImage(176, 144);

QColor qColor(YCbCr color) {
  const Rgb rgb = toRgb(color);
  return {rgb.r, rgb.g, rgb.b};
}

/// An image view of the size of 2:1 pixels plus its tool and status rows.
struct ShownImage {
  FieldBench world;
  ImageStreamView view{world.context};
  ImageCanvas* canvas = &child<ImageCanvas>(view, "imageCanvas");

  ShownImage() {
    view.resize(700, 600);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
  }
  void step() {
    world.advance();
    view.tick();
  }
  QPoint at(double x, double y) const {
    return imageToWidget(canvas->viewport(), canvas->picture().pixels.size(), canvas->size())
        .map(QPointF(x, y))
        .toPoint();
  }
  QPointF pixelAt(const QPoint& widget) const {
    return imageToWidget(canvas->viewport(), canvas->picture().pixels.size(), canvas->size())
        .inverted()
        .map(QPointF(widget));
  }
  QColor colorAt(double x, double y) const { return canvas->grab().toImage().pixelColor(at(x, y)); }
  void wheel(const QPoint& position, int notches) { turnWheel(*canvas, position, notches); }
  void click(const char* button) { test::click(view, button); }
  QString text(const char* label) const { return child<QLabel>(view, label).text(); }
  /// Clicks the check box of a row of the list of drawings.
  void clickDrawing(int row) {
    auto* list = &child<QListView>(view, "drawingsList");
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(row, 0)).topLeft() + QPoint(10, 8));
  }
};

FieldBench::FramePart square(const char* key, robotlink::Color color) {
  return imageDrawing(key, [color](ImageDrawing& d) {
    const std::vector<robotlink::Vector2> corners{{20, 20}, {60, 20}, {60, 60}, {20, 60}};
    d.polygon(corners, color, 1, color);
  });
}

}  // namespace

class ImageStreamViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void saysThatThereIsNoImageYet() {
    ShownImage s;
    QCOMPARE(s.text("imageTime"), QStringLiteral("no image yet"));
    QVERIFY(s.canvas->picture().pixels.isNull());
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.step();
    QCOMPARE(s.text("imageTime"), QStringLiteral("1.000 s"));
  }

  void saysWhyThereIsNoImage() {
    ShownImage s;
    foxglove::Log text;
    text.set_name("platform");
    text.set_level(foxglove::Log::WARNING);
    text.set_message("/dev/video0: no such device");
    s.world.push("red1/log", text, 1);
    text.set_name("cognition");
    text.set_message("nothing is seen");
    s.world.push("red1/log", text, 1);
    s.step();
    QCOMPARE(s.canvas->hint(),
             QStringLiteral("No image yet from red1/camera/image.\n/dev/video0: no such device"));
    text.set_name("platform");
    text.set_level(foxglove::Log::INFO);
    text.set_message("the camera takes images");
    s.world.push("red1/log", text, 1.01);
    s.step();
    QCOMPARE(s.canvas->hint(), QStringLiteral("No image yet from red1/camera/image"));
  }

  void showsTheImageInItsColors() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass, {100, 50}, kOrange);
    s.step();
    QVERIFY(isNear(s.colorAt(10.5, 10.5), qColor(kGrass), 2));
    QVERIFY(isNear(s.colorAt(100.5, 50.5), qColor(kOrange), 2));
  }

  void thePixelsAreCopiedAsNumbers() {
    ShownImage s;
    QVERIFY(!s.view.numbers());
    s.world.pushImage("red1/camera/image", kImage, kGrass, {1, 2}, kOrange);
    s.step();
    const QStringList rows = s.view.numbers()->split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(rows.size(), kImage.height());
    const QStringList cells = rows[2].split(QLatin1Char('\t'));
    QCOMPARE(cells.size(), 3 * kImage.width());
    const Rgb orange = toRgb(kOrange);
    QCOMPARE(cells[3].toInt(), int(orange.r));
    QCOMPARE(cells[5].toInt(), int(orange.b));
  }

  void tellsThePixelUnderTheCursor() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass, {100, 50}, kOrange);
    s.step();
    moveMouse(*s.canvas, s.at(100.5, 50.5));
    const Rgb rgb = toRgb(kOrange);
    const QString expected = QStringLiteral("x 100  y  50   Y 150  Cb  60  Cr 200   R %1  G %2  B %3")
                                 .arg(rgb.r, 3)
                                 .arg(rgb.g, 3)
                                 .arg(rgb.b, 3);
    QCOMPARE(s.text("imagePixel"), expected);
    moveMouse(*s.canvas, {1, 1});
    QCOMPARE(s.text("imagePixel"), QString());
  }

  void aDrawingOfAnEarlierImageIsFaded() {
    ShownImage s;
    auto table = std::make_shared<robotcontrol::KeyTable>();
    auto& entry = *table->add_keys();
    entry.set_name("ball-percept/square");
    entry.mutable_mode()->set_kind(robotcontrol::KeyMode::EVERY_N);
    entry.mutable_mode()->set_n(10);
    s.world.push("red1/tables/keys", table);
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("ball-percept/square", colors::kRed)});
    s.step();
    QVERIFY(isNear(s.colorAt(40.5, 40.5), QColor(220, 40, 40), 30));
    QVERIFY(!s.text("imageState").contains(QStringLiteral("faded")));
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({});
    s.step();
    QVERIFY2(!isNear(s.colorAt(40.5, 40.5), QColor(220, 40, 40), 60),
             "it would look like what is seen in this image");
    QVERIFY2(!isNear(s.colorAt(40.5, 40.5), qColor(kGrass), 10), "it is still there");
    QVERIFY(s.text("imageState").contains(QStringLiteral("faded")));
  }

  void tellsTheColorClassOfASegmentedPixel() {
    ShownImage s;
    robotlink::Image segmented(4, 4, robotlink::PixelFormat::kRgb8);
    const Rgb orange = *s.world.context.field->color("orange");
    for (std::size_t i = 0; i < segmented.data.size(); i += 3) {
      segmented.data[i] = orange.r;
      segmented.data[i + 1] = orange.g;
      segmented.data[i + 2] = orange.b;
    }
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, segmented.view(), s.world.now(), "camera");
    s.world.push("red1/camera/image", message);
    s.step();
    moveMouse(*s.canvas, s.at(1.5, 1.5));
    QVERIFY2(s.text("imagePixel").endsWith(QStringLiteral("orange")), qPrintable(s.text("imagePixel")));
  }

  void showsTrueClassesInTheirColorsByName() {
    ShownImage s;
    robotlink::Image classes(4, 1, robotlink::PixelFormat::kMono8);
    classes.data = {0, 1, 9, 255};
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, classes.view(), s.world.now(), "red1/camera");
    s.world.push("red1/oracle/classes", message);
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.step();
    auto* streams = &child<QComboBox>(s.view, "imageStream");
    const int row = streams->findData(QStringLiteral("red1/oracle/classes"));
    QVERIFY(row >= 0);
    streams->setFocus();
    while (streams->currentIndex() < row) QTest::keyClick(streams, Qt::Key_Down);
    const Rgb orange = *s.world.context.field->color("orange");
    const std::pair<const char*, QColor> expected[] = {{"none", Qt::black},
                                                       {"orange", QColor(orange.r, orange.g, orange.b)},
                                                       {"black", QColor(45, 45, 50)},
                                                       {"unknown", QColor(128, 128, 128)}};
    for (int x = 0; x < 4; ++x) {
      moveMouse(*s.canvas, s.at(x + 0.5, 0.5));
      QVERIFY2(s.text("imagePixel").endsWith(QLatin1String(expected[x].first)),
               qPrintable(s.text("imagePixel")));
      QVERIFY(isNear(s.colorAt(x + 0.5, 0.5), expected[x].second, 2));
    }
  }

  void aDrawingIsToggledByAClickInTheList() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("ball-percept/area", colors::kPink)});
    s.step();
    s.click("imageDrawings");
    QVERIFY(isNear(s.colorAt(40, 40), QColor(250, 90, 170)));
    s.clickDrawing(0);
    QVERIFY(isNear(s.colorAt(40, 40), qColor(kGrass)));
    s.clickDrawing(0);
    QVERIFY(isNear(s.colorAt(40, 40), QColor(250, 90, 170)));
  }

  void whatIsNoLongerDrawnDisappears() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("a", colors::kPink)});
    s.step();
    QVERIFY(isNear(s.colorAt(40, 40), QColor(250, 90, 170)));
    s.world.pushFrame({});
    s.step();
    QVERIFY(isNear(s.colorAt(40, 40), qColor(kGrass)));
  }

  void theOrderOfDrawingsIsChanged() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("a", colors::kPink), square("b", colors::kBlue)});
    s.step();
    s.click("imageDrawings");
    QVERIFY(isNear(s.colorAt(40, 40), QColor(40, 90, 230)));
    auto* list = &child<QListView>(s.view, "drawingsList");
    list->setCurrentIndex(list->model()->index(0, 0));
    s.click("drawingsDown");
    QVERIFY(isNear(s.colorAt(40, 40), QColor(250, 90, 170)));
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
    QVERIFY(isNear(s.colorAt(40, 40), QColor(40, 90, 230)));
  }

  void drawingsAreSearchedAndHiddenTogether() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("ball", colors::kPink), square("lines", colors::kBlue)});
    s.step();
    s.click("imageDrawings");
    auto* list = &child<QListView>(s.view, "drawingsList");
    QTest::keyClicks(&child<QLineEdit>(s.view, "drawingsSearch"), QStringLiteral("BAL"));
    QCOMPARE(list->model()->rowCount(), 1);
    s.click("drawingsNone");
    QVERIFY(isNear(s.colorAt(40, 40), qColor(kGrass)));
    s.click("drawingsAll");
    QVERIFY(isNear(s.colorAt(40, 40), QColor(40, 90, 230)));
  }

  void drawingsAreShownAndHiddenByTheirNames() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("ball", colors::kPink), square("lines", colors::kBlue)});
    s.step();
    QVERIFY(s.view.showDrawing("lines", false));
    QVERIFY(isNear(s.colorAt(40, 40), QColor(250, 90, 170)));
    QVERIFY(s.view.showDrawing("image/lines", true));
    QVERIFY(isNear(s.colorAt(40, 40), QColor(40, 90, 230)));
    const auto wrong = s.view.showDrawing("line", true);
    QVERIFY(!wrong);
    QVERIFY(wrong.error().text.find("'lines'") != std::string::npos);
  }

  void aDrawingIsSwitchedOnWhereItIsMissed() {
    ShownImage s;
    const auto publish = [&s](robotcontrol::KeyMode::Kind kind) {
      auto table = std::make_shared<robotcontrol::KeyTable>();
      for (const auto& [streams, name] : {std::pair{"drawings/image/", "ball-percept/disc"},
                                          {"drawings/field/", "ball-model/ball"},
                                          {"plots/", "ball-percept/distance"}}) {
        auto& key = *table->add_keys();
        key.set_name(name);
        key.set_stream(std::string(streams) + name);
        key.mutable_mode()->set_kind(kind);
      }
      s.world.push("red1/tables/keys", table);
      s.step();
    };
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    publish(robotcontrol::KeyMode::OFF);
    s.click("imageDrawings");
    auto* list = &child<QListView>(s.view, "drawingsList");
    QCOMPARE(list->model()->rowCount(), 1);
    const auto state = [list] { return list->model()->index(0, 0).data(Qt::CheckStateRole).toInt(); };
    QCOMPARE(state(), static_cast<int>(Qt::Unchecked));
    s.world.refusal = "it sleeps";
    s.clickDrawing(0);
    s.step();
    QCOMPARE(state(), static_cast<int>(Qt::Unchecked));
    QVERIFY(
        list->model()->index(0, 0).data(Qt::ToolTipRole).toString().contains(QStringLiteral("it sleeps")));
    s.world.refusal.clear();
    s.clickDrawing(0);
    QCOMPARE(s.world.requests.back().set_key().name(), std::string("ball-percept/disc"));
    QCOMPARE(s.world.requests.back().set_key().mode().kind(), robotcontrol::KeyMode::ALWAYS);
    publish(robotcontrol::KeyMode::ALWAYS);
    QCOMPARE(state(), static_cast<int>(Qt::Checked));
    list->setCurrentIndex(list->model()->index(0, 0));
    s.click("drawingsOff");
    QCOMPARE(s.world.requests.back().set_key().mode().kind(), robotcontrol::KeyMode::OFF);
    publish(robotcontrol::KeyMode::OFF);
    QCOMPARE(state(), static_cast<int>(Qt::Unchecked));
  }

  void theListOfDrawingsSaysWhyItIsEmpty() {
    ShownImage s;
    s.click("imageDrawings");
    auto* hint = &child<QLabel>(child<QListView>(s.view, "drawingsList"), "emptyHint");
    QVERIFY(hint->isVisible() && hint->text().contains(QStringLiteral("no robot")));
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("ball", colors::kPink)});
    s.step();
    QVERIFY(!hint->isVisible());
    auto* search = &child<QLineEdit>(s.view, "drawingsSearch");
    search->setFocus();
    QTest::keyClicks(search, QStringLiteral("x"));
    QVERIFY(hint->isVisible() && hint->text().contains(QStringLiteral("No drawing")));
    QTest::keyClick(search, Qt::Key_Escape);
    QVERIFY(!hint->isVisible());
  }

  void theWheelZoomsToTheCursor() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass, {100, 50}, kOrange);
    s.step();
    const QPoint cursor = s.at(100.5, 50.5);
    const QPointF before = s.pixelAt(cursor);
    s.wheel(cursor, 6);
    QVERIFY((s.pixelAt(cursor) - before).manhattanLength() < 0.1);
    QVERIFY(isNear(s.colorAt(100.3, 50.3), qColor(kOrange), 2));
    QVERIFY2(s.text("imageZoom") != QStringLiteral("100 %"), qPrintable(s.text("imageZoom")));
    s.click("imageFit");
    QVERIFY(s.canvas->viewport().fit);
  }

  void oneToOneShowsPixelByPixelAndDraggingMovesIt() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass, {100, 50}, kOrange);
    s.step();
    QTest::keyClick(s.canvas, Qt::Key_A);
    QCOMPARE(s.canvas->zoom(), 1.0);
    QCOMPARE(s.text("imageZoom"), QStringLiteral("100 %"));
    const QPoint before = s.at(100, 50);
    drag(*s.canvas, Qt::LeftButton, {100, 100}, {130, 90});
    QCOMPARE(s.at(100, 50) - before, QPoint(30, -10));
    for (const int key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Up}) QTest::keyClick(s.canvas, Qt::Key(key));
    QCOMPARE(s.at(100, 50) - before, QPoint(30 + 24, -10 + 48));
    for (const int key : {Qt::Key_Right, Qt::Key_Down, Qt::Key_Down}) QTest::keyClick(s.canvas, Qt::Key(key));
    QCOMPARE(s.at(100, 50) - before, QPoint(30, -10));
  }

  void aGridSeparatesThePixelsAtHighZoom() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.step();
    const auto differentColors = [&] {
      const QImage image = s.canvas->grab().toImage();
      return image.width() * image.height() - countNear(image, qColor(kGrass), 3);
    };
    QTest::keyClick(s.canvas, Qt::Key_A);
    for (int i = 0; i < 8; ++i) s.click("imageZoomIn");
    QCOMPARE(s.canvas->zoom(), 16.0);
    QVERIFY(differentColors() > 1000);
    for (int i = 0; i < 8; ++i) s.click("imageZoomOut");
    QCOMPARE(s.canvas->zoom(), 1.0);
  }

  void aFrozenPictureStaysWhileTheRobotGoesOn() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.step();
    QTest::keyClick(s.canvas, Qt::Key_H);
    s.world.pushImage("red1/camera/image", kImage, kOrange);
    s.step();
    QVERIFY(isNear(s.colorAt(10, 10), qColor(kGrass), 2));
    QCOMPARE(s.text("imageState"), QStringLiteral("frozen"));
    s.click("imageFreeze");
    QVERIFY(isNear(s.colorAt(10, 10), qColor(kOrange), 2));
    QCOMPARE(s.text("imageState"), QString());
  }

  void followsTheTimeLineIntoTheHistory() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.step();
    const auto early = s.world.now() - std::chrono::milliseconds(1);
    s.world.pushImage("red1/camera/image", kImage, kOrange);
    s.step();
    s.world.session.timeline().show(early);
    s.view.tick();
    QVERIFY(isNear(s.colorAt(10, 10), qColor(kGrass), 2));
    QCOMPARE(s.text("imageState"), QStringLiteral("history"));
  }

  void anyStreamOfImagesCanBeChosen() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushImage("red1/images/segmented", kImage, kOrange);
    s.step();
    QSignalSpy titles(&s.view, &View::titleChanged);
    auto* streams = &child<QComboBox>(s.view, "imageStream");
    const int row = streams->findData(QStringLiteral("red1/images/segmented"));
    QVERIFY(row >= 0);
    streams->setFocus();
    while (streams->currentIndex() < row) QTest::keyClick(streams, Qt::Key_Down);
    QVERIFY(isNear(s.colorAt(10, 10), qColor(kOrange), 2));
    QCOMPARE(titles.last().front().toString(), QStringLiteral("Image: red1/images/segmented"));
  }

  void thePictureIsCopiedAndSaved() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass);
    s.world.pushFrame({square("a", colors::kPink)});
    s.step();
    s.view.findChild<QAction*>(QStringLiteral("imageCopyImageAction"))->trigger();
    const QImage copied = QApplication::clipboard()->image();
    QCOMPARE(copied.size(), kImage);
    QVERIFY(isNear(copied.pixelColor(40, 40), qColor(kGrass), 2));
    s.view.findChild<QAction*>(QStringLiteral("imageCopyAction"))->trigger();
    QVERIFY(isNear(QApplication::clipboard()->image().pixelColor(s.at(40, 40)), QColor(250, 90, 170)));
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("a.png"));
    DialogAnswer withDrawings = DialogAnswer::file(file);
    QTest::keyClick(s.canvas, Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(withDrawings.asked());
    QVERIFY(isNear(QImage(file).pixelColor(s.at(40, 40)), QColor(250, 90, 170)));
    QVERIFY(QFile::remove(file));
    DialogAnswer imageOnly = DialogAnswer::file(file);
    s.view.findChild<QAction*>(QStringLiteral("imageSaveImageAction"))->trigger();
    QVERIFY(imageOnly.asked());
    QCOMPARE(QImage(file).size(), kImage);
  }

  void whatTheUserChoseSurvives() {
    ShownImage a;
    a.world.pushImage("red1/images/other", kImage, kOrange);
    a.world.pushImage("red1/camera/image", kImage, kGrass);
    a.world.pushFrame({square("a", colors::kPink), square("b", colors::kBlue)});
    a.step();
    a.click("imageDrawings");
    a.clickDrawing(1);
    a.wheel(a.at(20, 20), 4);
    const QJsonObject state = a.view.saveState();
    ShownImage b;
    b.view.restoreState(state);
    QCOMPARE(b.view.saveState(), state);
    b.view.restoreState({});  // harmless
  }

  void showsAWholePicture() {
    ShownImage s;
    s.world.pushImage("red1/camera/image", kImage, kGrass, {100, 50}, kOrange);
    s.world.pushFrame(
        {square("area", {{250, 90, 170}, 0.4}), imageDrawing("ball-percept/circle", [](ImageDrawing& d) {
           d.circle({110, 80}, 25, colors::kOrange, 2);
           d.arrow({110, 80}, {150, 60}, colors::kYellow, 2);
           d.text({90, 50}, "ball 0.42 m", colors::kWhite, 12);
           for (int i = 0; i < 12; ++i) d.dot({10.0 + 10 * i, 120}, colors::kSkyBlue, 4);
         })});
    s.step();
    s.click("imageDrawings");
    moveMouse(*s.canvas, s.at(100.5, 50.5));
    keepPicture(s.view, "image-view");
    QVERIFY(countNear(s.canvas->grab().toImage(), QColor(90, 200, 240), 20) > 50);
  }
};

const GuiTest<ImageStreamViewTest> kImageStreamViewTest;

}  // namespace widgets::test

#include "ImageStreamViewTest.moc"
