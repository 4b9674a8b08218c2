// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/team/TeamBallFusion.h"

#include <gtest/gtest.h>

#include <array>

namespace modules {
namespace {

using robotlink::Vector2;

BallReport report(const char* robot, const Vector2& place, double deviation, double age = 0) {
  BallReport report;
  report.robot = robot;
  report.position = place;
  report.covariance = Eigen::Matrix2d::Identity() * deviation * deviation;
  report.age = age;
  return report;
}

TEST(TeamBallFusion, knowsNothingWithoutReports) {
  EXPECT_FALSE(TeamBallFusion({}).fuse({}));
  const std::array old{report("red1", {1, 0}, 0.1, 100)};
  EXPECT_FALSE(TeamBallFusion({}).fuse(old));
}

TEST(TeamBallFusion, isCloserToTheMoreCertainRobotAndNeverMoreCertainThanIt) {
  const std::array reports{report("red1", {1, 0}, 0.05), report("red2", {1.2, 0}, 0.3)};
  const auto ball = TeamBallFusion({}).fuse(reports);
  ASSERT_TRUE(ball);
  EXPECT_LT((ball->position - Vector2(1, 0)).norm(), 0.05);
  // Both may be based on the same information, so the deviation must not shrink as if they were not.
  EXPECT_GE(ball->deviation(), 0.05 - 1e-9);
}

TEST(TeamBallFusion, combinesWhatRobotsKnowInDifferentDirections) {
  BallReport along = report("red1", {1, 0.02}, 0.3), across = report("red2", {1.02, 0}, 0.3);
  along.covariance = Eigen::Vector2d(0.25, 0.0025).asDiagonal();
  across.covariance = Eigen::Vector2d(0.0025, 0.25).asDiagonal();
  const std::array reports{along, across};
  const auto ball = TeamBallFusion({}).fuse(reports);
  ASSERT_TRUE(ball);
  EXPECT_LT(ball->deviation(), 0.1);
  EXPECT_LT((ball->position - Vector2(1.02, 0.02)).norm(), 0.02);
  EXPECT_EQ(ball->robots, (std::vector<std::string>{"red1", "red2"}));
}

TEST(TeamBallFusion, followsTheMajorityAgainstARobotThatIsLost) {
  const std::array reports{report("red1", {-1.5, 1}, 0.08), report("red2", {1, 0}, 0.1),
                           report("red3", {1.05, 0.05}, 0.1)};
  const auto ball = TeamBallFusion({}).fuse(reports);
  ASSERT_TRUE(ball);
  EXPECT_LT((ball->position - Vector2(1, 0)).norm(), 0.1);
  EXPECT_EQ(std::ranges::count(ball->robots, "red1"), 0);
}

TEST(TeamBallFusion, rollsAnOlderReportOn) {
  BallReport old = report("red1", {0, 0}, 0.05, 1);
  old.velocity = {0.6, 0};
  const std::array reports{old};
  const auto ball = TeamBallFusion({}).fuse(reports);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->position.x(), 0.6 - 0.5 * 0.3, 1e-9);
  EXPECT_NEAR(ball->velocity.x(), 0.3, 1e-9);
  EXPECT_GT(ball->deviation(), 0.1);
}

TEST(TeamBallFusion, aRobotThatDoubtsItsHeadingDoubtsFarBallsSideways) {
  const Eigen::Matrix2d covariance = ballCovariance({2, 0}, 0.05, {0, 0, 1}, 0.05, 0.1);
  EXPECT_NEAR(covariance(0, 0), 0.005, 1e-4);
  EXPECT_NEAR(covariance(1, 1), 0.045, 1e-4);
}

}  // namespace
}  // namespace modules
