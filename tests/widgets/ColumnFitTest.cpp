// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ColumnFit.h"

#include <QApplication>
#include <QHeaderView>
#include <QJsonArray>
#include <QStandardItemModel>
#include <QTableView>
#include <QTest>
#include <QTreeView>
#include <numeric>

#include "tests/widgets/FieldBench.h"
#include "widgets/HeaderState.h"

namespace widgets::test {
namespace {

using enum ColumnKind;

int total(const std::vector<int>& widths) {
  return std::accumulate(widths.begin(), widths.end(), 0);
}

/// A table of three columns: a name, a number, a sentence.
struct Table {
  QStandardItemModel model{0, 3};
  QTableView view;
  ColumnFit* fit = nullptr;

  explicit Table(int width) {
    model.setHorizontalHeaderLabels(
        {QStringLiteral("Stream"), QStringLiteral("Number of messages"), QStringLiteral("Contents")});
    view.setModel(&model);
    view.verticalHeader()->hide();
    fit = new ColumnFit(view, {kName, kNumber, kText});
    view.resize(width, 300);
    view.show();
    if (!QTest::qWaitForWindowExposed(&view)) qFatal("the table is not shown");
  }
  void add(const QString& name, const QString& number) {
    model.appendRow(
        {new QStandardItem(name), new QStandardItem(number), new QStandardItem(QString(400, u'x'))});
    fit->fit();
  }
  int width(int column) const { return view.columnWidth(column); }
  /// Whether what stands in the column is seen whole.
  bool whole(int row, int column) const {
    const QString text = model.index(row, column).data().toString();
    return view.fontMetrics().horizontalAdvance(text) < width(column);
  }
  int widths() const { return width(0) + width(1) + width(2); }
};

}  // namespace

class ColumnFitTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void columnsFillTheRoom() {
    const std::vector<ColumnNeed> columns{{kName, 60, 120}, {kNumber, 50, 30}, {kText, 40, 0}};
    QCOMPARE(fittedWidths(columns, 800), (std::vector<int>{120, 50, 630}));
    for (const int room : {300, 301, 333, 420}) QCOMPARE(total(fittedWidths(columns, room)), room);
    // Without a sentence the last name takes the rest.
    QCOMPARE(fittedWidths({{kName, 60, 120}, {kNumber, 50, 30}}, 400), (std::vector<int>{350, 50}));
    QCOMPARE(fittedWidths({{kNumber, 60, 20}, {kName, 50, 30}, {kName, 50, 90}}, 400),
             (std::vector<int>{60, 50, 290}));
  }

  void titlesOfNumbersAreCutFirstThenSentencesAndNamesNever() {
    const std::vector<ColumnNeed> columns{
        {kName, 60, 120}, {kNumber, 90, 30}, {kNumber, 90, 50}, {kText, 40, 0}};
    QCOMPARE(fittedWidths(columns, 120 + 180 + 160), (std::vector<int>{120, 90, 90, 160}));
    const auto narrow = fittedWidths(columns, 400);
    QCOMPARE(narrow[0], 120);
    QVERIFY(narrow[1] < 90 && narrow[2] < 90);
    QCOMPARE(narrow[3], 160);
    QCOMPARE(fittedWidths(columns, 300), (std::vector<int>{120, 32, 50, 98}));
    // Narrower than that it is scrolled.
    QCOMPARE(fittedWidths(columns, 200), (std::vector<int>{120, 32, 50, 80}));
  }

  void anEmptyColumnIsAsWideAsItsTitleAtMost() {
    const auto widths = fittedWidths({{kName, 60, 120}, {kNumber, 40, 0}, {kNumber, 40, 0}}, 300);
    QCOMPARE(widths, (std::vector<int>{220, 40, 40}));
    QCOMPARE(fittedWidths({{kName, 60, 120}, {kNumber, 90, 0}}, 160)[1], 40);
  }

  void titledNumbersKeepTheirTitlesAtAnyWidth() {
    const ColumnNeed joint{kTitledNumber, 60, 30};
    QCOMPARE(fittedWidths({joint, joint, joint}, 90), (std::vector<int>{60, 60, 60}));
    QCOMPARE(fittedWidths({joint, {kNumber, 60, 30}}, 100), (std::vector<int>{60, 40}));
    QCOMPARE(fittedWidths({joint, joint}, 400), (std::vector<int>{60, 60}));
  }

  void aVeryLongNameLeavesAQuarterToTheOthers() {
    const ColumnNeed number{kNumber, 50, 40}, name{kName, 60, 2000};
    QCOMPARE(fittedWidths({name, number, number, number}, 400)[0], 300);
    QCOMPARE(fittedWidths({name, number}, 400), (std::vector<int>{350, 50}));  // what they do not need is its
    QCOMPARE(fittedWidths({{kName, 60, 2000, 360}, number}, 400)[0], 360);     // as a person set it
  }

  void columnsThatComeAndGoAreFittedToo() {
    QStandardItemModel model(2, 3);
    QTableView view;
    view.setModel(&model);
    const auto fill = [&](const QString& text) {
      for (int column = 0; column < model.columnCount(); ++column)
        model.setItem(0, column, new QStandardItem(text));
    };
    fill(QStringLiteral("12.3"));
    auto* fit = new ColumnFit(view, kNumber);
    view.resize(700, 200);
    view.show();
    QVERIFY(QTest::qWaitForWindowExposed(&view));
    const int before = view.columnWidth(2);
    QVERIFY(before < 100);
    model.setColumnCount(5);
    fill(QStringLiteral("123 456 789.123"));
    fit->fit();
    for (int column = 0; column < 5; ++column) {
      QVERIFY(view.columnWidth(column) > before);
      QCOMPARE(view.columnWidth(column), view.columnWidth(0));
    }
  }

  void aTableShowsItsNamesWholeAtAnyWidth() {
    for (const int width : {260, 420, 900}) {
      Table table(width);
      table.add(QStringLiteral("red1/percepts/ball"), QStringLiteral("123456"));
      QVERIFY(table.whole(0, 0));
      QVERIFY(table.whole(0, 1));
      QVERIFY(width < 400 || table.widths() == table.view.viewport()->width());
    }
  }

  void columnsFollowTheSizeAndWhatIsAdded() {
    Table table(420);
    table.add(QStringLiteral("ball"), QStringLiteral("1"));
    const int before = table.width(0);
    table.model.appendRow(new QStandardItem(QStringLiteral("red1/percepts/landmarks")));
    QTRY_VERIFY(table.width(0) > before);
    QVERIFY(table.whole(1, 0));
    table.view.resize(700, 300);
    QCOMPARE(table.widths(), table.view.viewport()->width());
    // Numbers that become shorter do not make the columns waver.
    const int wide = table.width(0);
    table.model.item(1, 0)->setText(QStringLiteral("x"));
    table.fit->fit();
    QCOMPARE(table.width(0), wide);
  }

  void whatAPersonResizedStaysAndComesBackWithTheView() {
    Table table(500);
    table.add(QStringLiteral("red1/percepts/ball"), QStringLiteral("123456"));
    QVERIFY(headerState(*table.view.horizontalHeader())[QLatin1String("columns")][0][1].toInt() == 0);
    table.view.setColumnWidth(0, 60);
    table.view.resize(600, 300);
    QCOMPARE(table.width(0), 60);
    QCOMPARE(table.widths(), table.view.viewport()->width());

    Table other(700);
    other.add(QStringLiteral("red1/percepts/ball"), QStringLiteral("123456"));
    restoreHeader(*other.view.horizontalHeader(), headerState(*table.view.horizontalHeader()));
    QTRY_COMPARE(other.width(0), 60);
    QCOMPARE(other.widths(), other.view.viewport()->width());
    // A double click on the edge fits the column again.
    Q_EMIT other.view.horizontalHeader()->sectionHandleDoubleClicked(0);
    QTRY_VERIFY(other.whole(0, 0));
  }

  void columnsThatWereNeverFittedAreKeptAndRestored() {
    QStandardItemModel model(2, 2);
    QTableView view;
    view.setModel(&model);
    new ColumnFit(view, kNumber);
    // Nobody has seen the table yet.
    const QJsonValue state = headerState(*view.horizontalHeader());
    QCOMPARE(state[QLatin1String("columns")].toArray().size(), 2);
    restoreHeader(*view.horizontalHeader(), state);
    model.setColumnCount(4);
    QCOMPARE(headerState(*view.horizontalHeader())[QLatin1String("columns")][3][1].toInt(), 0);
  }

  void aHiddenColumnTakesNoRoomAndIsFittedWhenItIsShown() {
    Table table(500);
    table.add(QStringLiteral("ball"), QStringLiteral("123456"));
    table.view.setColumnHidden(1, true);
    QTRY_COMPARE(table.widths(), table.view.viewport()->width());
    QCOMPARE(table.width(1), 0);
    table.view.setColumnHidden(1, false);
    QTRY_VERIFY(table.whole(0, 1) && table.widths() == table.view.viewport()->width());
    QCOMPARE(table.fit->pinned(1), 0);
  }

  void whatIsExpectedHasRoom() {
    QStandardItemModel model(1, 2);
    model.setItem(0, 0, new QStandardItem(QStringLiteral("image:draw-grid")));
    QTreeView tree;
    tree.setModel(&model);
    auto* fit = new ColumnFit(tree, {kName, kNumber});
    fit->expect(1, QStringLiteral("every n-th"));
    tree.resize(220, 200);
    tree.show();
    QVERIFY(QTest::qWaitForWindowExposed(&tree));
    QVERIFY(tree.columnWidth(1) > tree.fontMetrics().horizontalAdvance(QStringLiteral("every n-th")));
  }
};

const GuiTest<ColumnFitTest> kColumnFitTest;

}  // namespace widgets::test

#include "ColumnFitTest.moc"
