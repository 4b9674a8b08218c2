// SPDX-License-Identifier: GPL-3.0-or-later
// The behavior that does what a person asks for, by its packages.
#include <gtest/gtest.h>

#include "robotcontrol/Motion.pb.h"
#include "robotlink/packages/Packages.h"
#include "tests/modules/OneSolution.h"

namespace modules {
namespace {

using robotcontrol::MotionRequest;

class ObeyTest : public testing::Test {
 protected:
  void ask(MotionRequest::Kind kind) {
    robotcontrol::RemoteMotion remote;
    remote.mutable_motion()->set_kind(kind);
    remote.mutable_motion()->mutable_walk()->set_x(0.1);
    remote.mutable_head()->set_pan(0.5);
    obey_.set(robotlink::kRemoteMotion, remote);
  }
  MotionRequest::Kind motion() {
    obey_.execute();
    return obey_.sent(robotlink::kMotionRequest)->kind();
  }
  OneSolution obey_{"behavior", "obey",
                    OneSolution::Robot{.map = nullptr, .name = "red1", .description = "ers210.yaml"}};
};

TEST_F(ObeyTest, aWalkGoesOnWhileItIsRepeatedAndEndsWhenNobodyIsHeardAnyMore) {
  for (int i = 0; i < 40; ++i) {
    if (i % 10 == 0) ask(MotionRequest::WALK);
    EXPECT_EQ(motion(), MotionRequest::WALK) << i;
    obey_.pass();
  }
  obey_.pass(2);
  EXPECT_EQ(motion(), MotionRequest::STAND);
  EXPECT_EQ(obey_.sent(robotlink::kHeadMode)->pan(), 0.5) << "the head stays where it looks";
  ask(MotionRequest::WALK);
  EXPECT_EQ(motion(), MotionRequest::WALK) << "heard again";
}

TEST_F(ObeyTest, motionsThatEndByThemselvesAreNotCutShort) {
  ask(MotionRequest::GET_UP);
  EXPECT_EQ(motion(), MotionRequest::GET_UP);
  obey_.pass(10);
  EXPECT_EQ(motion(), MotionRequest::GET_UP);
}

TEST_F(ObeyTest, itsStateIsSentWithTheTimeSinceWhenItLasts) {
  obey_.pass(1);
  motion();
  const auto* state = obey_.sent(robotlink::kBehaviorState);
  ASSERT_NE(state, nullptr);
  EXPECT_EQ(state->solution(), "obey");
  EXPECT_EQ(state->state(), "stand");
  EXPECT_EQ(state->seconds(), 0);
  obey_.pass(2);
  motion();
  EXPECT_NEAR(obey_.sent(robotlink::kBehaviorState)->seconds(), 2, 1e-6);
  ask(MotionRequest::GET_UP);
  motion();
  state = obey_.sent(robotlink::kBehaviorState);
  EXPECT_EQ(state->state(), "obey");
  EXPECT_EQ(state->seconds(), 0);
  EXPECT_EQ(state->since().seconds(), state->timestamp().seconds());
}

}  // namespace
}  // namespace modules
