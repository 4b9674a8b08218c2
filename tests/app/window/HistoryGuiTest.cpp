// SPDX-License-Identifier: GPL-3.0-or-later
// Looking back in the window while a robot plays.
#include <QLabel>
#include <QMenu>
#include <QToolButton>

#include "tests/app/ShortLog.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {

class HistoryGuiTest : public WindowTest {
  Q_OBJECT
 private:
  static void play(Desk& desk, double until) {
    desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > until, kWaitMs);
  }
  static double shown(Desk& desk) {
    return robotlink::seconds(desk.workbench.session().timeline().shown().time_since_epoch());
  }

 private Q_SLOTS:
  void aClickInTheStatusBarPausesWhatIsShownWhileTheRobotPlays() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    play(desk, 0.5);
    auto& button = desk.find<QToolButton>("statusHistory");
    QCOMPARE(button.text(), QStringLiteral("live"));
    QTest::mouseClick(&button, Qt::LeftButton);
    const double paused = shown(desk);
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > paused + 0.5, kWaitMs);
    desk.window.tick();
    QCOMPARE(shown(desk), paused);
    QVERIFY2(button.text().contains(QStringLiteral("s behind live")), qPrintable(button.text()));
    QVERIFY(desk.status()->running());
    QTest::mouseClick(&button, Qt::LeftButton);
    QCOMPARE(button.text(), QStringLiteral("live"));
    QVERIFY(shown(desk) > paused);
  }

  void keysPauseStepBackAndReturn() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    play(desk, 1);
    QTest::keyClick(&desk.window, Qt::Key_Space, Qt::ControlModifier);
    const double paused = shown(desk);
    QVERIFY(!desk.workbench.session().timeline().live());
    QTest::keyClick(&desk.window, Qt::Key_Comma, Qt::AltModifier);
    QTest::keyClick(&desk.window, Qt::Key_Comma, Qt::AltModifier);
    QVERIFY(shown(desk) < paused);
    QVERIFY(shown(desk) > paused - 0.3);
    const double back = shown(desk);
    QTest::keyClick(&desk.window, Qt::Key_Period, Qt::AltModifier);
    QVERIFY(shown(desk) > back);
    QTest::keyClick(&desk.window, Qt::Key_Space, Qt::ControlModifier);
    QVERIFY(desk.workbench.session().timeline().live());
  }

  void commandsSeekAndLimitsAreRemembered() {
    {
      Desk desk(home_);
      QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
      play(desk, 1);
      auto& commands = desk.workbench.commands();
      QVERIFY(commands.run("timeline.seek", {0.25}));
      QCOMPARE(shown(desk), 0.25);
      QVERIFY(commands.run("timeline.seek", {-0.5}));
      QVERIFY(shown(desk) > 0.4);
      QVERIFY(!commands.run("timeline.step", {0.5}));
      QVERIFY(commands.run("timeline.live", {}));
      QVERIFY(!commands.run("timeline.memory", {10.0}));
      QVERIFY(commands.run("timeline.memory", {2048.0}));
      QVERIFY(commands.run("timeline.disk", {0.0}));
    }
    Desk desk(home_, Desk::Opens::kNothing);
    QCOMPARE(desk.workbench.history().memory(), std::uint64_t{2048} << 20U);
    QCOMPARE(desk.workbench.history().disk(), std::uint64_t{0});
    QCOMPARE(desk.workbench.session().store().limits().bytes, std::size_t{2048} << 20U);
  }
};

const widgets::test::GuiTest<HistoryGuiTest> kHistoryGuiTest;

}  // namespace app::test

#include "HistoryGuiTest.moc"
