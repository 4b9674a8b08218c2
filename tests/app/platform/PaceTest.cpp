// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/platform/Pace.h"

#include <gtest/gtest.h>

using namespace app;
using namespace std::chrono_literals;

namespace {

const Pace::RealTime kPaceStart = Pace::RealTime(std::chrono::hours(1));

robotlink::Instant instantAt(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

double realSeconds(Pace::RealTime::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

Pace paceAt(double speed, double time) {
  Pace pace;
  pace.setSpeed(speed);
  pace.restart(kPaceStart, instantAt(time));
  return pace;
}

}  // namespace

TEST(Pace, anInstantIsDueBySpeed) {
  for (const double speed : {0.05, 0.5, 1.0, 2.0, 50.0}) {
    const Pace pace = paceAt(speed, 486.749);
    EXPECT_EQ(pace.due(instantAt(486.749)), kPaceStart);
    EXPECT_NEAR(realSeconds(pace.due(instantAt(487.749)) - kPaceStart), 1 / speed, 1e-6);
    EXPECT_NEAR(robotlink::seconds(pace.timeAt(kPaceStart + 1s) - instantAt(486.749)), speed, 1e-6);
  }
}

TEST(Pace, asFastAsPossibleNothingIsEverWaitedFor) {
  const Pace pace = paceAt(0, 10);
  EXPECT_EQ(pace.due(instantAt(1000)), kPaceStart);
}

TEST(Pace, aSmallLagIsCaughtUpWith) {
  Pace pace = paceAt(1, 0);
  pace.forgetLag(kPaceStart + 150ms, instantAt(0.008));
  EXPECT_NEAR(realSeconds(pace.due(instantAt(0.016)) - kPaceStart), 0.016, 1e-6);
}

TEST(Pace, afterALongStandstillItGoesOnWithoutAJump) {
  Pace pace = paceAt(1, 0);
  const auto woken = kPaceStart + 1h;
  pace.forgetLag(woken, instantAt(0.008));
  EXPECT_EQ(pace.due(instantAt(0.008)), woken);
  EXPECT_NEAR(realSeconds(pace.due(instantAt(0.108)) - woken), 0.1, 1e-6);
}

TEST(Pace, aGapOfYearsOverflowsNothing) {
  const Pace pace = paceAt(0.05, 0);
  EXPECT_GT(pace.due(instantAt(9e9)), kPaceStart + std::chrono::hours(24 * 365));
  EXPECT_LT(pace.due(instantAt(-9e9)), kPaceStart);
}
