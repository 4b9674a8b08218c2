// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the window answers in time.
#include <QEventLoop>
#include <QLabel>
#include <QPushButton>
#include <QStatusBar>

#include "app/robotcontrol/bars/StallWatch.h"
#include "tests/app/window/Desk.h"
#include "tests/app/window/WindowTest.h"

namespace app::test {

using namespace std::chrono_literals;

/// The processor time for which the thread computes.
void compute(std::chrono::milliseconds time) {
  const auto cpu = [] {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec);
  };
  for (const auto end = cpu() + time; cpu() < end;) {
  }
}

class StallsGuiTest : public WindowTest {
  Q_OBJECT
 private Q_SLOTS:
  void whatComputesForLongIsNoticedAndShown() {
    QStatusBar bar;
    StallWatch watch(&bar, &bar);
    bool done = false;
    QTimer::singleShot(0, &bar, [&done] {
      compute(80ms);
      done = true;
    });
    QTRY_VERIFY(done);
    QTRY_VERIFY(watch.stalls().count >= 1);
    QVERIFY(watch.stalls().longest >= 80ms && watch.stalls().longestCpu >= 80ms);
    // What the timer called.
    QVERIFY2(watch.stalls().cause.contains(QStringLiteral("MetaCall")), qPrintable(watch.stalls().cause));
    const auto* label = bar.findChild<QLabel*>(QStringLiteral("stalls"));
    QTRY_VERIFY(label->text().contains(QStringLiteral("ms")));
    QTRY_VERIFY(label->toolTip().contains(watch.stalls().cause));
    watch.reset();
    QCOMPARE(watch.stalls(), StallWatch::Stalls());
  }

  /// A program that waits for events delivers them elsewhere in its loop than one that only looks for them,
  /// as tests do.
  void itIsNoticedInALoopThatWaits() {
    StallWatch watch(qApp, nullptr);
    QEventLoop loop;
    QTimer poll;
    connect(&poll, &QTimer::timeout, &loop, [&] {
      if (watch.stalls().count > 0) loop.quit();
    });
    poll.start(20);
    QTimer::singleShot(50, &loop, [] { compute(80ms); });
    QTimer::singleShot(kWaitMs, &loop, &QEventLoop::quit);
    loop.exec();
    QVERIFY(watch.stalls().count >= 1);
    QVERIFY(watch.stalls().longest >= 80ms && watch.stalls().longestCpu >= 80ms);
  }

  /// The worst moment counts. It compares processor time, since others that use the machine prolong it less.
  void aRobotThatPlaysNeverKeepsTheWindowFromAnswering() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > 0.5, kWaitMs);
    StallWatch watch(&desk.window, nullptr);
    const double end = desk.status()->time() + kPlayed;
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > end, kWaitMs);
    const auto worst = watch.stalls().longestCpu;
    QVERIFY2(worst <= kSlower * StallWatch::kLimit, qPrintable(QStringLiteral("%1 us").arg(worst.count())));
    QVERIFY(worst.count() > 0);
  }

 private:
  static constexpr double kPlayed = 3;  // s, simulated
  /// How many times longer everything takes in programs with sanitizers.
#ifdef ROBOTCONTROL_SANITIZED
  static constexpr int kSlower = 10;
#else
  static constexpr int kSlower = 1;
#endif
};

const widgets::test::GuiTest<StallsGuiTest> kStallsGuiTest;

}  // namespace app::test

#include "StallsGuiTest.moc"
