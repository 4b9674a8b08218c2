// SPDX-License-Identifier: GPL-3.0-or-later
// The palette of commands, as a person uses it: by keys, in the window.
#include <qtadvanceddocking/DockWidget.h>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>

#include "app/robotcontrol/commands/CommandPalette.h"
#include "app/robotcontrol/commands/PaletteEntries.h"
#include "robotlink/commands/CommandTable.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

struct PaletteDesk : EmptyDesk {
  using EmptyDesk::EmptyDesk;
  CommandPalette& palette() { return find<CommandPalette>("commandPalette"); }
  QLineEdit& input() { return find<QLineEdit>("paletteInput"); }
  QListView& list() { return find<QListView>("paletteList"); }
  QString hint() { return find<QLabel>("paletteHint").text(); }
  void open() {
    QTest::keyClick(QApplication::focusWidget() != nullptr ? QApplication::focusWidget() : &window, Qt::Key_P,
                    Qt::ControlModifier);
    if (!input().hasFocus()) qFatal("the palette did not open");
  }
  void type(const char* text) { QTest::keyClicks(&input(), QLatin1String(text)); }
  void press(Qt::Key key) { QTest::keyClick(&input(), key); }
  QString row(int number) { return list().model()->index(number, 0).data().toString(); }
  QString chosen() { return list().currentIndex().data().toString(); }
};

PaletteEntry entry(const char* title, const char* help = "") {
  return {QLatin1String(title), QLatin1String(help), {}, QLatin1String(title)};
}

}  // namespace

class PaletteGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void aMenuEntryIsFoundByItsWordsAndRun() {
    PaletteDesk desk(home_);
    desk.open();
    desk.type("view bookm");
    QCOMPARE(desk.chosen(), QStringLiteral("View › Bookmarks"));
    widgets::test::keepPicture(desk.window, "palette");
    desk.press(Qt::Key_Return);
    QVERIFY(!desk.palette().isVisible());
    QVERIFY(desk.window.docks().isInFront(QStringLiteral("bookmarks")));
  }

  void anOpenViewIsFoundByItsTitle() {
    PaletteDesk desk(home_);
    desk.window.docks().openAnother(QStringLiteral("image"));
    QVERIFY(!desk.window.docks().isInFront(QStringLiteral("processes")));
    QTest::keyClick(&desk.window, Qt::Key_J, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(desk.input().hasFocus());
    desk.type("proces");
    QCOMPARE(desk.list().model()->rowCount(), 1);
    desk.press(Qt::Key_Return);
    QVERIFY(desk.window.docks().isInFront(QStringLiteral("processes")));
    const ads::CDockWidget* dock = desk.window.docks().named(QStringLiteral("processes"));
    QVERIFY(dock->isAncestorOf(QApplication::focusWidget()));
    QVERIFY(desk.workbench.commands().runLine("view.show image#2").has_value());
    QVERIFY(desk.window.docks().named(QStringLiteral("image#2"))->isCurrentTab());
    QCOMPARE(desk.workbench.commands().runLine("view.show image#7").error().id, std::string("view.unknown"));
  }

  void aCommandWithoutArgumentsIsRunAtOnce() {
    PaletteDesk desk(home_);
    int runs = 0;
    desk.workbench.commands().add({"test.count", "Counts", {}, [&](const auto&) {
                                     ++runs;
                                     return robotlink::Result<void>();
                                   }});
    desk.open();
    desk.type("test.cou");
    desk.press(Qt::Key_Return);
    QCOMPARE(runs, 1);
  }

  void argumentsFollowInTheSameLineWithWhatTheyCanBe() {
    PaletteDesk desk(home_);
    desk.open();
    desk.type("view.perspe");
    desk.press(Qt::Key_Return);
    QCOMPARE(desk.input().text(), QStringLiteral("view.perspective "));
    QVERIFY(desk.palette().isVisible());
    QVERIFY2(desk.hint().contains(QStringLiteral("<b>name</b>")), qPrintable(desk.hint()));
    QVERIFY(desk.list().model()->rowCount() >= 6);
    QCOMPARE(desk.chosen(), QString());
    desk.type("Mo");
    QCOMPARE(desk.row(0), QStringLiteral("Motion"));
    widgets::test::keepPicture(desk.window, "palette-argument");
    desk.press(Qt::Key_Down);
    desk.press(Qt::Key_Return);
    QCOMPARE(desk.input().text(), QStringLiteral("view.perspective Motion "));
    desk.press(Qt::Key_Return);
    QVERIFY(!desk.palette().isVisible());
    QTRY_VERIFY(desk.find<QAction>("perspective.Motion").isChecked());
  }

  void tabCompletesCommandAndArgument() {
    PaletteDesk desk(home_);
    desk.open();
    desk.type("view.perspe");
    desk.press(Qt::Key_Tab);
    QCOMPARE(desk.input().text(), QStringLiteral("view.perspective "));
    desk.type("Proc");
    desk.press(Qt::Key_Tab);
    QCOMPARE(desk.input().text(), QStringLiteral("view.perspective Processes "));
  }

  void whatIsWrongIsSaidInsideAndTheLineStays() {
    PaletteDesk desk(home_);
    desk.open();
    desk.type("simulation.speed fast");
    desk.press(Qt::Key_Return);
    QVERIFY(desk.palette().isVisible());
    QCOMPARE(desk.input().text(), QStringLiteral("simulation.speed fast"));
    QVERIFY2(desk.hint().contains(QStringLiteral("speed must be a number")), qPrintable(desk.hint()));
    QVERIFY(desk.input().hasFocus());
    widgets::test::keepPicture(desk.window, "palette-error");
    desk.input().clear();
    desk.type("zzzz qqqq");
    desk.press(Qt::Key_Return);
    QVERIFY(desk.palette().isVisible());
    QVERIFY(!desk.hint().isEmpty());
  }

  void escapeClosesItAndTheFocusReturns() {
    PaletteDesk desk(home_);
    desk.window.docks().open(QStringLiteral("messages"));
    auto& search = desk.find<QLineEdit>("messagesSearch");
    search.setFocus();
    desk.open();
    desk.type("anything");
    desk.press(Qt::Key_Escape);
    QVERIFY(!desk.palette().isVisible());
    QVERIFY(search.hasFocus());
    desk.open();
    search.setFocus();  // as a click elsewhere does
    QVERIFY(!desk.palette().isVisible());
    QVERIFY(search.hasFocus());
  }

  void whatWasUsedLastComesFirstAlsoAfterARestart() {
    {
      PaletteDesk desk(home_);
      desk.open();
      desk.type("view.close messages");
      desk.press(Qt::Key_Return);
      desk.open();
      desk.type("view.show field");
      desk.press(Qt::Key_Return);
      desk.open();
      QCOMPARE(desk.row(0), QStringLiteral("view.show field"));
      QCOMPARE(desk.row(1), QStringLiteral("view.close messages"));
      desk.press(Qt::Key_Escape);
      desk.window.keep();
    }
    PaletteDesk again(home_);
    again.open();
    QCOMPARE(again.row(0), QStringLiteral("view.show field"));
    again.press(Qt::Key_Return);
    QVERIFY(again.window.docks().isInFront(QStringLiteral("field")));
  }

  void everyMenuEntryAndCommandIsOfferedOnce() {
    PaletteDesk desk(home_);
    desk.open();
    const auto& commands = desk.workbench.commands().all();
    QVERIFY(static_cast<std::size_t>(desk.list().model()->rowCount()) > commands.size());
    QSet<QString> titles;
    for (int i = 0; i < desk.list().model()->rowCount(); ++i) {
      QVERIFY2(!titles.contains(desk.row(i)), qPrintable(desk.row(i)));
      titles << desk.row(i);
    }
    QVERIFY(titles.contains(QStringLiteral("File › Quit")));
    QVERIFY(titles.contains(QStringLiteral("robot.walk x [y] [rotation]")));
  }

  void beginningsOfWordsCountMoreThanPartsAndThoseMoreThanLetters() {
    const std::vector<PaletteEntry> entries{entry("log.step-message"), entry("messages"),
                                            entry("recording.start", "Keeps messages"), entry("m-e-s-s")};
    const auto found = paletteMatches(entries, QStringLiteral("mess"), {});
    QCOMPARE(found.size(), entries.size());
    QCOMPARE(found[0].title, QStringLiteral("messages"));
    QCOMPARE(found[1].title, QStringLiteral("log.step-message"));
    QCOMPARE(found[2].title, QStringLiteral("recording.start"));
    QCOMPARE(found[3].title, QStringLiteral("m-e-s-s"));
    QVERIFY(paletteMatches(entries, QStringLiteral("mess qq"), {}).empty());
    QVERIFY(paletteScore(entries[0], QStringLiteral("step log")) > 0);
  }
};

const widgets::test::GuiTest<PaletteGuiTest> kPaletteGuiTest;

}  // namespace app::test

#include "PaletteGuiTest.moc"
