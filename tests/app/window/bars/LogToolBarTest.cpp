// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/LogToolBar.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QSignalSpy>

#include "app/robotcontrol/actions/CommandActions.h"
#include "robotlink/commands/CommandCatalog.h"
#include "tests/widgets/LogBench.h"

namespace app::test {
namespace {

using widgets::ReplayKey;
using widgets::test::child;

/// The toolbar in a window; commands are noted and have no effect.
struct PlayedLog : widgets::test::LogBench {
  PlayedLog() {
    commands = robotlink::CommandTable(robotlink::commandCatalog());
    for (const char* name : {"log.jump-frame", "log.speed", "log.step-process", "log.play", "log.pause"}) {
      commands.attach(name, [this, name](const auto& values) -> robotlink::Result<void> {
        ran << QLatin1String(name);
        for (const auto& value : values) arguments.push_back(value);
        return {};
      });
    }
    window.addToolBar(&bar);
    window.resize(1600, 200);  // all of it is seen
    window.show();
  }
  void open() {
    openLog(widgets::test::kFile);
    bar.refresh();
  }
  void enter(const char* field, const QString& text) {
    auto& edit = child<QLineEdit>(bar, field);
    edit.setText(text);
    QTest::keyClick(&edit, Qt::Key_Return);
  }
  bool isEnabled(const char* action) { return child<QAction>(bar, action).isEnabled(); }

  QStringList ran;
  std::vector<robotlink::CommandTable::Value> arguments;
  QMainWindow window;
  CommandActions actions{commands, nullptr};
  LogToolBar bar{actions, logs(), &window};
};

}  // namespace

class LogToolBarTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void withoutALogItIsHiddenAndDoesNothing() {
    PlayedLog log;
    QVERIFY(!log.bar.isVisible());
    log.logs().replay().setSteppedStream("nao/log");
    for (const char* action : {"log.playOrPause", "log.stop", "log.frameOn", "log.messageBack",
                               "log.messageOn", "log.loop", "log.bookmarkHere"})
      QVERIFY2(!log.isEnabled(action), action);
    QVERIFY(!log.bar.press(QKeyEvent(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier)));
  }

  void messagesAreSteppedOnceAStreamIsChosen() {
    PlayedLog log;
    log.logs().replay().setSteppedStream({});
    log.open();
    log.logs().replay().setSteppedStream({});
    QVERIFY(log.bar.isVisible());
    QVERIFY(!log.isEnabled("log.messageOn") && log.isEnabled("log.frameOn"));
    log.logs().replay().setSteppedStream("nao/log");
    QVERIFY(log.isEnabled("log.messageOn"));
    QVERIFY(child<QAction>(log.bar, "log.messageOn").toolTip().contains(QStringLiteral("nao/log")));
    log.status.clear_logs();
    log.publish();
    log.bar.refresh();
    QVERIFY(!log.bar.isVisible() && !log.isEnabled("log.messageOn"));
  }

  void aTypedTimeIsJumpedToAndAnotherTextRefused() {
    PlayedLog log;
    log.open();
    const auto begin = log.logs().replay().origin();
    log.enter("logTime", QStringLiteral(" 0:12,5 s"));
    QCOMPARE(log.asked().time(), (begin + robotlink::fromSeconds(12.5)).time_since_epoch().count());
    log.answer(true);
    log.showTime(20);
    log.enter("logTime", QStringLiteral("-2"));
    QCOMPARE(log.asked().time(), widgets::test::at(18).time_since_epoch().count());
    QSignalSpy failed(&log.logs(), &widgets::OpenLogs::failed);
    const auto asked = log.requests.size();
    for (const char* text : {"soon", "", "-", "1:2:3:4", "1:-2", "nan", "1e300"})
      log.enter("logTime", QLatin1String(text));
    QCOMPARE(failed.count(), 7);
    QVERIFY(failed[0][0].toString().startsWith(QStringLiteral("\"soon\" is not a time")));
    QCOMPARE(log.requests.size(), asked);
  }

  void aTypedFrameIsANumber() {
    PlayedLog log;
    log.open();
    log.enter("logFrame", QStringLiteral(" 17 "));
    QCOMPARE(log.ran, QStringList{QStringLiteral("log.jump-frame")});
    QCOMPARE(std::get<double>(log.arguments.front()), 17.0);
    QSignalSpy failed(&log.logs(), &widgets::OpenLogs::failed);
    for (const char* text : {"-1", "1.5", "x", ""}) log.enter("logFrame", QLatin1String(text));
    QCOMPARE(failed.count(), 4);
    QCOMPARE(log.ran.size(), 1);
  }

  void whatIsTypedIsNotReplacedByTheShownTime() {
    PlayedLog log;
    log.open();
    log.window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&log.window));
    auto& time = child<QLineEdit>(log.bar, "logTime");
    time.setFocus();
    time.setText(QStringLiteral("1"));
    log.showTime(30);
    log.bar.refresh();
    QCOMPARE(time.text(), QStringLiteral("1"));
    time.clearFocus();
    log.bar.refresh();
    QCOMPARE(time.text(), log.logs().replay().shownText(widgets::test::at(30)));
  }

  void aSpeedThatIsNotListedIsShown() {
    PlayedLog log;
    log.open();
    auto& speed = child<QComboBox>(log.bar, "logSpeed");
    const int before = speed.count();
    QCOMPARE(speed.currentData().toDouble(), 1.0);
    log.status.set_speed(3);
    log.publish();
    log.bar.refresh();
    log.bar.refresh();
    QCOMPARE(speed.currentData().toDouble(), 3.0);
    QCOMPARE(speed.count(), before + 1);
    QVERIFY2(log.ran.isEmpty(), "what is shown is not asked for");
  }

  void theProcessThatIsSteppedHasItsFrames() {
    PlayedLog log;
    log.open();
    auto& process = child<QComboBox>(log.bar, "logProcess");
    QCOMPARE(process.count(), 2);
    QCOMPARE(process.currentText(), QStringLiteral("nao/cognition"));
    QCOMPARE(child<QLabel>(log.bar, "logFrames").text(), QStringLiteral(" (0 / 301) "));
    log.status.set_step_process("nao/motion");
    log.publish();
    log.bar.refresh();
    QCOMPARE(process.currentText(), QStringLiteral("nao/motion"));
    QCOMPARE(child<QLabel>(log.bar, "logFrames").text(), QStringLiteral(" (0 / 0) "));
  }

  void playAndPauseIsOneAction() {
    PlayedLog log;
    log.open();
    QAction* play = log.bar.action(ReplayKey::kPlayOrPause);
    play->trigger();
    log.status.set_playing(true);
    log.publish();
    log.bar.refresh();
    QCOMPARE(play->text(), QStringLiteral("Pause"));
    play->trigger();
    QCOMPARE(log.ran, (QStringList{QStringLiteral("log.play"), QStringLiteral("log.pause")}));
  }
};

const widgets::test::GuiTest<LogToolBarTest> kLogToolBarTest;

}  // namespace app::test

#include "LogToolBarTest.moc"
