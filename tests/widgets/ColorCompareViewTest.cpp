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
#include "tests/widgets/ColorWorld.h"
#include "widgets/color/image/ColorImageView.h"

namespace widgets::test {
namespace {

using Model = TableDifferenceModel;

/// The view on a table of an orange and a green stroke.
struct Shown {
  ColorWorld world;
  ColorBench& bench{colorBench(world.context)};
  ColorCompareView view{world.context};
  QTableView* table = child<QTableView>(view, "colorCompareTable");
  QAbstractItemModelTester tester{table->model(), QAbstractItemModelTester::FailureReportingMode::Fatal};

  Shown() {
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
    QTest::mouseClick(child<QToolButton>(view, button), Qt::LeftButton);
    view.tick();
  }
  /// Chooses the table as it was after so many steps.
  void chooseStep(int position) {
    auto* menu = child<QMenu>(view, "colorCompareStepMenu");
    Q_EMIT menu->aboutToShow();
    const int steps = static_cast<int>(bench.document().steps());
    menu->actions().at(steps - position)->trigger();
    QTRY_VERIFY((view.tick(), bench.reference() != nullptr && model().rowCount() > 0));
  }
  void openFile(const std::filesystem::path& file) {
    press("colorCompareOpen");
    auto* dialog = child<QFileDialog>(view, "colorCompareDialog");
    auto* name = child<QLineEdit>(*dialog, "fileNameEdit");
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
  QString shownText(const char* label) const { return child<QLabel>(view, label)->text(); }
};

const robotlink::YCbCr kOrange{140, 60, 200}, kGreen{90, 110, 90};

std::size_t cellOf(robotlink::YCbCr color) {
  return colortool::ColorTable::cellOf(color);
}

}  // namespace

class ColorCompareViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { failAtWarnings(); }

  void theTableOfNowIsComparedWithWhatComes() {
    Shown s;
    QCOMPARE(s.model().rowCount(), 0);
    s.press("colorCompareNow");
    QCOMPARE(s.shownText("colorCompareName"),
             QStringLiteral("Compared with the table after step 1, Stroke: orange"));
    QCOMPARE(s.model().rowCount(), s.bench.samples().classes.size() + 1);
    QCOMPARE(s.shownText("colorCompareSums"),
             QStringLiteral("No cell differs, of this image's pixels 0.00 %"));
    s.stroke("green", 30, 7);
    const int green = s.number("green", Model::kAfter);
    QVERIFY(green > 100);
    QCOMPARE(s.number("green", Model::kBefore), 0);
    QCOMPARE(s.number("green", Model::kGained), green);
    QCOMPARE(s.text("green", Model::kFrom), QStringLiteral("none %1").arg(green));
    QCOMPARE(s.text("none", Model::kTo), QStringLiteral("green %1").arg(green));
    QCOMPARE(s.number("orange", Model::kLost), 0);
    QCOMPARE(s.number("all changes", Model::kGained), green);
    QVERIFY2(s.shownText("colorCompareSums").endsWith(QStringLiteral("of this image's pixels 25.00 %")),
             qPrintable(s.shownText("colorCompareSums")));
    s.bench.undoStack().undo();
    s.settle();
    QCOMPARE(s.number("all changes", Model::kGained), 0);
    s.press("colorCompareNone");
    QCOMPARE(s.model().rowCount(), 0);
    QVERIFY(!s.bench.reference());
  }

  void aStepOfTheHistoryIsComparedWith() {
    Shown s;
    s.stroke("green", 30, 7);
    s.stroke("white", 8, 22);
    s.chooseStep(1);
    QCOMPARE(s.shownText("colorCompareName"),
             QStringLiteral("Compared with the table after step 1, Stroke: orange"));
    QVERIFY(s.number("orange", Model::kBefore) > 100);
    QCOMPARE(s.number("green", Model::kBefore), 0);
    QVERIFY(s.number("white", Model::kGained) > 100);
    QCOMPARE(s.bench.document().position(), std::size_t{3});
    QCOMPARE(s.bench.undoStack().count(), 3);
    s.chooseStep(0);
    QTRY_COMPARE((s.view.tick(), s.shownText("colorCompareName")),
                 QStringLiteral("Compared with the table before all steps"));
    QCOMPARE(s.number("orange", Model::kBefore), 0);
  }

  void aClickSelectsWhatChanged() {
    Shown s;
    s.press("colorCompareNow");
    s.stroke("green", 30, 7);
    s.clickCell("green", Model::kGained);
    QVERIFY(s.bench.hasSelection());
    QCOMPARE(static_cast<int>(s.bench.selection().size()), s.number("green", Model::kGained));
    QVERIFY(s.bench.selection().contains(cellOf(kGreen)));
    QVERIFY(!s.bench.selection().contains(cellOf(kOrange)));
    s.clickCell("green", Model::kLost);
    QVERIFY(s.bench.selection().empty());
    s.clickCell("all changes", Model::kClass);
    QCOMPARE(static_cast<int>(s.bench.selection().size()), s.number("all changes", Model::kGained));
    QTest::keyClick(s.table, Qt::Key_Escape);
    QVERIFY(!s.bench.hasSelection());
    QTest::keyClick(s.table, Qt::Key_Up);  // none, what green took of it
    QCOMPARE(static_cast<int>(s.bench.selection().size()), s.number("none", Model::kLost));
  }

  void theSelectionFollowsTheTableUntilAnotherTakesItsPlace() {
    Shown s;
    s.press("colorCompareNow");
    s.stroke("green", 30, 7);
    s.clickCell("all changes", Model::kClass);
    const std::size_t before = s.bench.selection().size();
    s.stroke("white", 8, 22);
    QVERIFY(s.bench.selection().size() > before);
    colortool::CellSet other;
    other.set(cellOf(kOrange));
    s.bench.select(other);
    s.stroke("white", 10, 24);
    QVERIFY(s.bench.selection() == other);
  }

  void tablesOfFilesAreMatchedByTheirClassesNames() {
    const TestFolder folder;
    colortool::NamedColorTable named;
    named.classes = colortool::ColorClasses({{"green", {0, 160, 40}}, {"violet", {160, 0, 200}}});
    named.file.cells[cellOf(kGreen)] = 1;
    named.file.cells[cellOf(kOrange)] = 2;
    QVERIFY(named.save(folder / "old.c64"));
    Shown s;
    s.openFile(folder / "old.c64");
    QCOMPARE(s.shownText("colorCompareName"), QStringLiteral("Compared with old.c64"));
    QCOMPARE(s.text("green", Model::kTo), QStringLiteral("none 1"));
    QCOMPARE(s.text("violet", Model::kTo), QStringLiteral("orange 1"));
    QVERIFY(s.text("orange", Model::kFrom).endsWith(QStringLiteral("violet 1")));
    // As the samples number their classes, for what compares pixels.
    QCOMPARE(s.bench.reference()->classOf(kGreen), s.bench.samples().classes.index("green"));
    QCOMPARE(s.bench.reference()->classOf(kOrange), colortool::ColorClasses::kNone);
    // The folder is remembered.
    QCOMPARE(s.view.saveState()[QStringLiteral("folder")].toString(),
             QString::fromStdString(folder.path().string()));
  }

  void theReferenceFollowsTheSamplesClasses() {
    Shown s;
    s.press("colorCompareNow");
    const std::uint8_t orange = s.bench.reference()->classOf(kOrange);
    colortool::Samples next = s.bench.samples();
    std::vector<std::uint8_t> numbers(static_cast<std::size_t>(next.classes.size()), std::uint8_t{0});
    numbers[orange] = 2;
    colortool::changeClasses(
        next, colortool::ColorClasses({{"white", {255, 255, 255}}, {"orange", {255, 105, 0}}}), numbers);
    s.bench.change(QStringLiteral("Classes"), std::move(next));
    QCOMPARE(int{s.bench.reference()->classOf(kOrange)}, 2);
    s.settle();
    QCOMPARE(s.number("orange", Model::kLost), 0);
    QCOMPARE(s.number("all changes", Model::kGained), 0);
    s.bench.undoStack().undo();
    QCOMPARE(s.bench.reference()->classOf(kOrange), orange);
  }

  void aBrokenFileIsSaidAndLosesNothing() {
    const TestFolder folder;
    std::ofstream(folder / "broken.c64") << "no table";
    Shown s;
    s.press("colorCompareNow");
    s.openFile(folder / "broken.c64");
    auto* problem = child<QLabel>(s.view, "colorCompareProblem");
    QVERIFY(problem->isVisible());
    QVERIFY2(problem->text().contains(QStringLiteral("broken.c64")), qPrintable(problem->text()));
    QCOMPARE(s.shownText("colorCompareName"),
             QStringLiteral("Compared with the table after step 1, Stroke: orange"));
    s.press("colorCompareNow");
    QVERIFY(!problem->isVisible());
  }

  void theDifferenceIsShownInTheImage() {
    Shown s;
    s.world.show();
    ColorImageView image(s.world.context);
    s.settle();
    s.press("colorCompareNow");
    s.press("colorCompareShow");
    QCOMPARE(child<QComboBox>(image, "colorRightLayer")->currentText(), QStringLiteral("Difference"));
  }

  void looksRight() {
    Shown s;
    keepPicture(s.view, "color-compare-empty");
    s.press("colorCompareNow");
    s.stroke("green", 30, 7);
    s.stroke("white", 8, 22);
    s.stroke("yellow", 12, 4);
    s.clickCell("yellow", Model::kGained);
    keepPicture(s.view, "color-compare-view");
  }
};

}  // namespace widgets::test

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  widgets::test::ColorCompareViewTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "ColorCompareViewTest.moc"
