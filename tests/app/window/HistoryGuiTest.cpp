// SPDX-License-Identifier: GPL-3.0-or-later
// Looking back in the window while a robot plays.
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <memory>
#include <utility>

#include "tests/app/ShortLog.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {
namespace {

/// Has nothing, and says whether it is too slow.
class SlowArchive final : public robotlink::HistoryArchive {
 public:
  void add(std::vector<robotlink::StreamMessage>, robotlink::Stretch) override {}
  void forgetAfter(robotlink::Instant) override {}
  void clear() override {}
  void request(robotlink::Instant) override {}
  std::optional<Part> take() override { return std::nullopt; }
  void setLimit(std::uint64_t) override {}
  std::uint64_t limit() const override { return 0; }
  std::optional<robotlink::Stretch> stretch() const override { return std::nullopt; }
  std::vector<robotlink::Stretch> holes() const override { return {}; }
  bool hasRoom() const override { return !slow; }
  bool isLosing() const override { return slow; }
  std::uint64_t bytes() const override { return 0; }
  std::map<std::string, std::uint64_t> shares() const override { return {}; }
  std::optional<robotlink::Error> takeProblem() override { return std::exchange(problem, std::nullopt); }

  bool slow = true;
  std::optional<robotlink::Error> problem = robotlink::Error{"history.slow", "too slow", {}, {}};
};

}  // namespace

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

  void thatTheDiskIsTooSlowIsShownUntilItIsOver() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    auto owned = std::make_unique<SlowArchive>();
    SlowArchive& archive = *owned;
    desk.workbench.session().history().setArchive(std::move(owned));
    desk.window.tick();
    auto& text = desk.find<QLabel>("errorText");
    QCOMPARE(text.text(), QStringLiteral("too slow"));
    QVERIFY(text.isVisibleTo(&desk.window));
    archive.slow = false;
    desk.window.tick();
    QVERIFY(!text.isVisibleTo(&desk.window));
  }
};

const widgets::test::GuiTest<HistoryGuiTest> kHistoryGuiTest;

}  // namespace app::test

#include "HistoryGuiTest.moc"
