// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the window answers in time.
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
    QTRY_VERIFY(bar.findChild<QLabel*>(QStringLiteral("stalls"))->text().contains(QStringLiteral("ms")));
    watch.reset();
    QCOMPARE(watch.stalls(), StallWatch::Stalls());
  }

  /// It compares processor time, since machines are shared; a moment in which others slow everything down is
  /// no defect, so that one window of several counts.
  void aRobotThatPlaysNeverKeepsTheWindowFromAnswering() {
    Desk desk(home_);
    QTRY_VERIFY_WITH_TIMEOUT(desk.loaded(), kWaitMs);
    desk.click("simulation.start");
    QTRY_VERIFY_WITH_TIMEOUT(desk.status()->time() > 0.5, kWaitMs);
    StallWatch watch(&desk.window, nullptr);
    auto best = std::chrono::microseconds::max();
    for (int window = 0; window < 6 && best > StallWatch::kLimit; ++window) {
      watch.reset();
      QTest::qWait(500);
      best = std::min(best, watch.stalls().longestCpu);
    }
    QVERIFY2(best <= StallWatch::kLimit, qPrintable(QStringLiteral("%1 us").arg(best.count())));
    QVERIFY(best.count() > 0);
  }
};

const widgets::test::GuiTest<StallsGuiTest> kStallsGuiTest;

}  // namespace app::test

#include "StallsGuiTest.moc"
