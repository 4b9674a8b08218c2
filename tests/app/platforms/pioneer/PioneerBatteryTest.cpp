// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/pioneer/PioneerBattery.h"

#include <gtest/gtest.h>

using namespace app;
using std::chrono::hours;

namespace {

/// How long a full battery lasts, by the minute.
double hoursUntilEmpty(bool motorsOn, double speed) {
  PioneerBattery battery(11, 13);
  double minutes = 0;
  while (battery.charge() > 0 && minutes < 1e5) {
    battery.discharge(motorsOn, speed, std::chrono::minutes(1));
    ++minutes;
  }
  return minutes / 60;
}

}  // namespace

TEST(PioneerBattery, aFullOneLastsTenHoursOfStandingOrTwoOfDriving) {
  EXPECT_NEAR(hoursUntilEmpty(false, 0), 10.8, 0.1);
  EXPECT_NEAR(hoursUntilEmpty(true, 1), 2.06, 0.05);
  EXPECT_NEAR(hoursUntilEmpty(true, -1), 2.06, 0.05) << "backward costs the same";
  EXPECT_EQ(hoursUntilEmpty(true, 50), hoursUntilEmpty(true, 2)) << "no motor takes more";
}

TEST(PioneerBattery, theVoltageFallsWithTheChargeAndUnderLoad) {
  PioneerBattery battery(11, 13);
  EXPECT_EQ(battery.voltage(), 13) << "full, and nothing was switched on yet";
  battery.discharge(false, 0, std::chrono::milliseconds(1));
  const double standing = battery.voltage();
  battery.discharge(true, 1, std::chrono::milliseconds(1));
  EXPECT_LT(battery.voltage(), standing - 0.2);
  battery.discharge(false, 0, hours(5));
  EXPECT_GT(battery.voltage(), 11);
  EXPECT_LT(battery.voltage(), 12.2);
}

TEST(PioneerBattery, anEmptyOneStaysEmpty) {
  PioneerBattery battery(11, 13);
  battery.discharge(true, 2, hours(100));
  EXPECT_EQ(battery.charge(), 0);
  battery.discharge(true, 2, hours(100));
  EXPECT_EQ(battery.charge(), 0);
  EXPECT_LT(battery.voltage(), 11);
}
