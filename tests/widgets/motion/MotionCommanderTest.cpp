// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionCommander.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robotcontrol/Motion.pb.h"

namespace widgets {
namespace {

using robotcontrol::MotionRequest;

class MotionCommanderTest : public testing::Test {
 protected:
  MotionCommanderTest() { commander.setActive(true); }
  int sentIn(int ticks) {
    int sent = 0;
    for (int i = 0; i < ticks; ++i) sent += commander.tick(nullptr) ? 1 : 0;
    return sent;
  }

  MotionCommander commander;
};

TEST_F(MotionCommanderTest, commandsTenTimesASecondAndAtOnceAfterAChange) {
  EXPECT_TRUE(commander.tick(nullptr));
  EXPECT_EQ(sentIn(30), 10);
  commander.setAxes({1, 0, 0});
  EXPECT_TRUE(commander.tick(nullptr));
  EXPECT_FALSE(commander.tick(nullptr));
  commander.setActive(false);
  EXPECT_EQ(sentIn(30), 0);
}

TEST_F(MotionCommanderTest, fullDeflectionIsTheLimitInEveryDirection) {
  commander.setLimits({0.2, 1.5});
  commander.setAxes({1, 1, -1});
  const auto walk = commander.command().motion().walk();
  EXPECT_EQ(commander.command().motion().kind(), MotionRequest::WALK);
  EXPECT_NEAR(std::hypot(walk.x(), walk.y()), 0.2, 1e-12);
  EXPECT_DOUBLE_EQ(walk.x(), walk.y());
  EXPECT_DOUBLE_EQ(walk.rotation(), -1.5);
  commander.setAxes({0.5, 0, 0});
  EXPECT_DOUBLE_EQ(commander.command().motion().walk().x(), 0.1);
}

TEST_F(MotionCommanderTest, aMotionIsCommandedUntilTheRobotPlaysIt) {
  commander.play("bow");
  commander.tick(nullptr);
  EXPECT_EQ(commander.command().motion().motion(), "bow");
  robotcontrol::MotionStatus status;
  status.mutable_executed()->set_kind(MotionRequest::KEY_FRAMES);
  status.mutable_executed()->set_motion("wave");
  commander.tick(&status);
  EXPECT_EQ(commander.command().motion().motion(), "bow") << "it plays another one";
  status.mutable_executed()->set_motion("bow");
  commander.tick(&status);
  EXPECT_EQ(commander.command().motion().motion(), "");
}

TEST_F(MotionCommanderTest, aMotionThatNeverBeginsIsGivenUpAfterASecond) {
  commander.play(MotionCommander::kGetUp);
  EXPECT_EQ(commander.command().motion().kind(), MotionRequest::GET_UP);
  sentIn(29);
  EXPECT_EQ(commander.command().motion().kind(), MotionRequest::GET_UP);
  sentIn(3);
  EXPECT_NE(commander.command().motion().kind(), MotionRequest::GET_UP);
}

TEST_F(MotionCommanderTest, standingStillLeavesTheHeadAsItIs) {
  commander.setAxes({1, 0, 0});
  commander.setHead({HeadTarget::Kind::kAngles, 0.1, 0.2, 0.3, 0.4});
  commander.play("bow");
  commander.halt();
  EXPECT_FALSE(commander.command().motion().has_walk());
  EXPECT_EQ(commander.command().motion().motion(), "");
  EXPECT_DOUBLE_EQ(commander.command().head().pan(), 0.2);
  commander.setAxes({1, 0, 0});
  commander.setActive(false);
  EXPECT_FALSE(commander.command().motion().has_walk()) << "who gives up control stands";
}

}  // namespace
}  // namespace widgets
