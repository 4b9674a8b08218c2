// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/CameraView.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Pose3;
using robotlink::Vector2;
using robotlink::Vector3;

/// 0.2 m over the ground, looking down by `down`.
CameraView lookingDown(double down, double roll = 0) {
  CameraView view;
  view.cameraInRobot = Pose3(Eigen::Translation3d(0.1, 0, 0.2)) *
                       Pose3(Eigen::AngleAxisd(down, Vector3::UnitY())) *
                       Pose3(Eigen::AngleAxisd(roll, Vector3::UnitX()));
  return view;
}

TEST(CameraView, hasTheFocalLengthOfItsOpeningAngles) {
  const CameraView view =
      CameraView::fromAngles(Pose3::Identity(), robotlink::radians(57.6), robotlink::radians(47.8), 176, 144);
  EXPECT_NEAR(view.focalX, 160.07, 0.02);
  EXPECT_NEAR(view.focalY, 162.48, 0.02);
}

TEST(CameraView, findsThePlaceOnTheGroundUnderThePixel) {
  const auto place = lookingDown(robotlink::radians(45)).onPlane({88, 72}, 0);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x(), 0.3, 1e-9);
  EXPECT_NEAR(place->y(), 0, 1e-9);
}

TEST(CameraView, seesLeftInTheLeftHalfOfTheImage) {
  const CameraView view = lookingDown(0.2);
  EXPECT_GT(view.bearing({20, 72}), 0.3);
  EXPECT_LT(view.bearing({150, 72}), -0.3);
  EXPECT_GT(view.elevation({88, 10}), view.elevation({88, 100}));
}

TEST(CameraView, putsAPointWhereItsRayComesFrom) {
  const CameraView view = lookingDown(0.4, 0.2);
  for (const Vector2& pixel : {Vector2(10, 140), Vector2(88, 72), Vector2(170, 100.5)}) {
    const auto place = view.onPlane(pixel, 0.042);
    ASSERT_TRUE(place);
    const auto back = view.pixelOf({place->x(), place->y(), 0.042});
    ASSERT_TRUE(back);
    EXPECT_NEAR((*back - pixel).norm(), 0, 1e-9);
  }
}

TEST(CameraView, findsNoGroundAboveTheHorizonAndNoPixelBehindIt) {
  EXPECT_FALSE(lookingDown(0).onPlane({88, 30}, 0));
  EXPECT_FALSE(lookingDown(0).pixelOf({-1, 0, 0.2}));
}

TEST(CameraView, hasRaysAlongTheLevelPlaneOnTheHorizon) {
  const CameraView view = lookingDown(0.3, 0.25);
  for (const double column : {0.0, 60.0, 176.0})
    EXPECT_NEAR(view.elevation({column, view.horizonRow(column).value()}), 0, 1e-9);
  EXPECT_LT(lookingDown(0.3).horizonRow(88).value(), 72);
  EXPECT_FALSE(lookingDown(robotlink::kPi / 2).horizonRow(88));
}

}  // namespace
}  // namespace modules
