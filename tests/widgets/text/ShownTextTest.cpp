// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ShownText.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSlider>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTableView>
#include <QTextEdit>
#include <QTreeView>
#include <QtTest>

#include "tests/widgets/GuiTest.h"

namespace widgets::test {
namespace {

/// A view with a table of two columns.
struct ViewWithTable {
  QWidget view;
  QStandardItemModel model{0, 2};
  QTableView& table = *new QTableView(&view);

  ViewWithTable() {
    view.resize(400, 300);
    table.resize(300, 200);
    model.setHorizontalHeaderLabels({QStringLiteral("Name"), QStringLiteral("Value")});
    table.setModel(&model);
  }
  void add(const char* name, const char* value) {
    model.appendRow(
        {new QStandardItem(QString::fromUtf8(name)), new QStandardItem(QString::fromUtf8(value))});
  }
  QString csv() const { return shownTable(view).value_or(QStringLiteral("none")); }
};

}  // namespace

class ShownTextTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aTableIsCsvWithItsTitles() {
    ViewWithTable shown;
    QCOMPARE(shown.csv(), QStringLiteral("Name,Value\n"));
    shown.add("a", "1");
    shown.add("", "–");
    QCOMPARE(shown.csv(), QStringLiteral("Name,Value\na,1\n,–\n"));
  }

  void cellsThatWouldBeReadOtherwiseAreQuoted() {
    ViewWithTable shown;
    shown.add("a,b", "say \"no\"");
    shown.add("two\nlines", "one\rreturn");
    shown.add("a\tb", " blank ");
    QCOMPARE(shown.csv(),
             QStringLiteral("Name,Value\n\"a,b\",\"say \"\"no\"\"\"\n\"two\nlines\",\"one\rreturn\"\n"
                            "a\tb, blank \n"));
  }

  void columnsAndRowsAreThoseThatAreSeen() {
    ViewWithTable shown;
    for (const char* name : {"a", "b", "c"}) shown.add(name, "1");
    shown.table.setRowHidden(1, true);
    shown.table.horizontalHeader()->moveSection(1, 0);
    QCOMPARE(shown.csv(), QStringLiteral("Value,Name\n1,a\n1,c\n"));
    shown.table.setColumnHidden(1, true);
    QCOMPARE(shown.csv(), QStringLiteral("Name\na\nc\n"));
  }

  void checkBoxesWithoutATextAreNumbers() {
    ViewWithTable shown;
    shown.add("", "named");
    shown.add("", "");
    for (const int row : {0, 1}) {
      shown.model.item(row, 0)->setCheckState(row == 0 ? Qt::Checked : Qt::Unchecked);
      shown.model.item(row, 1)->setCheckState(Qt::Checked);
    }
    QCOMPARE(shown.csv(), QStringLiteral("Name,Value\n1,named\n0,1\n"));
  }

  void aTreeIsIndentedAndItsFoldedBranchesAreLeftOut() {
    QWidget view;
    view.resize(300, 300);
    auto& tree = *new QTreeView(&view);
    QStandardItemModel model;
    model.setHorizontalHeaderLabels({QStringLiteral("Part")});
    auto* robot = new QStandardItem(QStringLiteral("robot"));
    auto* head = new QStandardItem(QStringLiteral("head"));
    head->appendRow(new QStandardItem(QStringLiteral("eye")));
    robot->appendRow(head);
    robot->appendRow(new QStandardItem(QStringLiteral("leg")));
    model.appendRow(robot);
    tree.setModel(&model);
    QCOMPARE(*shownTable(view), QStringLiteral("Part\nrobot\n"));
    tree.expand(robot->index());
    QCOMPARE(*shownTable(view), QStringLiteral("Part\nrobot\n  head\n  leg\n"));
    tree.expandAll();
    tree.setRowHidden(1, robot->index(), true);
    QCOMPARE(*shownTable(view), QStringLiteral("Part\nrobot\n  head\n    eye\n"));
  }

  void ofSeveralTablesTheLargestThatIsSeenIsMeant() {
    ViewWithTable shown;
    shown.add("large", "1");
    QStandardItemModel other(1, 1);
    other.setHeaderData(0, Qt::Horizontal, QStringLiteral("Other"));
    auto& small = *new QTableView(&shown.view);
    small.setModel(&other);
    small.resize(100, 100);
    QCOMPARE(shown.csv().section(QLatin1Char('\n'), 0, 0), QStringLiteral("Name,Value"));
    shown.table.hide();
    QCOMPARE(shown.csv().section(QLatin1Char('\n'), 0, 0), QStringLiteral("Other"));
    small.setModel(nullptr);
    QVERIFY(!shownTable(shown.view));
  }

  void aViewWithoutTablesHasNone() {
    QWidget view;
    new QLabel(QStringLiteral("text"), &view);
    QVERIFY(!shownTable(view) && !shownNumbers(view) && !shownText(view));
  }

  void betweenTabsThereAreNoTabsAndNoLineBreaks() {
    ViewWithTable shown;
    shown.add("a\tb", "1,5");
    shown.add("two\nlines", "say \"no\"");
    shown.add("one\rreturn", "");
    QCOMPARE(*shownNumbers(shown.view),
             QStringLiteral("Name\tValue\na b\t1,5\ntwo lines\tsay \"no\"\none return\t\n"));
  }

  void valuesWithANameAreARowEach() {
    QWidget view;
    const auto named = [](QWidget& widget, const char* name) {
      widget.setAccessibleName(QString::fromUtf8(name));
    };
    auto& speed = *new QSpinBox(&view);
    speed.setSuffix(QStringLiteral(" mm/s"));
    speed.setMaximum(500);
    speed.setValue(250);
    auto& angle = *new QSlider(&view);
    angle.setRange(-90, 90);
    angle.setValue(-30);
    auto& kind = *new QComboBox(&view);
    kind.addItems({QStringLiteral("walk"), QStringLiteral("trot\tfast")});
    kind.setCurrentIndex(1);
    auto& state = *new QLabel(QStringLiteral("ready"), &view);
    auto& empty = *new QLabel(&view);
    auto& hidden = *new QLabel(QStringLiteral("secret"), &view);
    hidden.hide();
    QVERIFY2(!shownValues(view), "nothing has a name yet");
    named(speed, "Speed");
    named(angle, "Angle");
    named(kind, "Kind");
    named(state, "State");
    named(empty, "Empty");
    named(hidden, "Hidden");
    QCOMPARE(*shownValues(view),
             QStringLiteral("name\tvalue\nSpeed\t250 mm/s\nAngle\t-30\nKind\ttrot fast\nState\tready\n"));
  }

  void aTextComesBeforeATable() {
    ViewWithTable shown;
    shown.add("a", "1");
    QCOMPARE(*shownText(shown.view), QStringLiteral("Name\tValue\na\t1\n"));
    auto& rich = *new QTextEdit(&shown.view);
    rich.setHtml(QStringLiteral("<b>bold</b>"));
    QCOMPARE(*shownText(shown.view), QStringLiteral("bold\n"));
    auto& plain = *new QPlainTextEdit(QStringLiteral("robot.select red1"), &shown.view);
    QCOMPARE(*shownText(shown.view), QStringLiteral("robot.select red1\n"));
    plain.hide();
    rich.hide();
    QCOMPARE(*shownText(shown.view), QStringLiteral("Name\tValue\na\t1\n"));
  }

  void aTableIsMadeLineByLine() {
    TabTable table({QStringLiteral("x"), QStringLiteral("y")});
    table.add({QStringLiteral("1\t2"), QStringLiteral("a\r\nb")});
    table.add({});
    QCOMPARE(table.text(), QStringLiteral("x\ty\n1 2\ta  b\n\n"));
  }

  void csvAndTabsBecomeEachOther() {
    const QString csv = QStringLiteral("name,value\n\"a,b\",\"say \"\"no\"\"\"\n,1\n");
    const QString tabs = QStringLiteral("name\tvalue\na,b\tsay \"no\"\n\t1\n");
    QCOMPARE(tabsOfCsv(csv), tabs);
    QCOMPARE(csvOfTabs(tabs), csv);
    QCOMPARE(tabsOfCsv(QStringLiteral("\"a\nb\tc\",\"\"\n")), QStringLiteral("a b c\t\n"));
    QCOMPARE(tabsOfCsv({}), QString());
    QCOMPARE(csvOfTabs(QStringLiteral("\n\na\n")), QStringLiteral("a\n"));
    QCOMPARE(tabsOfCsv(QStringLiteral("\"never closed,1\n")), QStringLiteral("never closed,1 "));
  }
};

const GuiTest<ShownTextTest> kShownTextTest;

}  // namespace widgets::test

#include "ShownTextTest.moc"
