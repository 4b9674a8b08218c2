// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/DataView.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTableView>
#include <QToolButton>

#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"
#include "tests/widgets/LogBench.h"
#include "tests/widgets/data/DataFixture.h"
#include "widgets/data/FieldTablePanel.h"

namespace widgets::test {
namespace {

QTreeView& treeOf(DataView& view) {
  return child<QTreeView>(view, "dataTree");
}

QString textOf(const QModelIndex& index, int column = DataModel::kValue) {
  return index.siblingAtColumn(column).data().toString();
}

/// Unfolds rows one after the other, as the Right key does, and selects the last one.
QModelIndex open(QTreeView& tree, std::initializer_list<const char*> names) {
  QModelIndex index;
  for (const char* name : names) {
    index = find(tree, QString::fromUtf8(name));
    if (!index.isValid()) qFatal("there is no %s", name);
    tree.setCurrentIndex(index);
    if (name != *(names.end() - 1)) QTest::keyClick(&tree, Qt::Key_Right);
  }
  return index;
}

constexpr char kJoints[] = "joint angles (joints/states)";

}  // namespace

class DataViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void anEmptyViewSaysHowToFillIt() {
    Bench bench;
    auto view = bench.open<DataView>();
    QVERIFY(!view->findChild<QLabel*>(QString(), Qt::FindDirectChildrenOnly) ||
            treeOf(*view).viewport()->findChild<QLabel*>()->isVisible());
    QVERIFY(treeOf(*view).viewport()->findChild<QLabel*>()->text().contains(QStringLiteral("simulation")));
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    QVERIFY(!treeOf(*view).viewport()->findChild<QLabel*>()->isVisible());
  }

  void aValueIsUnfoldedAndFollowsTheMessages() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    const QPersistentModelIndex position =
        open(treeOf(*view), {kJoints, "joints", "[1] head.pan", "position"});
    QCOMPARE(textOf(position), QStringLiteral("0.5"));
    QCOMPARE(child<QLabel>(*view, "dataPath").text(),
             QStringLiteral("red1/joints/states.joints[head.pan].position"));
    bench.push("red1/joints/states", joints(0.75), 2);
    bench.tick(*view);
    QCOMPARE(textOf(position), QStringLiteral("0.75"));
    QCOMPARE(QModelIndex(position), treeOf(*view).currentIndex());
    bench.session.timeline().show(robotlink::Instant(std::chrono::milliseconds(1500)));
    bench.tick(*view);
    QCOMPARE(textOf(position), QStringLiteral("0.5"));
    keepPicture(*view, "data");
  }

  void whatIsUnfoldedIsSavedAsTable() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    open(treeOf(*view), {kJoints, "joints", "[1] head.pan", "position"});
    const TestFolder folder;
    QVERIFY(view->saveTo(QString::fromStdString((folder / "d.csv").string())));
    const std::string csv = robotlink::readFile(folder / "d.csv").value_or("none");
    QVERIFY2(csv.find("\n        position,0.5") != std::string::npos, csv.c_str());
    QVERIFY2(csv.find("\n      [0] ") != std::string::npos, csv.c_str());
  }

  void whatWasUnfoldedIsUnfoldedAgainAfterARestart() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    open(treeOf(*view), {kJoints, "joints", "[1] head.pan", "position"});
    child<QLineEdit>(*view, "dataSearch").setText(QStringLiteral("states"));
    const QJsonObject state = view->saveState();
    auto next = bench.open<DataView>();
    next->restoreState(state);
    QCOMPARE(child<QLineEdit>(*next, "dataSearch").text(), QStringLiteral("states"));
    child<QLineEdit>(*next, "dataSearch").clear();
    QApplication::processEvents();
    const QModelIndex position = find(treeOf(*next), QStringLiteral("position"));
    QVERIFY(position.isValid());
    QVERIFY(treeOf(*next).isExpanded(position.parent()));
    QCOMPARE(textOf(position.parent(), 0), QStringLiteral("[1] head.pan"));
  }

  void scrollingAndSelectionSurviveNewMessages() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/range/laser", laserScan(900), 1);
    bench.tick(*view);
    QTreeView& tree = treeOf(*view);
    open(tree, {"laser scans (range/laser)", "ranges", "[0]"});
    tree.scrollTo(find(tree, QStringLiteral("[500]")), QAbstractItemView::PositionAtTop);
    QApplication::processEvents();
    const int before = tree.verticalScrollBar()->value();
    QVERIFY(before > 300);
    for (int i = 0; i < 5; ++i) {
      bench.push("red1/range/laser", laserScan(900 + i), 2 + i);
      bench.push("red1/other/" + std::to_string(9 - i), laserScan(1), 2 + i);
      bench.tick(*view);
      QApplication::processEvents();
    }
    QCOMPARE(tree.indexAt(QPoint(5, 5)).siblingAtColumn(0).data().toString(), QStringLiteral("[500]"));
    QCOMPARE(textOf(tree.currentIndex(), 0), QStringLiteral("[0]"));
  }

  void aSearchShowsWhatItFindsAndClearingItWhatWasThere() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.push("red1/range/laser", laserScan(3), 1);
    bench.tick(*view);
    auto& search = child<QLineEdit>(*view, "dataSearch");
    QTest::keyClicks(&search, QStringLiteral("pan position"));
    QTreeView& tree = treeOf(*view);
    const QModelIndex position = find(tree, QStringLiteral("position"));
    QVERIFY(position.isValid());
    QApplication::processEvents();
    QVERIFY(tree.visualRect(position).height() > 0);
    QVERIFY(!find(tree, QStringLiteral("laser scans (range/laser)")).isValid());
    tree.setCurrentIndex(position);
    search.clear();
    QVERIFY(find(tree, QStringLiteral("laser scans (range/laser)")).isValid());
    QTest::keyClicks(&search, QStringLiteral("nowhere"));
    bench.tick(*view);
    QVERIFY(treeOf(*view).viewport()->findChild<QLabel*>()->text().contains(QStringLiteral("Clear")));
  }

  void pathsValuesAndJsonAreCopied() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(1.0 / 3), 1);
    bench.tick(*view);
    QTreeView& tree = treeOf(*view);
    open(tree, {kJoints, "joints", "[1] head.pan", "position"});
    QTest::keyClick(&tree, Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(QApplication::clipboard()->text(),
             QStringLiteral("red1/joints/states.joints[head.pan].position"));
    QTest::keyClick(&tree, Qt::Key_C, Qt::ControlModifier);
    QCOMPARE(QApplication::clipboard()->text().toDouble(), 1.0 / 3);
    tree.setCurrentIndex(find(tree, QStringLiteral("[1] head.pan")));
    child<QAction>(*view, "dataCopyJsonAction").trigger();
    QVERIFY(QApplication::clipboard()->text().contains(QStringLiteral("\"name\": \"head.pan\"")));
  }

  void anotherRobotsValuesStandBesideAndWhatDiffersIsMarked() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.push("blue1/joints/states", joints(0.25), 1);
    bench.tick(*view);
    QTreeView& tree = treeOf(*view);
    child<QLineEdit>(*view, "dataSearch").setText(QStringLiteral("red1 pan"));
    QVERIFY(tree.isColumnHidden(DataModel::kOther));
    auto& comparison = child<QComboBox>(*view, "dataComparison");
    QTest::keyClicks(&comparison, QStringLiteral("blue1"));
    QVERIFY(!tree.isColumnHidden(DataModel::kOther));
    tree.expand(find(tree, QStringLiteral("[1] head.pan")));
    const QModelIndex position = find(tree, QStringLiteral("position"));
    QCOMPARE(textOf(position, DataModel::kOther), QStringLiteral("0.25"));
    QVERIFY(position.data(Qt::BackgroundRole).isValid());
    QVERIFY(!find(tree, QStringLiteral("velocity")).data(Qt::BackgroundRole).isValid());
    keepPicture(*view, "data-compared");
    const QJsonObject state = view->saveState();
    auto next = bench.open<DataView>();
    next->restoreState(state);
    QCOMPARE(child<QComboBox>(*next, "dataComparison").currentText(), QStringLiteral("blue1"));
  }

  void whatIsComparedWithIsChosenByItsName() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.push("blue1/joints/states", joints(0.25), 1);
    bench.tick(*view);
    auto& comparison = child<QComboBox>(*view, "dataComparison");
    QVERIFY(view->compareWith("blue1"));
    QCOMPARE(comparison.currentText(), QStringLiteral("blue1"));
    QVERIFY(view->compareWith("now"));
    QCOMPARE(comparison.currentText(), QStringLiteral("Remembered values"));
    QVERIFY(view->compareWith("logged"));
    QCOMPARE(comparison.currentText(), QStringLiteral("Logged values"));
    const auto wrong = view->compareWith("blue2");
    QVERIFY(!wrong);
    QVERIFY(wrong.error().text.find("'blue1'") != std::string::npos);
    QVERIFY(view->compareWith("none"));
    QVERIFY(treeOf(*view).isColumnHidden(DataModel::kOther));
  }

  void aRememberedInstantIsComparedWith() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    click(*view, "dataRemember");
    bench.push("red1/joints/states", joints(0.75), 2);
    bench.tick(*view);
    const QModelIndex position = open(treeOf(*view), {kJoints, "joints", "[1] head.pan", "position"});
    QCOMPARE(textOf(position, DataModel::kOther), QStringLiteral("0.5"));
    QCOMPARE(child<QComboBox>(*view, "dataComparison").currentText(), QStringLiteral("Remembered values"));
  }

  void aClickOnAStreamThatIsOffSwitchesItOn() {
    Bench bench;
    auto view = bench.open<DataView>();
    bench.push("red1/tables/keys", keyTable(false), 1);
    bench.tick(*view);
    QTreeView& tree = treeOf(*view);
    const QModelIndex ball = find(tree, QStringLiteral("the ball model (models/ball)"));
    clickCell(tree, ball);
    QVERIFY(bench.requests.empty());
    clickCell(tree, ball.siblingAtColumn(DataModel::kValue));
    QCOMPARE(bench.requests.size(), std::size_t{1});
    QCOMPARE(bench.requests.back().robot(), std::string("red1"));
    QCOMPARE(bench.requests.back().set_key().name(), std::string("package/models/ball"));
    bench.answer(false, "it is not running");
    bench.tick(*view);
    QVERIFY(child<QLabel>(*view, "dataState").text().contains(QStringLiteral("it is not running")));
  }

  void selectedValuesAreListedOverTimeAndSaved() {
    Bench bench;
    auto view = bench.open<DataView>({700, 600});
    for (int i = 0; i < 4; ++i) bench.push("red1/joints/states", joints(0.25 * i), 1 + i);
    bench.tick(*view);
    auto& panel = child<FieldTablePanel>(*view, "dataTablePanel");
    QVERIFY(!panel.isVisible());
    open(treeOf(*view), {kJoints, "joints", "[1] head.pan", "position"});
    click(*view, "dataOverTime");
    QVERIFY(panel.isVisible());
    auto& table = child<QTableView>(panel, "dataTable");
    QTRY_VERIFY((bench.tick(*view), table.model()->rowCount() == 4));
    QCOMPARE(table.model()->index(3, 1).data().toString(), QStringLiteral("0.75"));
    QCOMPARE(table.currentIndex().row(), 3);
    keepPicture(*view, "data-table");
    const QString file = QString::fromStdString((BenchHome::path() / "values.csv").string());
    panel.setFileQuestion([&file](const QString&, const QString&) { return file; });
    click(panel, "dataTableCsv");
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().contains("4.000000000,0.75"));
    click(panel, "dataTableClose");
    QVERIFY(!panel.isVisible());
  }

  void theTableCanBeThatOfTheWholeLog() {
    LogBench bench;
    bench.openLog((game::dataOf("made") / "logs/bhuman2009.log").string());
    auto view = bench.openView<DataView>({700, 600});
    bench.push("nao/joints/states", joints(0.5), 10);
    bench.tick(*view);
    open(treeOf(*view), {kJoints, "joints"});
    click(*view, "dataOverTime");
    auto& table = child<QTableView>(*view, "dataTable");
    QTRY_VERIFY((bench.tick(*view), table.model()->rowCount() == 1));
    QTest::keyClicks(&child<QComboBox>(*view, "dataTableSource"), QStringLiteral("Whole"));
    QTRY_VERIFY((bench.tick(*view), table.model()->rowCount() == game::Log::kMotionFrames));
  }

  void enterPlotsANumber() {
    Bench bench;
    std::vector<std::string> plotted;
    bench.commands.add({"plots.add",
                        "",
                        {{"value", robotlink::CommandTable::Type::kText, ""}},
                        [&](const auto& values) -> robotlink::Result<void> {
                          plotted.push_back(std::get<std::string>(values[0]));
                          return {};
                        }});
    auto view = bench.open<DataView>();
    bench.push("red1/joints/states", joints(0.5), 1);
    bench.tick(*view);
    open(treeOf(*view), {kJoints, "joints", "[1] head.pan", "position"});
    QTest::keyClick(&treeOf(*view), Qt::Key_Return);
    click(*view, "dataPlot");
    const std::string source = "red1/joints/states: joints[head.pan].position";
    QCOMPARE(plotted, std::vector<std::string>({source, source}));
  }
};

const GuiTest<DataViewTest> kDataViewTest;

}  // namespace widgets::test

#include "DataViewTest.moc"
