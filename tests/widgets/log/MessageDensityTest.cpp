// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/MessageDensity.h"

#include <gtest/gtest.h>

namespace widgets {
namespace {

using robotlink::Duration;
using robotlink::Instant;

Instant ns(std::int64_t count) {
  return Instant(Duration(count));
}

/// Times 0, 10, 20, ... ns.
std::vector<Instant> evenly(std::size_t count) {
  std::vector<Instant> times;
  for (std::size_t i = 0; i < count; ++i) times.push_back(ns(static_cast<std::int64_t>(10 * i)));
  return times;
}

TEST(MessageDensity, countsTheMessagesOfAShortStreamExactly) {
  const MessageDensity density(evenly(100));
  EXPECT_EQ(density.count(), 100U);
  EXPECT_EQ(density.between(ns(10), ns(30)), 2U) << "the end does not belong to it";
  EXPECT_EQ(density.between(ns(-99), ns(99999)), 100U);
  EXPECT_EQ(MessageDensity().between(ns(0), ns(9)), 0U);
}

TEST(MessageDensity, estimatesALongStreamInBoundedMemory) {
  const std::size_t count = 5 * MessageDensity::kExact;
  const MessageDensity density(evenly(count));
  EXPECT_EQ(density.count(), count);
  EXPECT_EQ(density.between(ns(-1), ns(static_cast<std::int64_t>(10 * count))), count);
  const auto half = static_cast<std::int64_t>(5 * count);
  EXPECT_NEAR(static_cast<double>(density.between(ns(0), ns(half))), static_cast<double>(count) / 2, 8);
  EXPECT_EQ(density.snapped(ns(14), Duration(9)), ns(14)) << "its times are not kept";
}

TEST(MessageDensity, snapsToTheNearestMessageInReach) {
  const MessageDensity density(evenly(4));
  EXPECT_EQ(density.snapped(ns(14), Duration(5)), ns(10));
  EXPECT_EQ(density.snapped(ns(16), Duration(5)), ns(20));
  EXPECT_EQ(density.snapped(ns(14), Duration(3)), ns(14));
  EXPECT_EQ(density.snapped(ns(33), Duration(5)), ns(30));
  EXPECT_EQ(density.snapped(ns(-4), Duration(5)), ns(0));
}

}  // namespace
}  // namespace widgets
