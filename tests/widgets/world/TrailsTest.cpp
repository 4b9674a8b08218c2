// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/Trails.h"

#include <gtest/gtest.h>

#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

using robotlink::Instant;
using robotlink::Vector2;

Instant trailTime(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

/// A robot that drives along x at 1 m/s from 0 s on, by the transforms, and one that believes to stand.
class TrailsTest : public testing::Test {
 protected:
  void drive(double from, double to) {
    for (double t = from; t < to - 1e-9; t += 0.05) {
      auto transforms = std::make_shared<foxglove::FrameTransforms>();
      auto& transform = *transforms->add_transforms();
      transform.set_child_frame_id("red1");
      transform.set_parent_frame_id("field");
      transform.mutable_translation()->set_x(t);
      session.push({"transforms", trailTime(t), transforms});
      auto pose = std::make_shared<robotcontrol::RobotPose>();
      pose->mutable_robot_in_field()->set_y(2);
      session.push({"p3at1/models/pose", trailTime(t), pose});
    }
    session.tick();
  }
  const Trails::Places& update(double shown) {
    trails.update(session.store(), sources, trailTime(shown));
    return trails.places();
  }
  double first() const { return trails.places().at("red1").front().x(); }
  double last() const { return trails.places().at("red1").back().x(); }

  robotlink::Session session;
  Trails trails;
  Trails::Sources sources{{{"red1", "red1"}}, {{"p3at1", "p3at1/models/pose"}}};
};

TEST_F(TrailsTest, reachBackTenSecondsInStepsOfATenth) {
  drive(0, 20);
  const auto& places = update(15);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places.at("red1").size(), 100U);
  EXPECT_NEAR(first(), 5.1, 0.06);
  EXPECT_NEAR(last(), 15, 0.06);
  EXPECT_EQ(places.at("p3at1").back(), Vector2(0, 2));
}

TEST_F(TrailsTest, growWhileTimeGoesOn) {
  drive(0, 3);
  update(2);
  EXPECT_NEAR(last(), 2, 0.06);
  update(2.5);
  EXPECT_NEAR(last(), 2.5, 0.06);
  for (int i = 1; i <= 405; ++i) update(2.5 + 0.001 * i);
  EXPECT_NEAR(last(), 2.9, 0.06);
  EXPECT_LE(trails.places().at("red1").size(), 30U);
}

TEST_F(TrailsTest, areReadAgainAfterAJumpBack) {
  drive(0, 20);
  update(18);
  update(4);
  EXPECT_NEAR(first(), 0.1, 0.06);
  EXPECT_NEAR(last(), 4, 0.06);
  update(17);  // farther than they reach
  EXPECT_NEAR(first(), 7.1, 0.06);
}

TEST_F(TrailsTest, ofALongTimeHaveFewerPlacesForEachSecond) {
  drive(0, 20);
  update(15);
  trails.setReach(std::chrono::seconds(60));
  EXPECT_TRUE(trails.places().empty());
  const auto& places = update(19);
  EXPECT_LE(places.at("red1").size(), 300U);
  EXPECT_GT(places.at("red1").size(), 80U);
  EXPECT_NEAR(first(), 0.2, 0.25);
}

TEST_F(TrailsTest, areReadAgainWhenTheHistoryIsReplaced) {
  drive(0, 10);
  update(5);
  session.restart([this] {
    auto transforms = std::make_shared<foxglove::FrameTransforms>();
    auto& transform = *transforms->add_transforms();
    transform.set_child_frame_id("red1");
    transform.mutable_translation()->set_x(-7);
    session.push({"transforms", trailTime(5), transforms});
  });
  session.tick();
  update(5.2);
  EXPECT_EQ(first(), -7) << "the log was moved to another place";
  EXPECT_LE(trails.places().at("red1").size(), 3U);
}

TEST_F(TrailsTest, theEstimatedBallIsWhereTheRobotBelievesItToBe) {
  drive(0, 3);
  auto ball = std::make_shared<robotcontrol::BallModel>();
  ball->set_known(true);
  ball->mutable_position_in_robot()->set_x(1);
  session.push({"p3at1/models/ball", trailTime(1), ball});
  session.tick();
  sources.balls["p3at1/ball"] = {"p3at1/models/pose", "p3at1/models/ball"};
  const auto& places = update(2);
  ASSERT_TRUE(places.contains("p3at1/ball"));
  EXPECT_EQ(places.at("p3at1/ball").back(), Vector2(1, 2));
  EXPECT_LE(places.at("p3at1/ball").size(), 11U) << "not before it was seen";
}

TEST_F(TrailsTest, ofModelsThatAreNotAskedForAreNone) {
  drive(0, 2);
  sources.frames.clear();
  EXPECT_FALSE(update(1).contains("red1"));
}

}  // namespace
}  // namespace widgets
