// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorImageView.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <fstream>

#include "colortool/table/ColorTable.h"
#include "tests/widgets/DialogAnswer.h"
#include "tests/widgets/LogBench.h"
#include "tests/widgets/ShownColorImage.h"
#include "widgets/color/ColorFiles.h"

namespace widgets::test {
class ColorImageViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aStrokeShowsInTheSegmentedImageAndCanBeUndone() {
    ShownColorImage s;
    s.choose("orange");
    s.drag({{5, 5}, {9, 8}, {12, 6}});
    QCOMPARE(s.bench.samples().strokes.size(), std::size_t{1});
    QCOMPARE(s.pixel(*s.right, 16, 12), s.shownColor("orange"));
    QCOMPARE(s.pixel(*s.right, 30, 12), QColor(Qt::black));
    s.left->setFocus();
    QTest::keyClick(s.left, Qt::Key_Z, Qt::ControlModifier);
    s.settle();
    QCOMPARE(s.pixel(*s.right, 16, 12), QColor(Qt::black));
    click(child<QToolButton>(s.view, "colorRedo"));
    s.settle();
    QCOMPARE(s.pixel(*s.right, 16, 12), s.shownColor("orange"));
  }

  void thePictureStaysWhereItIsWhileAStrokesEffectIsSaid() {
    ShownColorImage s;
    s.choose("orange");
    s.click(8, 7);
    const QRect before(s.left->mapTo(&s.view, QPoint()), s.left->size());
    s.choose("yellow");
    s.bench.setWeight(10);
    s.tool("colorToolRectangle");
    s.drag({{4, 4}, {16, 12}});
    QVERIFY(child<QLabel>(s.view, "colorEffect").isVisible());
    QCoreApplication::processEvents();
    QCOMPARE(QRect(s.left->mapTo(&s.view, QPoint()), s.left->size()), before);
  }

  void theTableFollowsWhileTheMouseMoves() {
    ShownColorImage s;
    s.choose("green");
    QTest::mousePress(s.left, Qt::LeftButton, {}, s.at(30, 5));
    moveMouse(*s.left, s.at(33, 8), Qt::LeftButton);
    s.settle();
    QCOMPARE(s.pixel(*s.right, 25, 12), s.shownColor("green"));
    QTest::keyClick(s.left, Qt::Key_Escape);
    s.settle();
    QVERIFY(s.bench.samples().strokes.empty());
    QCOMPARE(s.pixel(*s.right, 25, 12), QColor(Qt::black));
    QTest::mouseRelease(s.left, Qt::LeftButton, {}, s.at(33, 8));
    QVERIFY(s.bench.samples().strokes.empty());
  }

  void eachToolTouchesItsArea() {
    ShownColorImage s;
    s.choose("orange");
    s.tool("colorToolPoint");
    s.click(4, 4);
    QCOMPARE(colortool::pixelCount(s.lastStroke().area), std::size_t{1});
    s.tool("colorToolRectangle");
    s.drag({{2, 2}, {7, 6}});
    QCOMPARE(colortool::pixelCount(s.lastStroke().area), std::size_t{30});
    s.tool("colorToolLasso");
    s.drag({{2, 2}, {12, 2}, {12, 10}, {2, 10}});
    QVERIFY(colortool::contains(s.lastStroke().area, 7, 6));
    QVERIFY(!colortool::contains(s.lastStroke().area, 14, 6));
    s.tool("colorToolWand");
    s.click(5, 5);
    QCOMPARE(colortool::pixelCount(s.lastStroke().area), std::size_t{20 * 15});
    QCOMPARE(s.lastStroke().tool, std::string("wand"));
    const std::size_t before = s.bench.samples().strokes.size();
    s.tool("colorToolEraser");
    s.drag({{2, 2}, {3, 3}});
    QVERIFY(s.bench.samples().strokes.size() <= before);
    QVERIFY(!colortool::contains(s.lastStroke().area, 2, 2));
    QCOMPARE(s.bench.undoStack().count(), 5);
  }

  void strokesAreDrawnInTheSegmentedImageToo() {
    ShownColorImage s;
    s.choose("white");
    s.click(8, 22, s.right);
    const std::size_t pixels = colortool::pixelCount(s.lastStroke().area);
    QVERIFY2(pixels >= 24 && pixels <= 32, "a disc of radius 3");
    QVERIFY(colortool::contains(s.lastStroke().area, 8, 22));
    QCOMPARE(s.pixel(*s.right, 3, 27), s.shownColor("white"));
  }

  void theMenuSaysWhatASpotShouldBe() {
    ShownColorImage s;
    s.choose("orange");
    s.click(8, 7);
    QTest::mouseClick(s.right, Qt::RightButton, {}, s.at(8, 10, s.right));
    auto* menu = s.view.findChild<QMenu*>(QStringLiteral("colorPixelMenu"));
    QVERIFY(menu != nullptr);
    QCOMPARE(menu->actions().size(), 7);
    QMenu* spot = menu->actions().at(2)->menu();
    for (QAction* action : spot->actions()) {
      if (action->text() == QStringLiteral("yellow")) action->trigger();
    }
    menu->close();
    s.settle();
    QCOMPARE(s.lastStroke().tool, std::string("spot"));
    QCOMPARE(s.lastStroke().colorClass, s.bench.samples().classes.index("yellow"));
    QCOMPARE(s.pixel(*s.right, 16, 12), s.shownColor("yellow"));
    QCOMPARE(s.bench.currentClass(), int{s.bench.samples().classes.index("orange")});
  }

  void bothPicturesShowTheSamePart() {
    ShownColorImage s;
    click(child<QToolButton>(s.view, "colorZoomIn"));
    QCOMPARE(s.right->viewport(), s.left->viewport());
    QVERIFY(!s.left->viewport().fit);
    s.tool("colorToolMove");
    QTest::mousePress(s.right, Qt::LeftButton, {}, {50, 50});
    moveMouse(*s.right, {80, 70}, Qt::LeftButton);
    QTest::mouseRelease(s.right, Qt::LeftButton, {}, {80, 70});
    QCOMPARE(s.right->viewport(), s.left->viewport());
    QVERIFY(s.bench.samples().strokes.empty());
    s.left->setFocus();
    QTest::keyClick(s.left, Qt::Key_F);
    QVERIFY(s.left->viewport().fit && s.right->viewport().fit);
  }

  void digitsChooseTheClassAndLettersTheTool() {
    ShownColorImage s;
    s.left->setFocus();
    QTest::keyClick(s.left, Qt::Key_2);
    QCOMPARE(s.bench.currentClass(), 2);
    QTest::keyClick(s.left, Qt::Key_0);
    QCOMPARE(child<QToolButton>(s.view, "colorClass").text(), QStringLiteral("background"));
    QTest::keyClick(s.left, Qt::Key_3);
    QTest::keyClick(s.left, Qt::Key_N);
    QVERIFY(child<QToolButton>(s.view, "colorClass").text().startsWith(QStringLiteral("not ")));
    QTest::keyClick(s.left, Qt::Key_L);
    QVERIFY(child<QToolButton>(s.view, "colorToolLasso").isChecked());
    s.drag({{2, 2}, {12, 2}, {12, 10}, {2, 10}});
    QVERIFY(s.lastStroke().mustNotBe);
  }

  void thePixelUnderTheCursorIsSaid() {
    ShownColorImage s;
    s.choose("orange");
    s.click(8, 7);
    moveMouse(*s.left, s.at(9, 7));
    QTRY_VERIFY(child<QLabel>(s.view, "colorPixel").text().contains(QStringLiteral("% sure")));
    const QString text = child<QLabel>(s.view, "colorPixel").text();
    QVERIFY2(text.contains(QStringLiteral("Y 140  Cb  60  Cr 200")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("orange")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("cell 35 15 50")), qPrintable(text));
  }

  void aCollectedImageStaysWhileTheRobotGoesOn() {
    ShownColorImage s;
    s.left->setFocus();
    QTest::keyClick(s.left, Qt::Key_C);
    auto* strip = &child<QListWidget>(s.view, "colorStrip");
    QCOMPARE(strip->count(), 1);
    QVERIFY(strip->isVisible());
    const ColorFramePtr first = s.bench.frame();
    s.world.show(40, 30, 30);
    s.view.tick();
    QVERIFY(s.bench.frame() != first);
    QTest::mouseClick(strip->viewport(), Qt::LeftButton, {}, strip->visualItemRect(strip->item(0)).center());
    QCOMPARE(s.bench.frame(), first);
    s.world.show();
    s.view.tick();
    QCOMPARE(s.bench.frame(), first);
    click(child<QToolButton>(s.view, "colorFreeze"));
    s.view.tick();
    QVERIFY(s.bench.frame() != first);
    strip->setCurrentRow(0);
    QTest::keyClick(strip, Qt::Key_Delete);
    QVERIFY(!strip->isVisible());
  }

  void aSelectionIsOfTheCorrectedColors() {
    ShownColorImage s;
    colortool::Samples samples = s.bench.samples();
    colortool::ColorCorrection darker;
    darker.channels[0] = {1, -60};
    samples.corrections = {{"red1", darker}};
    samples.settings.correctCameras = true;
    s.bench.change(QStringLiteral("correct"), std::move(samples));
    s.settle();
    const QColor orange = s.pixel(*s.left, 8, 7), green = s.pixel(*s.left, 30, 7);
    s.tool("colorToolSelect");
    s.drag({{2, 2}, {12, 2}, {12, 10}, {2, 10}});
    QVERIFY(s.bench.hasSelection());
    QCOMPARE(s.pixel(*s.left, 16, 12), orange);
    QVERIFY2(s.pixel(*s.left, 30, 7).lightness() < green.lightness() / 2, "what is not selected is dark");
  }

  void aSelectionDarkensTheRest() {
    ShownColorImage s;
    s.tool("colorToolSelect");
    s.drag({{2, 2}, {12, 2}, {12, 10}, {2, 10}});
    QVERIFY(s.bench.hasSelection());
    QVERIFY(s.bench.selection().contains(colortool::ColorTable::cellOf({140, 60, 200})));
    const QColor orange = s.pixel(*s.left, 16, 12), white = s.pixel(*s.left, 5, 22);
    QVERIFY(white.lightness() < orange.lightness());
    s.left->setFocus();
    QTest::keyClick(s.left, Qt::Key_Escape);
    QVERIFY(!s.bench.hasSelection());
    QVERIFY(s.pixel(*s.left, 5, 22).lightness() > orange.lightness());
  }

  void theRightPictureShowsDifferencesAndAmbiguity() {
    ShownColorImage s;
    auto* layer = &child<QComboBox>(s.view, "colorRightLayer");
    s.choose("orange");
    s.click(8, 7);
    s.bench.setReference(std::make_shared<colortool::ColorTable>(), QStringLiteral("empty.c64"));
    layer->setCurrentIndex(1);
    QCOMPARE(s.pixel(*s.right, 16, 12), QColor(Qt::black));
    layer->setCurrentIndex(2);
    QCOMPARE(s.pixel(*s.right, 16, 12), s.shownColor("orange"));
    QCOMPARE(s.pixel(*s.right, 30, 12).saturation(), 0);
    layer->setCurrentIndex(3);
    QTRY_VERIFY(s.bench.colors()->margins != nullptr);
    QTRY_VERIFY(s.pixel(*s.right, 16, 12).lightness() < 60);
  }

  void theTableIsSentAndConfirmed() {
    ShownColorImage s;
    s.choose("orange");
    s.click(8, 7);
    auto* sent = &child<QLabel>(s.view, "colorSent");
    click(child<QToolButton>(s.view, "colorSend"));
    QCOMPARE(s.world.requests.size(), std::size_t{1});
    QCOMPARE(s.world.requests[0].robot(), std::string("red1"));
    const auto& table = s.world.requests[0].set_color_table().table();
    QCOMPARE(table.class_names(0), std::string("orange"));
    QCOMPARE(table.source(), std::string("painted, not saved"));
    QVERIFY(table.has_loaded());
    QCOMPARE(static_cast<int>(table.cells()[colortool::ColorTable::cellOf({140, 60, 200})]), 1);
    QVERIFY(sent->text().contains(QStringLiteral("Sending")));
    s.world.advance();
    QVERIFY2(sent->text().startsWith(QStringLiteral("✓ red1 uses it")), qPrintable(sent->text()));
    s.world.refusal = "no task uses a color table";
    QTest::keyClick(s.left, Qt::Key_Return, Qt::ControlModifier);
    s.world.advance();
    QVERIFY2(sent->text().contains(QStringLiteral("refuses it: no task")), qPrintable(sent->text()));
    s.world.refusal.clear();
    s.world.wrongChecksum = true;
    click(child<QToolButton>(s.view, "colorSend"));
    s.world.advance();
    QVERIFY2(sent->text().contains(QStringLiteral("send it again")), qPrintable(sent->text()));
  }

  void anOldRefusalGoesWhenTheTableIsAnother() {
    ShownColorImage s;
    s.choose("orange");
    s.click(8, 7);
    auto* sent = &child<QLabel>(s.view, "colorSent");
    s.world.refusal = "no task uses a color table";
    click(child<QToolButton>(s.view, "colorSend"));
    s.world.advance();
    s.view.tick();
    QVERIFY(sent->text().contains(QStringLiteral("refuses it")));
    s.click(12, 9);
    s.view.tick();
    QVERIFY2(sent->text().isEmpty(), qPrintable(sent->text()));
  }

  void theCarefulBrushLeavesOutWhatIsBeyondAnEdge() {
    ShownColorImage s;
    s.choose("orange");
    child<QDoubleSpinBox>(s.view, "colorRadius").setValue(5);
    s.drag({{17, 5}, {17, 10}});
    QVERIFY(colortool::contains(s.lastStroke().area, 19, 7));
    QVERIFY(!colortool::contains(s.lastStroke().area, 21, 7));
    s.tool("colorCareful");
    s.drag({{17, 5}, {17, 10}});
    QVERIFY(colortool::contains(s.lastStroke().area, 21, 7));
  }

  void whatAStrokeTakesFromAnotherClassIsSaidAndItsOutliersCanBeDropped() {
    ShownColorImage s;
    auto* effect = &child<QLabel>(s.view, "colorEffect");
    s.choose("green");
    s.drag({{25, 4}, {35, 10}});
    QVERIFY(!effect->isVisible() || !effect->text().contains(QStringLiteral("⚠")));
    s.tool("colorCareful");  // off
    s.choose("orange");
    s.bench.setWeight(10);
    s.tool("colorToolRectangle");
    s.drag({{12, 2}, {37, 12}});  // over the edge
    QVERIFY(effect->isVisible());
    QVERIFY2(effect->text().contains(QStringLiteral("⚠")) &&
                 effect->text().contains(QStringLiteral("green (now orange)")),
             qPrintable(effect->text()));
    const std::size_t before = colortool::pixelCount(s.lastStroke().area);
    keepPicture(s.view, "color-effect");
    click(child<QToolButton>(s.view, "colorDropOutliers"));
    s.settle();
    QVERIFY(colortool::pixelCount(s.lastStroke().area) < before);
    QVERIFY(!colortool::contains(s.lastStroke().area, 30, 7));
    QVERIFY(colortool::contains(s.lastStroke().area, 15, 7));
    QVERIFY2(!effect->text().contains(QStringLiteral("⚠")) || !effect->isVisible(),
             qPrintable(effect->text()));
    s.bench.undoStack().undo();
    s.bench.undoStack().undo();
    QVERIFY(!effect->isVisible());
  }

  void theImageIsThereInAViewThatIsMadeAnewWhileNothingComes() {
    ShownColorImage s;
    s.choose("orange");
    s.drag({{5, 5}, {9, 8}});
    ColorImageView again(s.world.context);
    again.resize(900, 560);
    again.show();
    QVERIFY(QTest::qWaitForWindowExposed(&again));
    again.tick();
    auto* left = &child<ColorCanvas>(again, "colorLeft");
    auto* right = &child<ColorCanvas>(again, "colorRight");
    QCOMPARE(s.pixel(*left, 30, 7), s.pixel(*s.left, 30, 7));
    QCOMPARE(s.pixel(*right, 16, 12), s.shownColor("orange"));
  }

  void anImageOfALogIsNotCalledLive() {
    LogBench bench;
    bench.openLog(kFile);
    bench.push(bench.session.selectedRobot() + "/camera/image", *CameraBench::image(), 2);
    auto view = bench.openView<ColorImageView>();
    QVERIFY(child<QLabel>(*view, "colorTime").text().endsWith(QStringLiteral(" s")));
    QCOMPARE(child<QLabel>(*view, "colorState").text(), QString());
  }

  void picturesAreOpenedAndPaintedIn() {
    ShownColorImage s;
    QTemporaryDir folder;
    QImage picture(60, 40, QImage::Format_RGB888);
    picture.fill(QColor(255, 120, 0));
    QVERIFY(picture.save(folder.filePath(QStringLiteral("a.png"))));
    QVERIFY(picture.save(folder.filePath(QStringLiteral("b.JPG")), "JPEG"));
    std::ofstream(folder.filePath(QStringLiteral("c.yuyv")).toStdString(), std::ios::binary)
        << std::string(320 * 240 * 4, '\x60');
    std::ofstream(folder.filePath(QStringLiteral("notes.txt")).toStdString()) << "no picture";
    ColorFiles& files = colorFiles(s.world.context);
    const auto answer = DialogAnswer::file(folder.path());
    click(child<QToolButton>(s.view, "colorOpenFolder"));
    QTRY_COMPARE((files.tick(), s.bench.collected().size()), std::size_t{3});
    QVERIFY2(files.message().text.contains(QStringLiteral(": 3")), qPrintable(files.message().text));
    auto* strip = &child<QListWidget>(s.view, "colorStrip");
    QCOMPARE(strip->count(), 3);
    QCOMPARE(s.bench.frame()->label(), QStringLiteral("a.png"));
    QCOMPARE(s.bench.collected()[2].frame->width(), 320);
    QVERIFY2(strip->currentRow() == 0, "the one that is shown");
    s.bench.setFrame(s.bench.collected()[2].frame);
    QCOMPARE(strip->currentRow(), 2);
    s.bench.setFrame(s.bench.collected()[0].frame);
    s.settle();
    s.choose("orange");
    s.click(20, 20);
    QCOMPARE(s.bench.samples().strokes.size(), std::size_t{1});
    const auto& place = s.bench.samples().images.front();
    QCOMPARE(ColorFrame::fileOfName(place.name).filename().string(), std::string("a.png"));
    s.world.show();
    s.view.tick();
    QCOMPARE(s.bench.frame()->label(), QStringLiteral("a.png"));
    child<QAction>(s.view, "colorShowStripAction").trigger();
    QVERIFY(!strip->isVisible());
    s.view.resize(900, 400);
    child<QAction>(s.view, "colorShowStripAction").trigger();
    QVERIFY(strip->isVisible() && strip->height() < 60);
  }

  void aFolderWithoutPicturesIsReportedByItsName() {
    ShownColorImage s;
    QTemporaryDir folder;
    ColorFiles& files = colorFiles(s.world.context);
    QSignalSpy failed(&s.bench, &ColorBench::failed);
    files.openPictures({folder.path().toStdString()});
    QTRY_VERIFY((files.tick(), failed.count() == 1));
    const QString reason = failed[0][0].toString();
    QVERIFY2(reason.contains(folder.path()) && reason.contains(QStringLiteral(".yuyv")), qPrintable(reason));
  }

  void theCorrectionOfTheRobotsCameraGoesWithTheTable() {
    ShownColorImage s;
    s.choose("orange");
    s.click(8, 7);
    click(child<QToolButton>(s.view, "colorSend"));
    QVERIFY(!s.world.requests.back().set_color_table().table().has_correction());
    s.world.advance();
    colortool::Samples next = s.bench.samples();
    colortool::ColorCorrection correction;
    correction.vignetting.luma = {-0.25, 0.1};
    correction.channels[1] = {1.1, -3};
    next.corrections = {{"red1", correction}};
    next.settings.correctVignetting = next.settings.correctCameras = true;
    s.bench.change(QStringLiteral("correct"), std::move(next));
    s.settle();
    click(child<QToolButton>(s.view, "colorSend"));
    const auto& sent = s.world.requests.back().set_color_table().table().correction();
    QCOMPARE(sent.luma_r2(), -0.25);
    QCOMPARE(sent.luma_r4(), 0.1);
    QCOMPARE(sent.cb().gain(), 1.1);
    QCOMPARE(sent.cb().offset(), -3.0);
    QCOMPARE(sent.y().gain(), 1.0);
  }

  void eachNewTableIsSentWhileThatIsOn() {
    ShownColorImage s;
    click(child<QToolButton>(s.view, "colorAutoSend"));
    s.world.advance();
    const std::size_t before = s.world.requests.size();
    s.choose("orange");
    s.click(8, 7);
    QTRY_COMPARE(s.world.requests.size(), before + 1);
    s.choose("green");
    s.click(30, 7);
    QCOMPARE(s.world.requests.size(), before + 1);  // the last one is not yet confirmed
    s.world.advance();
    QTRY_COMPARE(s.world.requests.size(), before + 2);
    const auto& cells = s.world.requests.back().set_color_table().table().cells();
    QVERIFY(cells[colortool::ColorTable::cellOf({90, 110, 90})] != 0);
    s.world.advance();
    click(child<QToolButton>(s.view, "colorAutoSend"));
    s.click(35, 7);
    s.world.advance();
    QCOMPARE(s.world.requests.size(), before + 2);
  }

  void whatWasChosenComesBack() {
    ShownColorImage s;
    s.tool("colorToolWand");
    child<QSlider>(s.view, "colorOpacity").setValue(40);
    child<QComboBox>(s.view, "colorRightLayer").setCurrentIndex(3);
    ColorImageView other(s.world.context);
    other.restoreState(s.view.saveState());
    QVERIFY(child<QToolButton>(other, "colorToolWand").isChecked());
    QCOMPARE(child<QSlider>(other, "colorOpacity").value(), 40);
    QCOMPARE(child<QComboBox>(other, "colorRightLayer").currentIndex(), 3);
    other.restoreState({});
  }

  void looksRight() {
    ShownColorImage s;
    s.choose("orange");
    s.drag({{5, 5}, {9, 8}});
    s.choose("green");
    s.drag({{26, 5}, {34, 8}});
    QTest::keyClick(s.left, Qt::Key_C);
    moveMouse(*s.left, s.at(10, 10));
    keepPicture(s.view, "color-image-view");
  }
};

const GuiTest<ColorImageViewTest> kColorImageViewTest;

}  // namespace widgets::test

#include "ColorImageViewTest.moc"
