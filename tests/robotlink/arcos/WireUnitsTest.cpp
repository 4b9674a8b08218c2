// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/WireUnits.h"

#include <gtest/gtest.h>

#include <limits>

using namespace robotlink::arcos;

TEST(WireUnits, lengthsAndAnglesAreRoundedToWholeMillimetersAndDegrees) {
  EXPECT_EQ(inMillimeters(-0.2506), -251);
  EXPECT_EQ(inDegrees(1), 57);
}

TEST(WireUnits, whatIsNoNumberAsksForNothingAndWhatIsHugeStaysHuge) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(inMillimeters(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(inMillimeters(kInfinity), 0);
  EXPECT_EQ(inMillimeters(1e300), 1'000'000);
  EXPECT_EQ(inDegrees(-1e300), -1'000'000);
}
