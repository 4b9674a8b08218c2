// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BallGeometry.h"

#include <gtest/gtest.h>

namespace modules {
namespace {

using robotlink::Pose3;
using robotlink::Vector2;
using robotlink::Vector3;

constexpr double kBallHeight = 0.042;

/// 0.2 m above the ground, tilted down.
CameraView ballCamera(double down = 0.3) {
  CameraView view;
  view.cameraInRobot =
      Pose3(Eigen::Translation3d(0, 0, 0.2)) * Pose3(Eigen::AngleAxisd(down, Vector3::UnitY()));
  return view;
}

/// The disc of a ball on the ground.
BallDisc discAt(const BallGeometry& geometry, const Vector2& place, const CameraView& view) {
  return {*view.pixelOf({place.x(), place.y(), kBallHeight}), geometry.radiusAt(place, view), 0.6};
}

TEST(BallGeometry, aBallIsLocatedWhereItLies) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  for (const Vector2& place : {Vector2(0.4, 0), Vector2(0.7, 0.15), Vector2(1.5, -0.3), Vector2(3, 0.5)}) {
    const auto ball = geometry.locate(discAt(geometry, place, view), view);
    ASSERT_TRUE(ball) << place.transpose();
    EXPECT_TRUE(ball->seen);
    EXPECT_LT((ball->positionInRobot - place).norm(), 0.03 * place.norm()) << place.transpose();
    EXPECT_GT(ball->confidence, 0.9);
  }
}

TEST(BallGeometry, theRadiusShrinksWithTheDistance) {
  const BallGeometry geometry({});
  double before = 1e9;
  for (const double distance : {0.3, 0.6, 1.2, 2.4}) {
    const double radius = geometry.radiusAt({distance, 0}, ballCamera());
    EXPECT_LT(radius, before);
    EXPECT_GT(radius, 0);
    before = radius;
  }
  EXPECT_EQ(geometry.radiusAt({-1, 0}, ballCamera()), 0) << "behind the camera";
}

TEST(BallGeometry, aBallInTheCameraHasNoRadius) {
  CameraView view;
  view.cameraInRobot = Pose3(Eigen::Translation3d(0.5, 0, kBallHeight));
  EXPECT_EQ(BallGeometry({}).radiusAt({0.52, 0}, view), 0);
}

TEST(BallGeometry, aDiscThatIsMuchTooLargeOrSmallForItsPlaceIsNoBall) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  BallDisc disc = discAt(geometry, {0.5, 0}, view);
  disc.radius *= 2.5;
  EXPECT_FALSE(geometry.locate(disc, view)) << "a shirt, or in the air";
  disc.radius /= 2.5 * 2.5;
  EXPECT_FALSE(geometry.locate(disc, view));
  disc.radius = 0;
  EXPECT_FALSE(geometry.locate(disc, view));
}

TEST(BallGeometry, whatIsAboveTheHorizonIsNoBallUnlessTheHorizonMayBeWrong) {
  const CameraView view = ballCamera(0);
  const BallDisc high{{88, 30}, 8, 0.6};
  EXPECT_FALSE(BallGeometry({}).locate(high, view));
}

TEST(BallGeometry, aBallThatIsCutOffIsLocatedByTheRayThroughItsCenter) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  const Vector2 place(0.8, 0);
  BallDisc disc = discAt(geometry, place, view);
  disc.radius *= 1.5;
  disc.radiusDeviation = disc.radius;  // nothing is known about it
  const auto ball = geometry.locate(disc, view);
  ASSERT_TRUE(ball);
  EXPECT_LT((ball->positionInRobot - place).norm(), 0.08);
}

TEST(BallGeometry, aBallBeyondTheFieldIsNone) {
  BallGeometry::Options options;
  options.maximumDistance = 1;
  const BallGeometry near(options);
  const CameraView view = ballCamera();
  EXPECT_TRUE(near.locate(discAt(near, {0.9, 0}, view), view));
  EXPECT_FALSE(near.locate(discAt(near, {1.2, 0}, view), view));
}

TEST(BallGeometry, confidenceFallsWithDisagreement) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  BallDisc disc = discAt(geometry, {1, 0}, view);
  double before = 2;
  for (const double factor : {1.0, 1.1, 1.2}) {
    BallDisc larger = disc;
    larger.radius *= factor;
    const auto ball = geometry.locate(larger, view);
    if (!ball) break;
    EXPECT_LT(ball->confidence, before);
    before = ball->confidence;
  }
  EXPECT_LT(before, 1);
}

}  // namespace
}  // namespace modules
