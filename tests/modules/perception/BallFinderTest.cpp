// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "modules/perception/BallFringes.h"
#include "modules/perception/CircleBallFinder.h"
#include "modules/perception/RegionBallFinder.h"
#include "tests/modules/perception/BallDiscs.h"
#include "tests/modules/perception/FieldCamera.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::radians;
using robotlink::Vector2;

/// Both finders on the same images; each test holds for both.
class BallFinder : public testing::TestWithParam<bool> {
 protected:
  BallObservation find(const CameraView& view) {
    const auto orange = world_.regions("orange");
    return GetParam() ? circle_.find(image_->view(), orange, view) : region_.find(orange, view);
  }
  /// A ball at `ball`, seen from the field's center with heading 0.
  BallObservation see(const Vector2& ball, const NeckAngles& neck) {
    world_.putBall(ball);
    const CameraView view = FieldCamera::view(neck);
    image_ = &world_.look({0, 0, 0}, view);
    return find(view);
  }

  FieldCamera world_;
  RegionBallFinder region_{{}};
  CircleBallFinder circle_{{}};
  const robotlink::Image* image_ = nullptr;
};

TEST_P(BallFinder, findsTheBallWhereItIs) {
  for (const double distance : {0.3, 0.5, 0.8, 1.2, 1.6, 2.0}) {
    for (const double bearing : {-0.35, 0.0, 0.3}) {
      const Vector2 ball(distance * std::cos(bearing), distance * std::sin(bearing));
      const BallObservation seen = see(ball, {distance < 0.5 ? radians(-35) : radians(-12), bearing, 0});
      ASSERT_TRUE(seen.seen) << distance << " " << bearing;
      EXPECT_LT((seen.positionInRobot - ball).norm(), 0.01 + 0.08 * distance) << distance << " " << bearing;
      EXPECT_GT(seen.confidence, 0.3) << distance << " " << bearing;
    }
  }
}

TEST_P(BallFinder, findsABallThatTheBorderCutsInHalf) {
  const Vector2 ball(0.6, 0.0);
  // The head looks so far to the right that the ball's middle is at the left border.
  const BallObservation seen = see(ball, {radians(-15), radians(-25), 0});
  ASSERT_TRUE(seen.seen);
  EXPECT_LT((seen.positionInRobot - ball).norm(), 0.12);
}

TEST_P(BallFinder, findsABallAtTheLowerBorder) {
  const Vector2 ball(0.33, 0.0);
  const BallObservation seen = see(ball, {radians(-9), 0, 0});
  ASSERT_TRUE(seen.seen);
  EXPECT_LT((seen.positionInRobot - ball).norm(), 0.08);
}

TEST_P(BallFinder, seesNoBallWhereNoneIs) {
  world_.putBall({0, 40});
  // All around, so that goals, beacons and walls come by.
  for (int i = 0; i < 24; ++i) {
    const CameraView view = FieldCamera::view({radians(-10), 0, 0});
    image_ = &world_.look({0.6, 0.4, i * robotlink::kPi / 12}, view);
    EXPECT_FALSE(find(view).seen) << "heading " << i * 15;
  }
}

TEST_P(BallFinder, rejectsABallThatHangsInTheAir) {
  world_.putBall({1.5, 0}, 0.5);
  const CameraView view = FieldCamera::view({0, 0, 0});
  image_ = &world_.look({0, 0, 0}, view);
  ASSERT_FALSE(world_.regions("orange").empty());
  EXPECT_FALSE(find(view).seen);
}

TEST_P(BallFinder, seesNothingInABlackImage) {
  const robotlink::Image black(176, 144, robotlink::PixelFormat::kYuyv);
  const auto seen = GetParam() ? circle_.find(black.view(), {}, FieldCamera::view({}))
                               : region_.find({}, FieldCamera::view({}));
  EXPECT_FALSE(seen.seen);
}

INSTANTIATE_TEST_SUITE_P(, BallFinder, testing::Bool(),
                         [](const auto& test) { return test.param ? "circleFit" : "region"; });

TEST(BallGeometry, agreesWithItselfOnTheSizeOfABall) {
  const BallGeometry geometry({});
  const CameraView view = FieldCamera::view({radians(-15), 0, 0});
  for (const double x : {0.3, 0.7, 1.5}) {
    const Vector2 ball(x, 0.1);
    const auto seen = geometry.locate(discAt(ball, view), view);
    ASSERT_TRUE(seen);
    EXPECT_LT((seen->positionInRobot - ball).norm(), 1e-3);
  }
}

TEST(BallGeometry, rejectsDiscsThatAreTooLargeOrTooSmallForTheirPlace) {
  const BallGeometry geometry({});
  const CameraView view = FieldCamera::view({radians(-20), 0, 0});
  const BallDisc disc = discAt({0.6, 0}, view);
  EXPECT_TRUE(geometry.locate(disc, view));
  EXPECT_FALSE(geometry.locate({disc.center, 2 * disc.radius, 0.6}, view));
  EXPECT_FALSE(geometry.locate({disc.center, 0.5 * disc.radius, 0.6}, view));
}

TEST(BallFringes, onlySmallRegionsAtTheEdgeOfALargerOneAreRemoved) {
  const auto region = [](int left, int top, int side) {
    return colortool::Region{
        1, side * side, left, top, left + side, top + side, left + 0.5 * side, top + 0.5 * side};
  };
  const colortool::Region fringe = region(30, 20, 3), ball = region(30, 24, 10), far = region(80, 20, 3);
  std::vector<colortool::Region> orange{fringe, ball, far};
  const std::vector<colortool::Region> goal{region(8, 10, 20)};
  removeFringes(orange, goal, 16);
  EXPECT_EQ(orange, (std::vector{ball, far}));
  orange = {fringe};
  removeFringes(orange, {region(26, 20, 2)}, 16);
  EXPECT_EQ(orange.size(), 1U) << "a smaller region is nothing at whose edge it is";
  removeFringes(orange, goal, 0);
  EXPECT_EQ(orange.size(), 1U) << "an area of 0 keeps all";
}

}  // namespace
}  // namespace modules
