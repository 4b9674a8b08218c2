// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/expressions/BoundExpression.h"

#include <gmock/gmock.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Modeling.pb.h"

namespace robotlink {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::vector<std::string> kStreams{"blue1/models/ball", "red1/log", "red1/models/ball", "simulation"};
const std::vector<std::string> kRobots{"blue1", "red1"};

std::vector<std::string> robots(const std::string& text) {
  const auto bound = BoundExpression::bind(text, kStreams, kRobots);
  EXPECT_TRUE(bound) << text << ": " << bound.error().describe();
  std::vector<std::string> all;
  for (const BoundExpression& one : *bound) all.push_back(one.robot());
  return all;
}

robotcontrol::BallModel ballAt(double x) {
  robotcontrol::BallModel ball;
  ball.mutable_position_in_robot()->set_x(x);
  return ball;
}

TEST(BoundExpression, isBoundToEachRobotThatHasItsStreams) {
  EXPECT_THAT(robots("models/ball.known"), ElementsAre("blue1", "red1"));
  EXPECT_THAT(robots("models/ball.known && log.level > 2"), ElementsAre("red1"));
  EXPECT_THAT(robots("models/ball.known && simulation.time > 2"), ElementsAre("blue1", "red1"));
  EXPECT_THAT(robots("red1/models/ball.known && blue1/models/ball.known"), ElementsAre(""));
  EXPECT_THAT(robots("simulation.time > 1"), ElementsAre(""));
}

TEST(BoundExpression, theNearestStreamIsNamedWhereOneIsNotKnown) {
  const auto unknown = BoundExpression::bind("1 + models/bal.known", kStreams, kRobots);
  ASSERT_FALSE(unknown);
  EXPECT_THAT(unknown.error().text, HasSubstr("did you mean 'models/ball'"));
  EXPECT_EQ(unknown.error().where.column, 5);
  const auto nobody = BoundExpression::bind("log.level + camera.x", {"a/log", "b/camera"}, {"a", "b"});
  ASSERT_FALSE(nobody);
  EXPECT_EQ(nobody.error().id, "expression.robot");
}

TEST(BoundExpression, followsTheMessagesOfItsStreams) {
  auto bound = BoundExpression::bind(
      "red1/models/ball.position_in_robot.x - blue1/models/ball.position_in_robot.x", kStreams, kRobots);
  ASSERT_TRUE(bound);
  BoundExpression& difference = bound->front();
  EXPECT_EQ(difference.take("red1/models/ball", ballAt(5)), true);
  EXPECT_EQ(difference.value(), std::nullopt);
  EXPECT_EQ(difference.take("blue1/models/ball", ballAt(3)), true);
  EXPECT_EQ(difference.take("simulation", ballAt(9)), false);
  EXPECT_EQ(difference.value(), 2);
  difference.forget("blue1/models/ball");
  EXPECT_EQ(difference.value(), std::nullopt);
}

TEST(BoundExpression, aTypeWithoutTheFieldIsAnError) {
  auto bound = BoundExpression::bind("0 + models/ball.position_in_robt.x", kStreams, {"red1"});
  ASSERT_TRUE(bound);
  const auto taken = bound->front().take("red1/models/ball", ballAt(5));
  ASSERT_FALSE(taken);
  EXPECT_THAT(taken.error().text, HasSubstr("did you mean 'position_in_robot'"));
  EXPECT_EQ(taken.error().where.column, 17);
}

}  // namespace
}  // namespace robotlink
