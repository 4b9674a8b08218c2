// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/commands/PaletteEntries.h"

#include <QAbstractItemModelTester>
#include <QMenu>
#include <QMenuBar>
#include <QtTest>

#include "robotlink/commands/CommandTable.h"
#include "tests/widgets/GuiTest.h"

namespace app::test {
namespace {

using robotlink::CommandTable;

PaletteEntry commandEntry(const char* line, const char* tip = "") {
  return {QLatin1String(line), QLatin1String(tip), {}, QLatin1String(line)};
}

QStringList titlesOf(const std::vector<PaletteEntry>& entries) {
  QStringList titles;
  for (const PaletteEntry& each : entries) titles << each.title;
  return titles;
}

/// The words of a text.
QStringList words(const char* text) {
  return QString::fromLatin1(text).split(QLatin1Char(' '));
}

QAction* addEntry(QMenu& menu, const char* text, const char* name) {
  QAction* action = menu.addAction(QString::fromUtf8(text));
  action->setObjectName(QLatin1String(name));
  return action;
}

CommandTable::Command command(const char* name, std::vector<CommandTable::Argument> arguments = {}) {
  return {name, "Does something", std::move(arguments),
          [](const CommandTable::Values&) { return robotlink::Result<void>(); }};
}

}  // namespace

class PaletteEntriesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void entriesOfMenusHaveTheirWayThere() {
    QMenuBar bar;
    QMenu& file = *bar.addMenu(QStringLiteral("&File"));
    QAction& save = *addEntry(file, "&Save", "save");
    save.setShortcut(QKeySequence(QStringLiteral("Ctrl+S")));
    save.setToolTip(QStringLiteral("Writes it to the disk"));
    QMenu& recent = *file.addMenu(QStringLiteral("&Recent"));
    addEntry(recent, "game.mcap", "recent1");
    const auto entries = paletteEntries(bar, CommandTable());
    QCOMPARE(titlesOf(entries),
             (QStringList{QStringLiteral("File › Save"), QStringLiteral("File › Recent › game.mcap")}));
    QCOMPARE(entries[0].help, QStringLiteral("Writes it to the disk"));
    QCOMPARE(entries[0].key, QStringLiteral("Ctrl+S"));
    QCOMPARE(entries[0].id(), QStringLiteral("menu:save"));
    QVERIFY2(entries[1].help.isEmpty(), "a tip that says the same again is none");
    QVERIFY(entries[0].action == &save);
  }

  void whatCannotBeChosenIsNotOffered() {
    QMenuBar bar;
    QMenu& file = *bar.addMenu(QStringLiteral("File"));
    addEntry(file, "Disabled", "disabled")->setEnabled(false);
    addEntry(file, "Hidden", "hidden")->setVisible(false);
    addEntry(file, "Nameless", "");
    file.addSeparator();
    addEntry(file, "Quit", "quit");
    QCOMPARE(titlesOf(paletteEntries(bar, CommandTable())), QStringList{QStringLiteral("File › Quit")});
  }

  void commandsSayTheirArguments() {
    CommandTable table;
    table.add(command("robot.walk",
                      {{"x", CommandTable::Type::kNumber}, {"y", CommandTable::Type::kNumber, "", 0.0}}));
    table.add(command("simulation.start"));
    CommandTable::Command nobodys = command("view.show");
    nobodys.run = {};
    table.add(nobodys);
    const auto entries = paletteEntries(QMenuBar(), table);
    QCOMPARE(titlesOf(entries),
             (QStringList{QStringLiteral("robot.walk x [y]"), QStringLiteral("simulation.start")}));
    QVERIFY(entries[0].isUnfinished);
    QCOMPARE(entries[0].line, QStringLiteral("robot.walk"));
    QCOMPARE(entries[0].id(), QStringLiteral("robot.walk"));
    QVERIFY(!entries[1].isUnfinished);
  }

  void aCommandThatAMenuRunsIsOfferedThere() {
    QMenuBar bar;
    QMenu& menu = *bar.addMenu(QStringLiteral("Simulation"));
    addEntry(menu, "Start", "simulation.start");
    addEntry(menu, "Fast", "simulation.speed");
    CommandTable table;
    table.add(command("simulation.start"));
    table.add(command("simulation.speed", {{"speed", CommandTable::Type::kNumber}}));
    QCOMPARE(titlesOf(paletteEntries(bar, table)),
             (QStringList{QStringLiteral("Simulation › Start"), QStringLiteral("Simulation › Fast"),
                          QStringLiteral("simulation.speed speed")}));
  }

  void anEmptyTextFitsAllInTheOrderOfUseAndThenOfTheAlphabet() {
    const std::vector<PaletteEntry> entries{commandEntry("c"), commandEntry("B"), commandEntry("a"),
                                            commandEntry("d")};
    QCOMPARE(titlesOf(paletteMatches(entries, {}, {})), words("a B c d"));
    const QStringList recent{QStringLiteral("c"), QStringLiteral("d"), QStringLiteral("gone")};
    QCOMPARE(titlesOf(paletteMatches(entries, QStringLiteral("  "), recent)), words("d c a B"));
  }

  void useCountsOnlyAmongEquals() {
    const std::vector<PaletteEntry> entries{commandEntry("log.open"), commandEntry("dialog")};
    QCOMPARE(titlesOf(paletteMatches(entries, QStringLiteral("log"), {QStringLiteral("dialog")})),
             words("log.open dialog"));
  }

  void eachWordIsSearchedInTitleAndHelpInCapitalsOrNot() {
    const PaletteEntry entry = commandEntry("robot.stop", "Engages STOP at once");
    QVERIFY(paletteScore(entry, QStringLiteral("ROBOT engages")) > 0);
    QVERIFY(paletteScore(entry, QStringLiteral("once stop")) > 0);
    QVERIFY(paletteScore(entry, QStringLiteral("robot start")) < 0);
    QCOMPARE(paletteScore(entry, {}), 0);
    QVERIFY2(paletteScore(entry, QStringLiteral("stop")) > paletteScore(entry, QStringLiteral("once")),
             "titles count more than helps");
  }

  void lettersInTheirOrderFitFromTheBeginningOfAWord() {
    const PaletteEntry entry = commandEntry("View › Field");
    QVERIFY(paletteScore(entry, QStringLiteral("vf")) > 0);
    QVERIFY(paletteScore(entry, QStringLiteral("fld")) > 0);
    QVERIFY2(paletteScore(entry, QStringLiteral("ew f")) > 0, "a part of the title");
    QVERIFY2(paletteScore(entry, QStringLiteral("iwf")) < 0, "in the middle of a word");
    QVERIFY2(paletteScore(entry, QStringLiteral("fv")) < 0, "in another order");
  }

  void theModelShowsWhatItWasGiven() {
    PaletteModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    PaletteEntry entry = commandEntry("robot.stop", "Engages STOP");
    entry.key = QStringLiteral("Esc");
    model.show({entry, commandEntry("robot.walk")});
    QCOMPARE(model.rowCount(), 2);
    const QModelIndex first = model.index(0, 0);
    QCOMPARE(first.data().toString(), QStringLiteral("robot.stop"));
    QCOMPARE(first.data(PaletteModel::kHelpRole).toString(), QStringLiteral("Engages STOP"));
    QCOMPARE(first.data(PaletteModel::kKeyRole).toString(), QStringLiteral("Esc"));
    QCOMPARE(model.entry(model.index(1, 0))->line, QStringLiteral("robot.walk"));
    QVERIFY(model.entry({}) == nullptr);
    model.show({});
    QCOMPARE(model.rowCount(), 0);
  }
};

const widgets::test::GuiTest<PaletteEntriesTest> kPaletteEntriesTest;

}  // namespace app::test

#include "PaletteEntriesTest.moc"
