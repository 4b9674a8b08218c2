// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/NaturalOrder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace robotlink {
namespace {

TEST(NaturalOrder, numbersCountByTheirValue) {
  EXPECT_TRUE(comesNaturallyBefore("frame-9", "frame-10"));
  EXPECT_FALSE(comesNaturallyBefore("frame-10", "frame-9"));
  EXPECT_TRUE(comesNaturallyBefore("a01b2", "a1b10"));
  // They need not fit into any type of numbers.
  EXPECT_TRUE(comesNaturallyBefore("99999999999999999999998", "99999999999999999999999"));
}

TEST(NaturalOrder, aTextStandsBeforeItsContinuation) {
  EXPECT_TRUE(comesNaturallyBefore("", "a"));
  EXPECT_TRUE(comesNaturallyBefore("a", "a1"));
  EXPECT_FALSE(comesNaturallyBefore("a1", "a"));
  EXPECT_FALSE(comesNaturallyBefore("a", ""));
}

TEST(NaturalOrder, isAStrictOrderOfAllTexts) {
  std::vector<std::string> texts{"",    "0",    "00", "a",   "a0", "a00", "a01", "a1",
                                 "a1b", "a01b", "a2", "a10", "b",  "10",  "9"};
  for (const auto& a : texts) {
    for (const auto& b : texts)
      EXPECT_EQ(comesNaturallyBefore(a, b) + comesNaturallyBefore(b, a), a == b ? 0 : 1) << a << ' ' << b;
  }
  std::ranges::sort(texts, comesNaturallyBefore);
  EXPECT_EQ(texts.front(), "");
  EXPECT_LT(std::ranges::find(texts, "9"), std::ranges::find(texts, "10"));
}

}  // namespace
}  // namespace robotlink
