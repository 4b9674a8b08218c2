// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/ColorQualityView.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <fstream>

#include "tests/game/Data.h"
#include "tests/widgets/CameraBench.h"
#include "tests/widgets/DialogAnswer.h"
#include "widgets/color/LabeledFolder.h"
#include "widgets/color/quality/ConfusionModel.h"

namespace widgets::test {

/// Figures of a table, and where they come from.
class ColorQualityViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void falseColorsAreThoseThatThingsHave() {
    ConfusionModel model;
    colortool::Evaluation evaluation(4);  // none, orange, green, white
    evaluation.add(0, 3, 60);
    evaluation.add(0, 2, 20);
    evaluation.add(0, 1, 10);
    evaluation.add(0, 0, 10);
    model.setEvaluation(colortool::emptySamples().classes, evaluation);
    QCOMPARE(model.falseColors().value_or(-1), 0.1);
  }

  void init() {
    world_ = std::make_unique<CameraBench>();
    bench_ = &colorBench(world_->context);
    bench_->setDocument(colortool::emptySamples());
    bench_->setFrame(world_->frame());
    view_ = std::make_unique<ColorQualityView>(world_->context);
    view_->resize(900, 300);
    view_->show();
    QVERIFY(QTest::qWaitForWindowActive(view_.get()));
    testers_.clear();
    for (const char* name : {"strokesMatrix", "labeledMatrix"}) {
      testers_.push_back(std::make_unique<QAbstractItemModelTester>(
          child<QTableView>(*view_, name).model(), QAbstractItemModelTester::FailureReportingMode::Fatal));
    }
  }
  void cleanup() {
    testers_.clear();
    view_.reset();
    world_.reset();
  }

  void tooLittleToJudgeByIsSaid() {
    QVERIFY(hint("strokesMatrix").contains(QStringLiteral("at least two of each class")));
    QVERIFY(hint("labeledMatrix").contains(QStringLiteral("No labeled images")));
    stroke(1, 8, 7);
    stroke(1, 10, 7);
    stroke(2, 30, 7);
    QTRY_COMPARE(cell("strokesMatrix", "orange", "Recall"), QStringLiteral("100.0 %"));
    QCOMPARE(cell("strokesMatrix", "green", "Recall"), QStringLiteral("–"));
    const QString note = child<QLabel>(*view_, "strokesNote").text();
    QVERIFY(note.contains(QStringLiteral("green")) && !note.contains(QStringLiteral("orange")));
    QVERIFY(note.contains(QStringLiteral("background")));
    QVERIFY(summary("strokes").contains(QStringLiteral("Mean recall 100.00 %")));
    QVERIFY(summary("strokes").contains(QStringLiteral("False colors –")));
  }

  void theColumnsOfAMatrixFitTheirRoom() {
    goodStrokes();
    QTRY_VERIFY(summary("strokes").contains(QStringLiteral("Mean recall 100.00 %")));
    const auto& table = child<QTableView>(*view_, "strokesMatrix");
    const auto width = [&] { return table.horizontalHeader()->length(); };
    QTRY_VERIFY(width() <= table.viewport()->width());
    const int whole = width();
    // The titles are cut before the shares are.
    view_->resize(view_->width() - (table.viewport()->width() - whole) - 60, 300);
    QTRY_VERIFY(width() < whole && width() <= table.viewport()->width());
    for (int column = 0; column < table.model()->columnCount(); ++column)
      QVERIFY(table.columnWidth(column) >=
              static_cast<const QAbstractItemView&>(table).sizeHintForColumn(column));
  }

  void figuresFollowStrokesAndUndo() {
    goodStrokes();
    QTRY_VERIFY(summary("strokes").contains(QStringLiteral("Mean recall 100.00 %")));
    QVERIFY(summary("strokes").contains(QStringLiteral("False colors 0.00 %")));
    stroke(2, 8, 9);  // green, it says, on orange
    stroke(2, 12, 9);
    QTRY_VERIFY(cell("strokesMatrix", "green", "orange").toDouble() > 0 ||
                cell("strokesMatrix", "orange", "green").toDouble() > 0);
    keepPicture(*view_, "color-quality-mistakes");
    QTest::keyClick(view_.get(), Qt::Key_Z, Qt::ControlModifier);
    click(*view_, "colorQualityUndo");
    QTRY_VERIFY(summary("strokes").contains(QStringLiteral("Mean recall 100.00 %")));
  }

  void labeledImagesAreScoredByTheNamesOfTheirClasses() {
    goodStrokes();
    LabeledFrame labeled{world_->frame(),
                         std::vector<std::uint8_t>(40 * 30, colortool::Evaluation::kIgnored),
                         {"none", "white", "orange"}};
    for (int y = 0; y < 15; ++y) std::fill_n(labeled.labels.begin() + y * 40, 20, std::uint8_t{2});
    for (int y = 15; y < 30; ++y) std::fill_n(labeled.labels.begin() + y * 40 + 20, 20, std::uint8_t{0});
    bench_->setLabeled({labeled});
    QTRY_COMPARE(cell("labeledMatrix", "orange", "Recall"), QStringLiteral("100.0 %"));
    QCOMPARE(cell("labeledMatrix", "background", "none"), QStringLiteral("100.0"));
    QVERIFY(summary("labeled").contains(QStringLiteral("False colors 0.00 %")));
    // What the table takes for right is shaded, and still reads.
    auto* table = &child<QTableView>(*view_, "labeledMatrix");
    const QImage picture = table->viewport()->grab().toImage();
    const QRect right = table->visualRect(index(*table, "orange", "orange"));
    QVERIFY(picture.pixelColor(right.topLeft() + QPoint(3, 3)) != table->palette().color(QPalette::Base));
    keepPicture(*view_, "color-quality");
  }

  void aFolderOfLabeledImagesIsRead_data() {
    QTest::addColumn<QString>("source");
    for (const std::string& source : game::kSources)
      QTest::newRow(source.c_str()) << QString::fromStdString(source);
  }
  void aFolderOfLabeledImagesIsRead() {
    QFETCH(QString, source);
    const std::string folder = (game::dataOf(source.toStdString()) / "colour/bhuman2009").string();
    if (!std::filesystem::exists(folder))
      QSKIP("the labeled images of the real log are not here (../shared/data/colour)");
    const auto name = DialogAnswer::file(QString::fromStdString(folder));
    click(*view_, "qualityOpen");
    QTRY_VERIFY((view_->tick(), bench_->labeled().size() == 3));
    QVERIFY(state().contains(QStringLiteral("images: 3")));
    const LabeledFrame& first = bench_->labeled()[0];
    QCOMPARE(first.frame->width(), 640);
    QCOMPARE(first.classNames[3], std::string("blue"));
    QVERIFY(std::ranges::count(first.labels, 5) > 1000);  // the field
    goodStrokes();
    QTRY_VERIFY(!cell("labeledMatrix", "green", "Recall").isEmpty());
    view_->tick();
    click(*view_, "qualityClose");
    QVERIFY(bench_->labeled().empty());
    QVERIFY(hint("labeledMatrix").contains(QStringLiteral("No labeled images")));
  }

  void aFolderWithoutLabelsIsReportedAndChangesNothing() {
    QTemporaryDir folder;
    std::ofstream(folder.filePath(QStringLiteral("a.png")).toStdString()) << "no picture";
    const auto name = DialogAnswer::file(folder.path());
    QSignalSpy failed(bench_, &ColorBench::failed);
    click(*view_, "qualityOpen");
    QTRY_VERIFY((view_->tick(), state().contains(QStringLiteral("No labeled images"))));
    QCOMPARE(failed.count(), 1);
    QVERIFY2(failed[0][0].toString().contains(folder.path()), "the window has room for the whole reason");
    QVERIFY2(hint("labeledMatrix").contains(QStringLiteral("the only image here has no labels")),
             "the whole reason, where there is room for it");
    QVERIFY(bench_->labeled().empty());
  }

  void theFolderOfTheLabelsDoesAsWell() {
    QTemporaryDir folder;
    for (const char* name : {"images", "labels"}) QDir(folder.path()).mkpath(QLatin1String(name));
    QImage image(8, 6, QImage::Format_RGB888), labels(8, 6, QImage::Format_Grayscale8);
    image.fill(0xffff8000);
    labels.fill(1);
    QVERIFY(image.save(folder.filePath(QStringLiteral("images/a.png"))));
    QVERIFY(labels.save(folder.filePath(QStringLiteral("labels/a.png"))));
    for (const char* name : {"", "images", "labels"}) {
      LabeledFolder reading(folder.filePath(QLatin1String(name)).toStdString(), "nao");
      std::optional<robotlink::Result<LabeledFolder::Read>> read;
      QTRY_VERIFY((read = read ? std::move(read) : reading.take()).has_value());
      QVERIFY2(read->has_value(), name);
      QCOMPARE((*read)->frames.size(), std::size_t{1});
    }
  }

  void howFewStrokesTheFiguresStandOnIsSaidAndThatTheyCountAlike() {
    goodStrokes();
    QTRY_VERIFY(
        note().contains(QStringLiteral("Based on 8 strokes, at least 2 per class and 2 of the background")));
    QVERIFY(note().contains(QStringLiteral("the figures are only a rough guide")));
    bench_->undoStack().undo();  // the second stroke of the background
    QTRY_VERIFY(summary("strokes").contains(QStringLiteral("False colors –")));
    QVERIFY(note().contains(QStringLiteral("A single stroke of the background")));
  }

  void aHugeGreenStrokeOverTheWallLowersTheQuality() {
    goodStrokes();
    QTRY_VERIFY(summary("strokes").contains(QStringLiteral("Mean recall 100.00 %")));
    QVERIFY(!note().contains(QStringLiteral("Of the background")));
    bench_->setCurrentClass(2);
    bench_->addStroke(colortool::rectangleArea(40, 30, {22, 17}, {38, 28}), "rectangle");
    // All of its pixels are missed by the table of the other strokes: a third of green. The wall is green
    // now.
    QTRY_VERIFY2(summary("strokes").contains(QStringLiteral("Mean recall 88.89 %")),
                 qPrintable(summary("strokes")));
    QVERIFY2(note().contains(QStringLiteral("Of the background it takes for a class: 100 % green.")),
             qPrintable(note()));
  }

  void twoHugeStrokesThatVouchForEachOtherAreSeenThroughInTheImagesOfTheLog() {
    goodStrokes();
    bench_->setLogImages({world_->frame(40, 30, 1), world_->frame(40, 30, 2)});
    QTRY_VERIFY2(note().contains(QStringLiteral("In 2 images spread over the log")), qPrintable(note()));
    QVERIFY2(!note().contains(QStringLiteral("background's colors")), qPrintable(note()));
    bench_->setCurrentClass(2);
    bench_->addStroke(colortool::rectangleArea(40, 30, {21, 16}, {39, 22}), "rectangle");
    bench_->addStroke(colortool::rectangleArea(40, 30, {21, 23}, {39, 29}), "rectangle");
    // Each of both has a recall of 100 %, since the other one has the same colors.
    QTRY_VERIFY2(
        note().contains(QStringLiteral("Of the background's colors there it takes for a class: 100 % "
                                       "green.")),
        qPrintable(note()));
    QTRY_VERIFY2(summary("strokes").contains(QStringLiteral("Mean recall 100.00 %")),
                 qPrintable(summary("strokes")));
    bench_->setLogImages({});
    QTRY_VERIFY(!note().contains(QStringLiteral("spread over the log")));
  }

  void oneStrokeIsNotCalledStrokes() {
    colortool::Samples one = colortool::quarterSamples();
    one.strokes.resize(1);
    bench_->change(QStringLiteral("One stroke"), std::move(one));
    QTRY_VERIFY2(note().contains(QStringLiteral("Based on 1 stroke,")), qPrintable(note()));
  }

  void theTableThatItIsComparedWithIsScoredBesideIt() {
    goodStrokes();
    bench_->setReference(std::make_shared<colortool::ColorTable>(), QStringLiteral("nothing.c64"));
    QTRY_VERIFY2(note().contains(QStringLiteral("nothing.c64: mean recall 0.00 %")), qPrintable(note()));
    QVERIFY(note().contains(QStringLiteral("yours is better")));
  }

  void damagedImagesAreLeftOutAndReported() {
    QTemporaryDir folder;
    QDir(folder.path()).mkpath(QStringLiteral("labels"));
    const auto put = [&folder](const char* name, QSize size, QImage::Format format) {
      QImage image(size, format);
      image.fill(format == QImage::Format_Grayscale8 ? 1 : 0xffff8000);
      QVERIFY(image.save(folder.filePath(QLatin1String(name))));
    };
    put("good.png", {8, 6}, QImage::Format_RGB888);
    put("labels/good.png", {8, 6}, QImage::Format_Grayscale8);
    put("small.png", {8, 6}, QImage::Format_RGB888);
    put("labels/small.png", {4, 6}, QImage::Format_Grayscale8);
    std::ofstream(folder.filePath(QStringLiteral("broken.yuyv")).toStdString()) << "short";
    put("labels/broken.png", {8, 6}, QImage::Format_Grayscale8);
    put("alone.png", {8, 6}, QImage::Format_RGB888);
    LabeledFolder reading(folder.path().toStdString(), "nao");
    std::optional<robotlink::Result<LabeledFolder::Read>> read;
    QTRY_VERIFY((read = read ? std::move(read) : reading.take()).has_value());
    QVERIFY(read->has_value());
    QCOMPARE((*read)->frames.size(), std::size_t{1});
    QCOMPARE((*read)->frames[0].frame->place().camera, std::string("nao"));
    QCOMPARE((*read)->problems.size(), std::size_t{2});
    const std::string problems = robotlink::describe((*read)->problems);
    QVERIFY(problems.find("small.png") != std::string::npos &&
            problems.find("broken.yuyv") != std::string::npos);
  }

 private:
  static QModelIndex index(const QTableView& table, const char* row, const char* column) {
    const auto* model = table.model();
    for (int r = 0; r < model->rowCount(); ++r) {
      for (int c = 0; c < model->columnCount(); ++c) {
        if (model->headerData(r, Qt::Vertical).toString() == QLatin1String(row) &&
            model->headerData(c, Qt::Horizontal).toString() == QLatin1String(column))
          return model->index(r, c);
      }
    }
    return {};
  }
  QString cell(const char* matrix, const char* row, const char* column) const {
    return index(child<QTableView>(*view_, matrix), row, column).data().toString();
  }
  QString hint(const char* matrix) const {
    return child<QLabel>(*child<QTableView>(*view_, matrix).viewport(), "emptyHint").text();
  }
  QString summary(const char* name) const {
    return child<QLabel>(*view_, (QByteArray(name) + "Summary").constData()).text();
  }
  QString note() const { return child<QLabel>(*view_, "strokesNote").text(); }
  QString state() const { return child<QLabel>(*view_, "qualityState").text(); }
  void stroke(int colorClass, double x, double y) {
    bench_->setCurrentClass(colorClass);
    const colortool::ImagePoint at[] = {{x, y}};
    bench_->addStroke(colortool::brushArea(40, 30, at, 3), "brush");
  }
  void goodStrokes() {
    for (const double dx : {0.0, 4.0}) {
      stroke(1, 8 + dx, 7);
      stroke(2, 28 + dx, 7);
      stroke(3, 8 + dx, 22);
      stroke(0, 28 + dx, 22);
    }
  }

  std::unique_ptr<CameraBench> world_;
  std::unique_ptr<ColorQualityView> view_;
  std::vector<std::unique_ptr<QAbstractItemModelTester>> testers_;
  ColorBench* bench_ = nullptr;
};

const GuiTest<ColorQualityViewTest> kColorQualityViewTest;

}  // namespace widgets::test

#include "ColorQualityViewTest.moc"
