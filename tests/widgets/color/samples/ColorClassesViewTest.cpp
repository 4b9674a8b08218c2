// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/ColorClassesView.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include "tests/widgets/CameraBench.h"
#include "tests/widgets/DialogAnswer.h"

namespace widgets::test {

/// Classes as a person edits them, and how the table is made.
class ColorClassesViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = std::make_unique<CameraBench>();
    bench_ = &colorBench(world_->context);
    bench_->setDocument(colortool::emptySamples());
    bench_->setFrame(world_->frame());
    view_ = std::make_unique<ColorClassesView>(world_->context);
    view_->resize(380, 560);
    view_->show();
    QVERIFY(QTest::qWaitForWindowActive(view_.get()));
    tree_ = &child<QTreeView>(*view_, "classesTree");
    tester_ = std::make_unique<QAbstractItemModelTester>(
        tree_->model(), QAbstractItemModelTester::FailureReportingMode::Fatal);
  }
  void cleanup() {
    tester_.reset();
    view_.reset();
    world_.reset();
  }

  void clickAndDigitsChooseTheClass() {
    QCOMPARE(text(0, ColorClassModel::kName), QStringLiteral("background"));
    clickRow(2);
    QCOMPARE(bench_->currentClass(), 2);
    QTest::keyClick(tree_, Qt::Key_3);
    QCOMPARE(bench_->currentClass(), 3);
    QCOMPARE(tree_->currentIndex().row(), 3);
    QTest::keyClick(tree_, Qt::Key_9);  // there is none
    QCOMPARE(bench_->currentClass(), 3);
    QTest::keyClick(tree_, Qt::Key_0);
    QCOMPARE(bench_->currentClass(), 0);
    QVERIFY(!child<QToolButton>(*view_, "mustNotBe").isEnabled());
  }

  void strokesAreCountedAndScored() {
    for (const double x : {8.0, 10.0, 12.0}) stroke(1, x, 7);
    stroke(2, 30, 7);
    QCOMPARE(text(1, ColorClassModel::kStrokes), QStringLiteral("3"));
    QCOMPARE(text(1, ColorClassModel::kPixels), QStringLiteral("87"));
    QTRY_COMPARE(text(1, ColorClassModel::kRecall), QStringLiteral("100.0 %"));
    QVERIFY2(text(2, ColorClassModel::kRecall) == QStringLiteral("–"),
             "one stroke says nothing of its class");
  }

  void aNameIsEditedInPlaceAndUndone() {
    clickRow(1);
    QTest::keyClick(tree_, Qt::Key_F2);
    typeName(QStringLiteral("ball 3"));  // the digit is no shortcut here
    QTRY_COMPARE(bench_->samples().classes.name(1), std::string("ball 3"));
    QCOMPARE(bench_->currentClass(), 1);
    QTest::keyClick(tree_, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench_->samples().classes.name(1), std::string("orange"));
    QTest::keyClick(tree_, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(bench_->samples().classes.name(1), std::string("ball 3"));
  }

  void aNameThatIsTakenIsRefusedWithTheReason() {
    clickRow(1);
    QTest::keyClick(tree_, Qt::Key_F2);
    typeName(QStringLiteral("green"));
    QTRY_VERIFY(message().contains(QStringLiteral("'green'")));
    QCOMPARE(bench_->samples().classes.name(1), std::string("orange"));
    QCOMPARE(bench_->undoStack().count(), 0);
  }

  void aClickOnTheChosenClassesColorPicksAnother() {
    clickRow(2);
    const QPoint swatch = tree_->visualRect(index(2, ColorClassModel::kName)).topLeft() + QPoint(8, 8);
    DialogAnswer pink([](QDialog& dialog) {
      auto& colors = static_cast<QColorDialog&>(dialog);
      colors.setCurrentColor(QColor(250, 90, 160));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {}, swatch);
    QVERIFY(pink.asked());
    QCOMPARE(bench_->samples().classes.shownColor(2), (robotlink::Rgb{250, 90, 160}));
    bench_->undoStack().undo();
    QCOMPARE(bench_->samples().classes.shownColor(2), (robotlink::Rgb{0, 160, 40}));
  }

  void classesAreAddedMovedAndRemovedWithTheirStrokes() {
    stroke(2, 30, 7);
    press("classAdd");
    typeName(QStringLiteral("goal"));
    QTRY_COMPARE(bench_->samples().classes.name(4), std::string("goal"));
    QCOMPARE(bench_->currentClass(), 4);
    press("classUp");
    QCOMPARE(bench_->samples().classes.name(3), std::string("goal"));
    QCOMPARE(bench_->currentClass(), 3);
    clickRow(2);
    press("classDown");
    QCOMPARE(bench_->samples().classes.name(3), std::string("green"));
    QCOMPARE(int{bench_->samples().strokes[0]->colorClass}, 3);
    press("classRemove");
    QVERIFY(bench_->samples().strokes.empty());
    QVERIFY(message().contains(QStringLiteral("1 stroke;")));
    press("colorClassesUndo");
    QVERIFY(message().isEmpty());
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{1});
    QCOMPARE(bench_->samples().classes.name(bench_->samples().strokes[0]->colorClass), std::string("green"));
  }

  void aPresetKeepsStrokesByTheirClass() {
    stroke(2, 30, 7);
    auto* menu = &child<QMenu>(*view_, "classPresets");
    child<QAction>(*menu, "preset.bhuman2009").trigger();
    const auto& samples = bench_->samples();
    QCOMPARE(samples.classes.name(3), std::string("blue"));
    QCOMPARE(samples.classes.name(samples.strokes[0]->colorClass), std::string("green"));
    bench_->undoStack().undo();
    QCOMPARE(bench_->samples().classes.size(), 4);
  }

  void whatTheNextStrokeSaysIsSetByMouseAndKeys() {
    clickRow(1);
    QTest::keyClick(tree_, Qt::Key_N);
    QVERIFY(bench_->mustNotBe());
    QVERIFY(child<QToolButton>(*view_, "mustNotBe").isChecked());
    press("mustNotBe");
    QVERIFY(!bench_->mustNotBe());
    auto* weight = &child<QDoubleSpinBox>(*view_, "strokeWeight");
    weight->selectAll();
    QTest::keyClicks(weight, QStringLiteral("2.5"));
    QTest::keyClick(weight, Qt::Key_Return);
    QCOMPARE(bench_->weight(), 2.5);
    QCOMPARE(bench_->currentClass(), 1);  // its digits chose nothing
  }

  void aDragOfASliderIsOneStep() {
    press("trainingShown");
    auto* slider = &child<QSlider>(*view_, "radius-slider");
    QVERIFY(slider->isVisible());
    const QPoint from(handle(*slider), slider->height() / 2);
    drag(*slider, Qt::LeftButton, from, from + QPoint(40, 0));
    const double radius = bench_->samples().settings.votes.radius;
    QVERIFY(radius > 9);
    QCOMPARE(child<QDoubleSpinBox>(*view_, "radius").value(), radius);
    QCOMPARE(bench_->undoStack().count(), 1);
    const QPoint there(handle(*slider), slider->height() / 2);
    drag(*slider, Qt::LeftButton, there, there - QPoint(60, 0));
    QCOMPARE(bench_->undoStack().count(), 2);
    bench_->undoStack().undo();
    QCOMPARE(bench_->samples().settings.votes.radius, radius);
    bench_->undoStack().undo();
    QCOMPARE(bench_->samples().settings.votes.radius, 8.0);
    QCOMPARE(child<QDoubleSpinBox>(*view_, "radius").value(), 8.0);
  }

  void theMethodShowsItsOwnOptions() {
    press("trainingShown");
    auto* method = &child<QComboBox>(*view_, "trainingMethod");
    QTest::keyClick(method, Qt::Key_Down);
    QCOMPARE(bench_->samples().settings.method, colortool::TrainingMethod::kGaussians);
    QVERIFY(!child<QSlider>(*view_, "radius-slider").isVisible());
    auto* distance = &child<QDoubleSpinBox>(*view_, "gaussian-distance");
    QVERIFY(distance->isVisible());
    distance->selectAll();
    QTest::keyClicks(distance, QStringLiteral("12"));
    QTest::keyClick(distance, Qt::Key_Return);
    QCOMPARE(bench_->samples().settings.gaussians.mostSquaredDistance, 12.0);
    auto* holes = &child<QCheckBox>(*view_, "fill-holes");
    QTest::mouseClick(holes, Qt::LeftButton, {}, {8, holes->height() / 2});
    QVERIFY(!bench_->samples().settings.cleanUp.fillHoles);
    press("trainingDefaults");
    QCOMPARE(bench_->samples().settings, colortool::TrainingSettings{});
    QCOMPARE(bench_->undoStack().count(), 4);
    QVERIFY(!child<QToolButton>(*view_, "trainingDefaults").isEnabled());
  }

  void correctionsAreEstimatedAndWhatIsMissingIsSaid() {
    press("trainingShown");
    stroke(1, 8, 7);
    press("estimateCorrections");
    QVERIFY2(!message().isEmpty(), "one stroke tells nothing of the lens; that is to be said");
    QVERIFY(bench_->samples().corrections.empty());
    QCOMPARE(bench_->undoStack().count(), 1);
  }

  void looksWell() {
    bench_->setDocument(colortool::quarterSamples());
    for (const double x : {8.0, 10.0, 12.0}) stroke(1, x, 7);
    stroke(2, 32, 8);
    press("trainingShown");
    bench_->setMustNotBe(true);
    QTRY_VERIFY(bench_->quality() != nullptr);
    keepPicture(*view_, "color-classes");
  }

 private:
  QModelIndex index(int row, int column) const { return tree_->model()->index(row, column); }
  QString text(int row, int column) const { return index(row, column).data().toString(); }
  QString message() const { return child<QLabel>(*view_, "colorMessage").text(); }
  void press(const char* button) { click(*view_, button); }
  void clickRow(int row) {
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {},
                      tree_->visualRect(index(row, ColorClassModel::kStrokes)).center());
  }
  void typeName(const QString& name) {
    auto* edit = tree_->viewport()->findChild<QLineEdit*>();
    QVERIFY(edit != nullptr);
    edit->selectAll();
    QTest::keyClicks(edit, name);
    QTest::keyClick(edit, Qt::Key_Return);
  }
  void stroke(int colorClass, double x, double y) {
    bench_->setCurrentClass(colorClass);
    const colortool::ImagePoint at[] = {{x, y}};
    bench_->addStroke(colortool::brushArea(40, 30, at, 3), "brush");
  }
  static int handle(const QSlider& slider) {
    constexpr int kHandle = 12;  // about
    const double share = static_cast<double>(slider.value()) / slider.maximum();
    return kHandle / 2 + static_cast<int>(share * (slider.width() - kHandle));
  }

  std::unique_ptr<CameraBench> world_;
  std::unique_ptr<ColorClassesView> view_;
  std::unique_ptr<QAbstractItemModelTester> tester_;
  ColorBench* bench_ = nullptr;
  QTreeView* tree_ = nullptr;
};

const GuiTest<ColorClassesViewTest> kColorClassesViewTest;

}  // namespace widgets::test

#include "ColorClassesViewTest.moc"
