// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/TimeScale.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using robotlink::Duration;
using robotlink::fromSeconds;
using robotlink::Instant;

TEST(TimeScale, zoomingKeepsTheTimeUnderTheCursor) {
  TimeScale scale{100, Instant(fromSeconds(5)), 1e6};
  const Instant before = scale.time(300);
  scale.zoomAt(300, 4);
  EXPECT_DOUBLE_EQ(scale.nsPerPixel, 0.25e6);
  EXPECT_NEAR(scale.x(before), 300, 1e-6);
  for (int i = 0; i < 100; ++i) scale.zoomAt(300, 10);
  EXPECT_DOUBLE_EQ(scale.nsPerPixel, 1e3);
  for (int i = 0; i < 100; ++i) scale.zoomAt(300, 0.1);
  EXPECT_DOUBLE_EQ(scale.nsPerPixel, 1e15);
}

TEST(TimeScale, marksAreRoundAndCountFromTheOrigin) {
  const TimeScale scale{0, Instant(fromSeconds(7.3)), 1e7};  // 0.01 s a pixel
  const AxisMarks marks = axisMarks(scale, 40, Instant(fromSeconds(0.1)));
  EXPECT_EQ(marks.step, fromSeconds(0.5));
  EXPECT_EQ(marks.first, Instant(fromSeconds(7.6)));
  EXPECT_EQ(axisMarks(scale, 15, {}).step, fromSeconds(0.2));
  EXPECT_EQ(axisMarks(scale, 10, {}).step, fromSeconds(0.1));
  EXPECT_EQ(axisMarks(scale, 60, {}).step, fromSeconds(1));
}

TEST(TimeScale, timesHaveAsManyDigitsAsTheyNeed) {
  EXPECT_EQ(timeText(fromSeconds(12.34)).toStdString(), "12.340");
  EXPECT_EQ(timeText(fromSeconds(12.34), fromSeconds(1)).toStdString(), "12");
  EXPECT_EQ(timeText(fromSeconds(12.34), fromSeconds(0.1)).toStdString(), "12.3");
  EXPECT_EQ(timeText(fromSeconds(12.34), Duration(0)).toStdString(), "12.340000000");
}

TEST(TimeScale, whatAUserTypesIsATime) {
  const auto parsed = [](const char* text) { return timeFromText(QString::fromUtf8(text), fromSeconds(10)); };
  EXPECT_EQ(parsed("12.5"), fromSeconds(12.5));
  EXPECT_EQ(parsed(" 12,5 s "), fromSeconds(12.5));
  EXPECT_EQ(parsed("1:02.5"), fromSeconds(62.5));
  EXPECT_EQ(parsed("1:02:03"), fromSeconds(3723));
  EXPECT_EQ(parsed("+1.5"), fromSeconds(11.5));
  EXPECT_EQ(parsed("-1:00"), fromSeconds(-50));
  for (const char* text : {"", "s", "x", "1:2:3:4", "1:-2", "nan", "1e300", "--1"})
    EXPECT_FALSE(parsed(text).has_value()) << text;
}

}  // namespace
}  // namespace widgets
