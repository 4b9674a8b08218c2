// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Controls.h"

#include <QAction>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QSplitter>
#include <QStandardItemModel>
#include <QStringListModel>
#include <QTableView>
#include <QVBoxLayout>

#include "tests/widgets/Bench.h"

namespace widgets::test {
namespace {

QStringListModel* numbers(QObject* parent, int count) {
  QStringList texts;
  for (int i = 0; i < count; ++i) texts << QString::number(i);
  return new QStringListModel(texts, parent);
}

/// Shows a widget and waits until it gets keys.
void showActive(QWidget& widget) {
  widget.resize(300, 200);
  widget.show();
  QVERIFY(QTest::qWaitForWindowActive(&widget));
}

}  // namespace

class ControlsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aControlHasItsNameForScriptsAndItsTextsForPeople() {
    QWidget widget;
    describe(widget, {"saveIt", QStringLiteral("Save"), QStringLiteral("Writes the file"),
                      QKeySequence(QStringLiteral("Ctrl+S"))});
    QCOMPARE(widget.objectName(), QStringLiteral("saveIt"));
    QCOMPARE(widget.accessibleName(), QStringLiteral("Save"));
    QCOMPARE(widget.accessibleDescription(), QStringLiteral("Writes the file"));
    QCOMPARE(widget.toolTip(), QStringLiteral("Writes the file (Ctrl+S)"));
    describe(widget, {"saveIt", QStringLiteral("Save"), QStringLiteral("Writes the file")});
    QCOMPARE(widget.toolTip(), QStringLiteral("Writes the file"));
  }

  void aShortcutWorksWhereTheFocusIsWithinItsOwner() {
    QWidget window;
    auto& owner = *new QWidget(&window);
    auto* layout = new QVBoxLayout(&window);
    auto* other = new QLineEdit(&window);
    auto* inside = new QLineEdit(&owner);
    layout->addWidget(&owner);
    layout->addWidget(other);
    QAction* action =
        makeToggle(&owner, "search", {"find", QStringLiteral("Find"), {}, QKeySequence(Qt::Key_F5)}, true);
    showActive(window);
    QCOMPARE(action->objectName(), QStringLiteral("findAction"));
    other->setFocus();
    QTest::keyClick(other, Qt::Key_F5);
    QVERIFY(action->isChecked());
    inside->setFocus();
    QTest::keyClick(inside, Qt::Key_F5);
    QVERIFY(!action->isChecked());
  }

  void whatIsTypedFiltersRowsByItsCharactersInAnyCase() {
    QWidget window;
    QStringListModel source({QStringLiteral("Ball.x"), QStringLiteral("ballast"), QStringLiteral("pose")});
    QSortFilterProxyModel filtered;
    QLineEdit& field = *makeFilterField(&window, {"filter", QStringLiteral("Search"), {}}, filtered, source);
    showActive(window);
    field.setFocus();
    QTest::keyClicks(&field, QStringLiteral("BALL"));
    QCOMPARE(filtered.rowCount(), 2);
    QTest::keyClicks(&field, QStringLiteral("."));
    QCOMPARE(filtered.rowCount(), 1);
    QTest::keyClick(&field, Qt::Key_Escape);
    QCOMPARE(field.text(), QString());
    QCOMPARE(filtered.rowCount(), 3);
  }

  void aTableFollowsItsEndUntilTheUserScrollsAway() {
    QWidget window;
    QTableView& table =
        *makeEventTable(&window, {"events", QStringLiteral("Events"), {}}, numbers(&window, 100));
    auto* layout = new QVBoxLayout(&window);
    layout->addWidget(&table);
    QAction follow;
    follow.setCheckable(true);
    follow.setChecked(true);
    followEnd(table, follow);
    showActive(window);
    table.scrollToBottom();
    QVERIFY(follow.isChecked());
    turnWheel(*table.viewport(), {50, 50}, 3);
    QVERIFY(!follow.isChecked());
    table.scrollToBottom();
    QVERIFY2(!follow.isChecked(), "only the user's scrolling counts");
    turnWheel(*table.viewport(), {50, 50}, 1);
    turnWheel(*table.viewport(), {50, 50}, -100);
    QVERIFY(follow.isChecked());
  }

  void selectedRowsAreCopiedInTheirOrder() {
    QWidget window;
    QTableView& table = *makeTable(&window, {"rows", QStringLiteral("Rows"), {}}, numbers(&window, 5));
    const auto texts = [](const QModelIndex& row) {
      return QStringList{row.data().toString(), QStringLiteral("x")};
    };
    QGuiApplication::clipboard()->setText(QStringLiteral("before"));
    copyRows(table, texts);
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("before"));
    for (const int row : {3, 0, 2})
      table.selectionModel()->select(table.model()->index(row, 0),
                                     QItemSelectionModel::Select | QItemSelectionModel::Rows);
    copyRows(table, texts);
    QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("0\tx\n2\tx\n3\tx"));
  }

  void theFirstTextsOfARowAreThoseOfItsFirstColumns() {
    QStandardItemModel model(1, 3);
    for (int column = 0; column < 3; ++column)
      model.setData(model.index(0, column), QString::number(10 * column));
    QCOMPARE(firstTexts(model.index(0, 2), 2), QStringList({QStringLiteral("0"), QStringLiteral("10")}));
    QCOMPARE(firstTexts(model.index(0, 0), 4).last(), QString());
  }

  void anOutcomeIsRedOnlyIfItIsBad() {
    QWidget window;
    QLabel& note = *makeNote(&window, "note", QStringLiteral("Outcome"));
    const auto color = [&] { return note.palette().color(QPalette::WindowText); };
    const QColor usual = window.palette().color(QPalette::WindowText);
    QCOMPARE(color(), usual);
    showOutcome(note, QStringLiteral("no space left"), true);
    QCOMPARE(note.text(), QStringLiteral("no space left"));
    QCOMPARE(color(), colorOf(Meaning::kBad, window.palette()));
    showOutcome(note, QStringLiteral("saved"), false);
    QCOMPARE(color(), usual);
    setMeaning(note, Meaning::kWarning);
    QCOMPARE(color(), colorOf(Meaning::kWarning, window.palette()));
  }
};

const GuiTest<ControlsTest> kControlsTest;

}  // namespace widgets::test

#include "ControlsTest.moc"
