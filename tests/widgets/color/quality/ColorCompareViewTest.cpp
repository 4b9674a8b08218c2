// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/ColorCompareView.h"

#include <QAbstractItemModelTester>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <fstream>

#include "colortool/table/NamedColorTable.h"
#include "tests/TestFolder.h"
#include "tests/widgets/CameraBench.h"
#include "widgets/color/image/ColorImageView.h"

namespace widgets::test {
namespace {

using DifferenceModel = TableDifferenceModel;

/// The view on a table of an orange and a green stroke.
struct ShownCompare {
  CameraBench world;
  ColorBench& bench{colorBench(world.context)};
  ColorCompareView view{world.context};
  QTableView* table = &child<QTableView>(view, "colorCompareTable");
  QAbstractItemModelTester tester{table->model(), QAbstractItemModelTester::FailureReportingMode::Fatal};

  ShownCompare() {
    bench.setFrame(world.frame());
    stroke("orange", 8, 7);
    view.resize(620, 360);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the view is not shown");
    view.tick();
  }
  void stroke(const char* name, double x, double y) {
    bench.setCurrentClass(bench.samples().classes.index(name));
    const colortool::ImagePoint at[] = {{x, y}};
    bench.addStroke(colortool::brushArea(40, 30, at, 3), "brush");
    settle();
  }
  void settle() {
    QTRY_VERIFY(bench.upToDate());
    view.tick();
  }
  void press(const char* button) {
    QTest::mouseClick(&child<QToolButton>(view, button), Qt::LeftButton);
    view.tick();
  }
  /// Chooses the table as it was after so many steps.
  void chooseStep(int position) {
    auto* menu = &child<QMenu>(view, "colorCompareStepMenu");
    Q_EMIT menu->aboutToShow();
    const int steps = static_cast<int>(bench.document().steps());
    menu->actions().at(steps - position)->trigger();
    QTRY_VERIFY((view.tick(), bench.reference() != nullptr && model().rowCount() > 0));
  }
  void openFile(const std::filesystem::path& file) {
    press("colorCompareOpen");
    auto* dialog = &child<QFileDialog>(view, "colorCompareDialog");
    auto* name = &child<QLineEdit>(*dialog, "fileNameEdit");
    name->setText(QString::fromStdString(file.string()));
    QTest::keyClick(name, Qt::Key_Return);
    view.tick();
  }
  const QAbstractItemModel& model() const { return *table->model(); }
  QString text(const char* row, int column) const {
    for (int i = 0; i < model().rowCount(); ++i) {
      if (model().index(i, 0).data().toString() == QLatin1String(row))
        return model().index(i, column).data().toString();
    }
    return QStringLiteral("no row ") + QLatin1String(row);
  }
  int number(const char* row, int column) const { return text(row, column).toInt(); }
  void clickCell(const char* row, int column) {
    for (int i = 0; i < model().rowCount(); ++i) {
      if (model().index(i, 0).data().toString() != QLatin1String(row)) continue;
      table->scrollTo(model().index(i, column));
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                        table->visualRect(model().index(i, column)).center());
      return;
    }
    qFatal("there is no row %s", row);
  }
  QString shownText(const char* label) const { return child<QLabel>(view, label).text(); }
};

const robotlink::YCbCr kOrangeQuarter{140, 60, 200}, kGreenQuarter{90, 110, 90};

std::size_t cellOf(robotlink::YCbCr color) {
  return colortool::ColorTable::cellOf(color);
}

}  // namespace

class ColorCompareViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void theTableOfNowIsComparedWithWhatComes() {
    ShownCompare s;
    QCOMPARE(s.model().rowCount(), 0);
    s.press("colorCompareNow");
    QCOMPARE(s.shownText("colorCompareName"),
             QStringLiteral("Compared with the table after step 1, Stroke: orange"));
    QCOMPARE(s.model().rowCount(), s.bench.samples().classes.size() + 1);
    QCOMPARE(s.shownText("colorCompareSums"),
             QStringLiteral("No cell differs, of this image's pixels 0.00 %"));
    s.stroke("green", 30, 7);
    const int green = s.number("green", DifferenceModel::kAfter);
    QVERIFY(green > 100);
    QCOMPARE(s.number("green", DifferenceModel::kBefore), 0);
    QCOMPARE(s.number("green", DifferenceModel::kGained), green);
    QCOMPARE(s.text("green", DifferenceModel::kFrom), QStringLiteral("none %1").arg(green));
    QCOMPARE(s.text("none", DifferenceModel::kTo), QStringLiteral("green %1").arg(green));
    QCOMPARE(s.number("orange", DifferenceModel::kLost), 0);
    QCOMPARE(s.number("all changes", DifferenceModel::kGained), green);
    QVERIFY2(s.shownText("colorCompareSums").endsWith(QStringLiteral("of this image's pixels 25.00 %")),
             qPrintable(s.shownText("colorCompareSums")));
    s.bench.undoStack().undo();
    s.settle();
    QCOMPARE(s.number("all changes", DifferenceModel::kGained), 0);
    s.press("colorCompareNone");
    QCOMPARE(s.model().rowCount(), 0);
    QVERIFY(!s.bench.reference());
  }

  void aStepOfTheHistoryIsComparedWith() {
    ShownCompare s;
    s.stroke("green", 30, 7);
    s.stroke("white", 8, 22);
    s.chooseStep(1);
    QCOMPARE(s.shownText("colorCompareName"),
             QStringLiteral("Compared with the table after step 1, Stroke: orange"));
    QVERIFY(s.number("orange", DifferenceModel::kBefore) > 100);
    QCOMPARE(s.number("green", DifferenceModel::kBefore), 0);
    QVERIFY(s.number("white", DifferenceModel::kGained) > 100);
    QCOMPARE(s.bench.document().position(), std::size_t{3});
    QCOMPARE(s.bench.undoStack().count(), 3);
    s.chooseStep(0);
    QTRY_COMPARE((s.view.tick(), s.shownText("colorCompareName")),
                 QStringLiteral("Compared with the table before all steps"));
    QCOMPARE(s.number("orange", DifferenceModel::kBefore), 0);
  }

  void aClickSelectsWhatChanged() {
    ShownCompare s;
    s.press("colorCompareNow");
    s.stroke("green", 30, 7);
    s.clickCell("green", DifferenceModel::kGained);
    QVERIFY(s.bench.hasSelection());
    QCOMPARE(static_cast<int>(s.bench.selection().size()), s.number("green", DifferenceModel::kGained));
    QVERIFY(s.bench.selection().contains(cellOf(kGreenQuarter)));
    QVERIFY(!s.bench.selection().contains(cellOf(kOrangeQuarter)));
    s.clickCell("green", DifferenceModel::kLost);
    QVERIFY(s.bench.selection().empty());
    s.clickCell("all changes", DifferenceModel::kClass);
    QCOMPARE(static_cast<int>(s.bench.selection().size()), s.number("all changes", DifferenceModel::kGained));
    QTest::keyClick(s.table, Qt::Key_Escape);
    QVERIFY(!s.bench.hasSelection());
    QTest::keyClick(s.table, Qt::Key_Up);  // none, what green took of it
    QCOMPARE(static_cast<int>(s.bench.selection().size()), s.number("none", DifferenceModel::kLost));
  }

  void theSelectionFollowsTheTableUntilAnotherTakesItsPlace() {
    ShownCompare s;
    s.press("colorCompareNow");
    s.stroke("green", 30, 7);
    s.clickCell("all changes", DifferenceModel::kClass);
    const std::size_t before = s.bench.selection().size();
    s.stroke("white", 8, 22);
    QVERIFY(s.bench.selection().size() > before);
    colortool::CellSet other;
    other.set(cellOf(kOrangeQuarter));
    s.bench.select(other);
    s.stroke("white", 10, 24);
    QVERIFY(s.bench.selection() == other);
  }

  void tablesOfFilesAreMatchedByTheirClassesNames() {
    const TestFolder folder;
    colortool::NamedColorTable named;
    named.classes = colortool::ColorClasses({{"green", {0, 160, 40}}, {"violet", {160, 0, 200}}});
    named.file.cells[cellOf(kGreenQuarter)] = 1;
    named.file.cells[cellOf(kOrangeQuarter)] = 2;
    QVERIFY(named.save(folder / "old.c64"));
    ShownCompare s;
    s.openFile(folder / "old.c64");
    QCOMPARE(s.shownText("colorCompareName"), QStringLiteral("Compared with old.c64"));
    QCOMPARE(s.text("green", DifferenceModel::kTo), QStringLiteral("none 1"));
    QCOMPARE(s.text("violet", DifferenceModel::kTo), QStringLiteral("orange 1"));
    QVERIFY(s.text("orange", DifferenceModel::kFrom).endsWith(QStringLiteral("violet 1")));
    // As the samples number their classes, for what compares pixels.
    QCOMPARE(s.bench.reference()->classOf(kGreenQuarter), s.bench.samples().classes.index("green"));
    QCOMPARE(s.bench.reference()->classOf(kOrangeQuarter), colortool::ColorClasses::kNone);
    // The folder is remembered.
    QCOMPARE(s.view.saveState()[QStringLiteral("folder")].toString(),
             QString::fromStdString(folder.path().string()));
  }

  void theReferenceFollowsTheSamplesClasses() {
    ShownCompare s;
    s.press("colorCompareNow");
    const std::uint8_t orange = s.bench.reference()->classOf(kOrangeQuarter);
    colortool::Samples next = s.bench.samples();
    std::vector<std::uint8_t> numbers(static_cast<std::size_t>(next.classes.size()), std::uint8_t{0});
    numbers[orange] = 2;
    colortool::changeClasses(
        next, colortool::ColorClasses({{"white", {255, 255, 255}}, {"orange", {255, 105, 0}}}), numbers);
    s.bench.change(QStringLiteral("Classes"), std::move(next));
    QCOMPARE(int{s.bench.reference()->classOf(kOrangeQuarter)}, 2);
    s.settle();
    QCOMPARE(s.number("orange", DifferenceModel::kLost), 0);
    QCOMPARE(s.number("all changes", DifferenceModel::kGained), 0);
    s.bench.undoStack().undo();
    QCOMPARE(s.bench.reference()->classOf(kOrangeQuarter), orange);
  }

  void aBrokenFileIsSaidAndLosesNothing() {
    const TestFolder folder;
    std::ofstream(folder / "broken.c64") << "no table";
    ShownCompare s;
    s.press("colorCompareNow");
    s.openFile(folder / "broken.c64");
    auto* problem = &child<QLabel>(s.view, "colorCompareProblem");
    QVERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains(QStringLiteral("broken.c64")), qPrintable(problem->text()));
    QCOMPARE(s.shownText("colorCompareName"),
             QStringLiteral("Compared with the table after step 1, Stroke: orange"));
    s.press("colorCompareNow");
    QVERIFY(!problem->isVisible());
  }

  void theDifferenceIsShownInTheImage() {
    ShownCompare s;
    s.world.show();
    ColorImageView image(s.world.context);
    s.settle();
    s.press("colorCompareNow");
    s.press("colorCompareShow");
    QCOMPARE(child<QComboBox>(image, "colorRightLayer").currentText(), QStringLiteral("Difference"));
  }

  void looksRight() {
    ShownCompare s;
    keepPicture(s.view, "color-compare-empty");
    s.press("colorCompareNow");
    s.stroke("green", 30, 7);
    s.stroke("white", 8, 22);
    s.stroke("yellow", 12, 4);
    s.clickCell("yellow", DifferenceModel::kGained);
    keepPicture(s.view, "color-compare-view");
  }
};

const GuiTest<ColorCompareViewTest> kColorCompareViewTest;

}  // namespace widgets::test

#include "ColorCompareViewTest.moc"
