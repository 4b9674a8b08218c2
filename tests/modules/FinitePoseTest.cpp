// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/FinitePose.h"

#include <gtest/gtest.h>

#include <limits>

namespace modules {
namespace {

TEST(FinitePose, eachValueHasToBeANumber) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isFinite({1, -2, 3}));
  EXPECT_FALSE(isFinite({kNone, 0, 0}));
  EXPECT_FALSE(isFinite({0, kInfinite, 0}));
  EXPECT_FALSE(isFinite({0, 0, -kInfinite}));
}

}  // namespace
}  // namespace modules
