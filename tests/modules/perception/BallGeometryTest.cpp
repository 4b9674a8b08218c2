// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/BallGeometry.h"

#include <gtest/gtest.h>

#include "tests/modules/perception/BallDiscs.h"

namespace modules {
namespace {

using robotlink::Pose3;
using robotlink::Vector2;
using robotlink::Vector3;

/// 0.2 m above the ground, tilted down.
CameraView ballCamera(double down = 0.3) {
  CameraView view;
  view.cameraInRobot =
      Pose3(Eigen::Translation3d(0, 0, 0.2)) * Pose3(Eigen::AngleAxisd(down, Vector3::UnitY()));
  return view;
}

TEST(BallGeometry, aBallIsLocatedWhereItLies) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  for (const Vector2& place : {Vector2(0.4, 0), Vector2(0.7, 0.15), Vector2(1.5, -0.3), Vector2(3, 0.5)}) {
    const auto ball = geometry.locate(discAt(place, view), view);
    ASSERT_TRUE(ball) << place.transpose();
    EXPECT_TRUE(ball->seen);
    EXPECT_LT((ball->positionInRobot - place).norm(), 0.03 * place.norm()) << place.transpose();
    EXPECT_GT(ball->confidence, 0.9);
  }
}

TEST(BallGeometry, aDiscThatIsMuchTooLargeOrSmallForItsPlaceIsNoBall) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  BallDisc disc = discAt({0.5, 0}, view);
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
  BallDisc disc = discAt(place, view);
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
  EXPECT_TRUE(near.locate(discAt({0.9, 0}, view), view));
  EXPECT_FALSE(near.locate(discAt({1.2, 0}, view), view));
}

TEST(BallGeometry, confidenceFallsWithDisagreement) {
  const BallGeometry geometry({});
  const CameraView view = ballCamera();
  BallDisc disc = discAt({1, 0}, view);
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
