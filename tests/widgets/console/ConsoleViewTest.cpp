// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/console/ConsoleView.h"

#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

#include "tests/widgets/Bench.h"
#include "widgets/console/CommandTyping.h"

namespace widgets::test {

using Type = robotlink::CommandTable::Type;
using Values = robotlink::CommandTable::Values;

namespace {

/// A console with three commands, which notes what was run.
struct ConsoleBench : Bench {
  ConsoleBench() {
    commands.add({"robot.walk",
                  "Lets it walk",
                  {{"x", Type::kNumber, "m/s forward"}, {"y", Type::kNumber, "m/s to the left", 0.0}},
                  [this](const Values& values) -> robotlink::Result<void> {
                    walked = std::get<double>(values[0]);
                    return {};
                  }});
    commands.add({"robot.head",
                  "Moves the head",
                  {{"mode", Type::kText, "", {}, {"look-ahead", "look-around", "search-ball"}}},
                  [](const Values&) { return robotlink::failure("no", "it has no head"); }});
    commands.add({"view.show", "Shows a view", {{"view", Type::kText}}, [](const Values&) {
                    return robotlink::Result<void>();
                  }});
    view = open<ConsoleView>();
    view->setFocus();
  }
  void type(const QString& line) { QTest::keyClicks(&input(), line); }
  void press(Qt::Key key) { QTest::keyClick(&input(), key); }
  QLineEdit& input() { return child<QLineEdit>(*view, "consoleInput"); }
  QString output() { return child<QPlainTextEdit>(*view, "consoleOutput").toPlainText(); }

  double walked = 0;
  std::unique_ptr<ConsoleView> view;
};

}  // namespace

class ConsoleViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void aLineIsRunAndShownWithWhatCameOfIt() {
    ConsoleBench console;
    console.type(QStringLiteral("robot.walk 0.25"));
    console.press(Qt::Key_Return);
    QCOMPARE(console.walked, 0.25);
    QCOMPARE(console.output(), QStringLiteral("> robot.walk 0.25"));
    QCOMPARE(console.input().text(), QString());
    console.type(QStringLiteral("robot.head look-ahead"));
    console.press(Qt::Key_Return);
    QVERIFY(console.output().endsWith(QStringLiteral("> robot.head look-ahead\nit has no head")));
    keepPicture(*console.view, "console");
  }

  void theWordsOfScriptsCanBeTyped() {
    ConsoleBench console;
    const auto enter = [&](const QString& line) {
      console.type(line);
      console.press(Qt::Key_Return);
    };
    enter(QStringLiteral("print 2 * 3"));
    QVERIFY(console.output().endsWith(QStringLiteral("> print 2 * 3\n6")));
    enter(QStringLiteral("set x 0.5"));
    enter(QStringLiteral("robot.walk $x"));
    QCOMPARE(console.walked, 0.5);
    enter(QStringLiteral("assert 1 > 2"));
    QVERIFY(console.output().endsWith(QStringLiteral("expected 1 > 2")));
    enter(QStringLiteral("wait until 1 > 2 for 1000"));
    enter(QStringLiteral("wait until 1 > 2 for 0.05"));
    QVERIFY(console.output().contains(QStringLiteral("No longer waiting: wait until 1 > 2 for 1000")));
    QTRY_VERIFY(console.output().endsWith(QStringLiteral("waited 0.05 s for 1 > 2")));
  }

  void tabCompletesNamesAndArgumentsAndListsWhatIsPossible() {
    ConsoleBench console;
    console.type(QStringLiteral("vi"));
    console.press(Qt::Key_Tab);
    QCOMPARE(console.input().text(), QStringLiteral("view.show "));
    QCOMPARE(console.view->window()->focusWidget(), &console.input());
    console.input().clear();
    console.type(QStringLiteral("rob"));
    console.press(Qt::Key_Tab);
    QCOMPARE(console.input().text(), QStringLiteral("robot."));
    console.press(Qt::Key_Tab);
    QVERIFY(console.output().contains(QStringLiteral("robot.head  robot.walk")));
    console.type(QStringLiteral("h"));
    console.press(Qt::Key_Tab);
    console.type(QStringLiteral("l"));
    console.press(Qt::Key_Tab);
    QCOMPARE(console.input().text(), QStringLiteral("robot.head look-a"));
  }

  void theHintSaysWhichArgumentComes() {
    ConsoleBench console;
    auto& hint = child<QLabel>(*console.view, "consoleHint");
    console.type(QStringLiteral("robot.walk"));
    QCOMPARE(hint.text(), QString());
    console.type(QStringLiteral(" "));
    QCOMPARE(hint.text(), QStringLiteral("robot.walk <b>x</b> [y] – m/s forward"));
    console.type(QStringLiteral("1 "));
    QCOMPARE(hint.text(), QStringLiteral("robot.walk x <b>[y]</b> – m/s to the left"));
  }

  void upBringsBackWhatWasTypedBeforeAndDownWhatWasBegun() {
    ConsoleBench console;
    for (const char* line : {"robot.walk 1", "robot.walk 2"}) {
      console.type(QLatin1String(line));
      console.press(Qt::Key_Return);
    }
    console.type(QStringLiteral("ro"));
    console.press(Qt::Key_Up);
    QCOMPARE(console.input().text(), QStringLiteral("robot.walk 2"));
    console.press(Qt::Key_Up);
    console.press(Qt::Key_Up);
    QCOMPARE(console.input().text(), QStringLiteral("robot.walk 1"));
    console.press(Qt::Key_Down);
    console.press(Qt::Key_Down);
    QCOMPARE(console.input().text(), QStringLiteral("ro"));
  }

  void helpListsTheCommandsThatBeginSo() {
    ConsoleBench console;
    console.type(QStringLiteral("help robot."));
    console.press(Qt::Key_Return);
    QVERIFY(console.output().contains(QStringLiteral("Moves the head")));
    QVERIFY(console.output().contains(QStringLiteral("robot.walk <x: number> [y: number = 0]")));
    QVERIFY(!console.output().contains(QStringLiteral("view.show")));
  }

  void outputIsCopiedClearedAndBounded() {
    ConsoleBench console;
    CommandLog& log = commandLog(console.context);
    for (std::size_t i = 0; i <= CommandLog::kMaxEntries; ++i)
      log.add(CommandLog::Kind::kOutput, QStringLiteral("line %1").arg(i));
    QCOMPARE(log.entries().size(), CommandLog::kMaxEntries);
    QCOMPARE(log.entries().front().text, QStringLiteral("line 1"));
    click(*console.view, "consoleCopy");
    QVERIFY(QApplication::clipboard()->text().contains(QStringLiteral("line 2000")));
    click(*console.view, "consoleClear");
    QCOMPARE(console.output(), QString());
    QVERIFY(log.entries().empty());
  }

  void twoConsolesShowTheSameAndTheHistoryIsBoundedWithoutRepetitions() {
    ConsoleBench console;
    auto other = console.open<ConsoleView>();
    console.type(QStringLiteral("robot.walk 1"));
    console.press(Qt::Key_Return);
    QCOMPARE(child<QPlainTextEdit>(*other, "consoleOutput").toPlainText(), console.output());
    CommandLog& log = commandLog(console.context);
    QStringList lines;
    for (int i = 0; i < CommandLog::kMaxHistory + 5; ++i) lines << QStringLiteral("line %1").arg(i);
    log.setHistory(lines + lines);
    QCOMPARE(log.history(), lines.mid(5));
  }

  void markupInWhatIsTypedIsShownAsItIs() {
    ConsoleBench console;
    console.type(QStringLiteral("<b>bold</b> & co"));
    console.press(Qt::Key_Return);
    QVERIFY(console.output().startsWith(QStringLiteral("> <b>bold</b> & co")));
  }

  void whatIsTypedInOtherAlphabetsKeepsItsPlace() {
    robotlink::CommandTable commands;
    commands.add({"ärger.machen", "", {{"wie", Type::kText, "", {}, {"größer"}}}, [](const Values&) {
                    return robotlink::Result<void>();
                  }});
    const auto after = completed(commands, {QStringLiteral("ärger.machen grö ende"), 16});
    QCOMPARE(after.line, QStringLiteral("ärger.machen größer ende"));
    QCOMPARE(after.cursor, 20);
  }
};

const GuiTest<ConsoleViewTest> kConsoleViewTest;

}  // namespace widgets::test

#include "ConsoleViewTest.moc"
