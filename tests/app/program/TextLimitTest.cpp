// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/TextLimit.h"

#include <gtest/gtest.h>

namespace {

using app::TextLimit;
using namespace std::chrono_literals;

const TextLimit::RealTime kStart{1000s};

TEST(TextLimit, someTextsAreShownAtOnceAndAllOfASlowSender) {
  TextLimit limit;
  for (int i = 0; i < TextLimit::kBurst; ++i) EXPECT_TRUE(limit.admit(kStart));
  EXPECT_FALSE(limit.admit(kStart));
  for (int i = 1; i < 100; ++i) EXPECT_TRUE(limit.admit(kStart + i * 200ms));
  EXPECT_EQ(limit.suppressed(), 1U);
}

TEST(TextLimit, aFloodIsCountedAndItsNumberIsReportedOnceASecond) {
  TextLimit limit;
  int shown = 0, tellings = 0;
  std::uint64_t reported = 0;
  for (int i = 0; i < 200'000; ++i) {  // ten seconds at 20 kHz
    const auto now = kStart + i * 50us;
    shown += limit.admit(now) ? 1 : 0;
    const std::uint64_t count = limit.takeSuppressed(now);
    tellings += count > 0 ? 1 : 0;
    reported += count;
  }
  reported += limit.takeSuppressed(kStart + 20s);
  EXPECT_LE(shown, TextLimit::kBurst + 10 * TextLimit::kPerSecond);
  EXPECT_LE(tellings, 10);
  EXPECT_EQ(static_cast<std::uint64_t>(shown) + reported, 200'000U);
  EXPECT_EQ(limit.suppressed(), reported);
  EXPECT_EQ(limit.takeSuppressed(kStart + 30s), 0U);
}

}  // namespace
