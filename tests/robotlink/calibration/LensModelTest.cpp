// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/calibration/LensModel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace robotlink {
namespace {

TEST(CameraModel, aBoardIsUsableIfItLooksDifferentFromEachSide) {
  EXPECT_TRUE(Chessboard{}.isUsable());
  EXPECT_TRUE((Chessboard{3, 4, 0.01}).isUsable());
  EXPECT_TRUE((Chessboard{50, 3, 1}).isUsable());
  EXPECT_FALSE((Chessboard{6, 6, 0.01}).isUsable()) << "from two sides it looks the same";
  EXPECT_FALSE((Chessboard{2, 3, 0.01}).isUsable());
  EXPECT_FALSE((Chessboard{51, 3, 0.01}).isUsable());
  EXPECT_FALSE((Chessboard{-9, 6, 0.01}).isUsable());
}

TEST(CameraModel, squaresOfABoardHaveASize) {
  for (const double square : {0.0, -0.01, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_FALSE((Chessboard{9, 6, square}).isUsable()) << square;
}

TEST(CameraModel, cornersOfABoardComeRowByRow) {
  const auto corners = Chessboard{4, 3, 0.5}.corners();
  ASSERT_EQ(corners.size(), 12U);
  EXPECT_EQ(corners[0], Vector3(0, 0, 0));
  EXPECT_EQ(corners[3], Vector3(1.5, 0, 0));
  EXPECT_EQ(corners[4], Vector3(0, 0.5, 0));
}

TEST(CameraModel, aLensOfAnAngleHasThatAngleAndSquarePixels) {
  const LensModel lens = LensModel::fromAngle(640, 480, radians(90.0));
  EXPECT_NEAR(lens.focalX, 320, 1e-9) << "the tangent of 45 degrees is 1";
  EXPECT_EQ(lens.focalX, lens.focalY);
  EXPECT_EQ(lens.centerX, 320);
  EXPECT_EQ(lens.centerY, 240);
  EXPECT_NEAR(lens.horizontalAngle(), radians(90.0), 1e-12);
  EXPECT_NEAR(lens.verticalAngle(), 2 * std::atan(0.75), 1e-12);
}

/// A fit of a camera at a height that is turned by these angles, about x first.
PlaceFit placeOf(double height, double pan, double tilt, double roll) {
  PlaceFit fit;
  fit.cameraInWorld = Eigen::Translation3d(1, 2, height) * Eigen::AngleAxisd(pan, Vector3::UnitZ()) *
                      Eigen::AngleAxisd(tilt, Vector3::UnitY()) * Eigen::AngleAxisd(roll, Vector3::UnitX());
  return fit;
}

TEST(CameraModel, theAnglesOfAPlaceAreThoseItWasTurnedBy) {
  for (const double pan : {-3.0, 0.0, 2.5}) {
    for (const double tilt : {-1.5, 0.0, 0.4, 1.5}) {
      for (const double roll : {-3.0, 0.0, 0.7}) {
        const PlaceFit fit = placeOf(1.5, pan, tilt, roll);
        EXPECT_NEAR(fit.pan(), pan, 1e-9);
        EXPECT_NEAR(fit.tilt(), tilt, 1e-9);
        EXPECT_NEAR(fit.roll(), roll, 1e-9);
        EXPECT_EQ(fit.height(), 1.5);
      }
    }
  }
}

TEST(CameraModel, aPositiveTiltLooksDownAndAPositiveRollIsClockwise) {
  const PlaceFit fit = placeOf(1, 0, 0.5, 0);
  EXPECT_LT((fit.cameraInWorld.rotation() * Vector3::UnitX()).z(), 0);
  const PlaceFit rolled = placeOf(1, 0, 0, 0.5);
  EXPECT_GT((rolled.cameraInWorld.rotation() * Vector3::UnitY()).z(), 0) << "its left side goes up";
}

TEST(CameraModel, aCameraThatLooksStraightDownHasATilt) {
  // Rounding may take the sine beyond 1.
  PlaceFit fit = placeOf(1, 0.3, kPi / 2, 0);
  fit.cameraInWorld.linear()(2, 0) = -1.0000000000000002;
  EXPECT_NEAR(fit.tilt(), kPi / 2, 1e-6);
}

}  // namespace
}  // namespace robotlink
