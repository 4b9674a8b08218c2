// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/server/GripperControl.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/GripperState.h"

namespace robotlink::arcos {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(20);
constexpr int kOpen = 1, kClose = 2, kStop = 3, kLiftUp = 4, kStore = 7, kDeploy = 8, kHalt = 15;
constexpr int kPressure = 16, kCarry = 17;

TEST(GripperControl, opensUntilItsSwitchSaysSo) {
  GripperControl gripper;
  EXPECT_FALSE(gripper.obey(kOpen));
  EXPECT_EQ(gripper.step({}, kStep), (GripperCommand{1, 0, false}));
  EXPECT_TRUE(gripperState(gripper.state()).moving);
  EXPECT_EQ(gripper.switches() & 0x81, 0x81) << "moving, not open";
  EXPECT_EQ(gripper.step({.open = true}, kStep), (GripperCommand{0, 0, false}));
  EXPECT_TRUE(gripperState(gripper.state()).open);
  EXPECT_EQ(gripper.switches() & 0x81, 0);
}

TEST(GripperControl, graspsForItsTimeWhenBothPaddlesArePressed) {
  GripperControl gripper;
  EXPECT_TRUE(gripper.obey(kPressure));
  gripper.setValue(3);
  EXPECT_EQ(gripper.graspTime(), 3);
  gripper.obey(kClose);
  EXPECT_EQ(gripper.step({.leftPaddle = true}, kStep).paddles, -1) << "one paddle does not grasp";
  const GripperSensing both{.leftPaddle = true, .rightPaddle = true, .outerBeam = true, .innerBeam = true};
  EXPECT_EQ(gripper.step(both, kStep).paddles, -1);
  EXPECT_EQ(gripper.step(both, kStep).paddles, -1);
  EXPECT_EQ(gripper.step(both, kStep), (GripperCommand{0, 0, true}));
  EXPECT_TRUE(gripperState(gripper.state()).closed);
  EXPECT_EQ(gripper.switches() & 0x3C, 0x0C) << "both beams are broken, both paddles pressed";
  gripper.obey(kOpen);
  EXPECT_FALSE(gripper.step(both, kStep).grasps);
}

TEST(GripperControl, storingLiftsAfterItHasClosedAndDeployingLowersAtOnce) {
  GripperControl gripper;
  gripper.obey(kStore);
  EXPECT_EQ(gripper.step({.liftDown = true}, kStep), (GripperCommand{-1, 0, false}));
  EXPECT_EQ(gripper.step({.closed = true, .liftDown = true}, kStep), (GripperCommand{0, 1, false}));
  EXPECT_EQ(gripper.step({.closed = true, .liftUp = true}, kStep), (GripperCommand{0, 0, false}));
  EXPECT_TRUE(gripperState(gripper.state()).liftUp);
  gripper.obey(kDeploy);
  EXPECT_EQ(gripper.step({.closed = true, .liftUp = true}, kStep), (GripperCommand{1, -1, false}));
}

TEST(GripperControl, carryingLiftsForATime) {
  GripperControl gripper;
  EXPECT_TRUE(gripper.obey(kCarry));
  gripper.setValue(2);
  EXPECT_EQ(gripper.step({}, kStep).lift, 1);
  EXPECT_EQ(gripper.step({}, kStep).lift, 0);
}

TEST(GripperControl, stopsAndHaltsAndIgnoresWhatIsUnknown) {
  GripperControl gripper;
  gripper.obey(kClose);
  gripper.obey(kLiftUp);
  gripper.obey(kStop);
  EXPECT_EQ(gripper.step({}, kStep), (GripperCommand{0, 1, false}));
  gripper.obey(kHalt);
  EXPECT_EQ(gripper.step({}, kStep), (GripperCommand{0, 0, false}));
  for (const int wrong : {-1, 0, 9, 14, 18, 40000}) EXPECT_FALSE(gripper.obey(wrong)) << wrong;
  EXPECT_EQ(gripper.step({}, kStep), (GripperCommand{0, 0, false}));
  gripper.setValue(-5);
  EXPECT_EQ(gripper.graspTime(), 0);
  gripper.setValue(100000);
  EXPECT_EQ(gripper.graspTime(), 255);
}

}  // namespace
}  // namespace robotlink::arcos
