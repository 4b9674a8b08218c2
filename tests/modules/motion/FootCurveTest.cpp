// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/motion/FootCurve.h"

#include <gtest/gtest.h>

#include <cmath>

namespace modules {
namespace {

class FootCurveTest : public testing::TestWithParam<FootMode> {};

TEST_P(FootCurveTest, theCurveIsClosedAndWithoutJumps) {
  const FootCurve curve{GetParam(), 0.5, 0.06, 0.08};
  FootPoint last = curve.at(0.99999);
  for (int i = 0; i < 10000; ++i) {
    const FootPoint point = curve.at(i / 10000.0);
    EXPECT_LT(std::abs(point.along - last.along), 1e-3);
    EXPECT_LT(std::abs(point.up - last.up), 5e-3);
    EXPECT_LE(std::abs(point.along), 0.5 + 1e-12);
    EXPECT_TRUE(point.up >= 0 && point.up <= 1);
    last = point;
  }
}

TEST_P(FootCurveTest, thePawGoesBackOnTheGroundAndForthInTheAir) {
  const FootCurve curve{GetParam(), 0.5, 0.06, 0.06};
  EXPECT_DOUBLE_EQ(curve.at(0).along, 0.5);
  EXPECT_DOUBLE_EQ(curve.at(0.25).along, 0);
  EXPECT_EQ(curve.at(0.25).up, 0);
  EXPECT_NEAR(curve.at(0.75).along, 0, 1e-9);
  EXPECT_NEAR(curve.at(0.75).up, 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(FootModes, FootCurveTest,
                         testing::Values(FootMode::kRectangle, FootMode::kHalfEllipse));

TEST(FootCurveShapeTest, aRectangleHasStraightSides) {
  const FootCurve curve{FootMode::kRectangle, 0.5, 0.1, 0.1};
  EXPECT_DOUBLE_EQ(curve.at(0.55).along, -0.5);
  EXPECT_NEAR(curve.at(0.55).up, 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(curve.at(0.95).along, 0.5);
  EXPECT_NEAR(curve.at(0.95).up, 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(curve.at(0.7).up, 1);
}

}  // namespace
}  // namespace modules
