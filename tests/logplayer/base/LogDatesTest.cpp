// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/LogDates.h"

#include <gtest/gtest.h>

namespace logplayer {
namespace {

using robotlink::Instant;

constexpr Instant kTime{std::chrono::milliseconds(1'700'000'000'250)};

Instant timeAt(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

}  // namespace

TEST(LogDates, timesOfThisCenturyAreDates) {
  EXPECT_FALSE(isDate(timeAt(12.5)));
  EXPECT_FALSE(isDate(timeAt(946'684'799)));
  EXPECT_TRUE(isDate(timeAt(946'684'800)));
  EXPECT_FALSE(isDate(timeAt(4'102'444'800)));
  EXPECT_EQ(dateText(kTime), "2023-11-14 22:13:20.250 UTC");
  EXPECT_EQ(dateOrSeconds(kTime), dateText(kTime));
  EXPECT_EQ(dateOrSeconds(timeAt(12.5)), "12.500 s");
}

TEST(LogDates, whatIsWrittenIsRead) {
  EXPECT_EQ(instantOfDate(dateText(kTime)), kTime);
  EXPECT_EQ(instantOfDate("2023-11-14T22:13:20.25Z"), kTime);
  EXPECT_EQ(instantOfDate("2023-11-14 22:13"), timeAt(1'699'999'980));
  EXPECT_EQ(instantOfDate("2000-01-01"), timeAt(946'684'800));
}

TEST(LogDates, whatIsNoDateIsNone) {
  for (const char* text : {"", "12.5", "2023", "2023-13-01", "2023-02-30", "2023-11-14T", "2023-11-14T25:00",
                           "2023-11-14 22:13x", "2023-11-14 22:13:20.", "-2023-11-14"}) {
    EXPECT_EQ(instantOfDate(text), std::nullopt) << text;
  }
}

}  // namespace logplayer
