// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/GlobalPosition.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace robotlink;

namespace {
const GlobalPosition kOffice{42.807191, -71.578661, 72};
}

TEST(GlobalPosition, theOriginIsWhereItIs) {
  const GlobalPosition here = globalPosition(kOffice, {0, 0, 0});
  EXPECT_NEAR(here.latitude, kOffice.latitude, 1e-11);
  EXPECT_NEAR(here.longitude, kOffice.longitude, 1e-11);
  EXPECT_NEAR(here.altitude, 72, 1e-6);
  EXPECT_NEAR(globalPosition(kOffice, {0, 0, 5}).altitude, 77, 1e-6);
}

TEST(GlobalPosition, aDegreeIsAsLongAsTablesSay) {
  // At 45 degrees: 111.132 km of latitude, 78.847 km of longitude.
  const GlobalPosition north = globalPosition({45, 10, 0}, {0, 100, 0});
  EXPECT_NEAR((north.latitude - 45) * 111'132, 100, 0.01);
  EXPECT_NEAR(north.longitude, 10, 1e-12);
  const GlobalPosition east = globalPosition({45, 10, 0}, {100, 0, 0});
  EXPECT_NEAR((east.longitude - 10) * 78'847, 100, 0.01);
  EXPECT_NEAR(east.latitude, 45, 1e-7);
}

TEST(GlobalPosition, polesAndTheDateLineAreNoTrouble) {
  const GlobalPosition pole = globalPosition({90, 0, 0}, {0, 0, 3});
  EXPECT_NEAR(pole.latitude, 90, 1e-9);
  EXPECT_NEAR(pole.altitude, 3, 1e-6);
  const GlobalPosition west = globalPosition({0, 179.9999, 0}, {100, 0, 0});
  EXPECT_LT(west.longitude, -179.99);
  EXPECT_TRUE(std::isfinite(globalPosition({-90, 0, 0}, {5, 5, 0}).longitude));
}
