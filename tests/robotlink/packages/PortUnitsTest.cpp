// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/PortUnits.h"

#include <gtest/gtest.h>

namespace robotlink {
namespace {

TEST(PortUnits, unitsAreSharedOutInTheOrderOfTheNumbers) {
  EXPECT_EQ(unitOfNumber("m/s, rad/s", 0, 6), "m/s");
  EXPECT_EQ(unitOfNumber("m/s, rad/s", 2, 6), "m/s");
  EXPECT_EQ(unitOfNumber("m/s, rad/s", 3, 6), "rad/s");
  EXPECT_EQ(unitOfNumber("m, m, rad", 2, 3), "rad");
}

TEST(PortUnits, oneUnitIsThatOfAllNumbers) {
  EXPECT_EQ(unitOfNumber("m", 719, 720), "m");
  EXPECT_EQ(unitOfNumber("", 0, 1), "");
}

TEST(PortUnits, whatCannotBeSharedOutIsLeftAsItIs) {
  EXPECT_EQ(unitOfNumber("m, rad", 1, 3), "m, rad");
  EXPECT_EQ(unitOfNumber("m, rad", 2, 2), "m, rad");
  EXPECT_EQ(unitOfNumber("m", 0, 0), "m");
}

}  // namespace
}  // namespace robotlink
