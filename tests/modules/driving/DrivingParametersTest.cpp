// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of driving and of obstacle avoidance: built-in values, and 0 as a value.
#include <gtest/gtest.h>

#include "DrivingParameters.pb.h"
#include "modules/driving/DynamicWindow.h"
#include "modules/driving/PathFollower.h"
#include "modules/driving/Wanderer.h"
#include "tests/modules/ParametersOf.h"
#include "tests/modules/driving/RollingPackages.h"

namespace modules {
namespace {

using robotcontrol::DynamicWindowParameters;
using robotcontrol::FollowPathParameters;
using robotcontrol::VectorFieldParameters;
using robotcontrol::WanderParameters;

TEST(DrivingParameters, withoutAFileAViewIsToldTheBuiltInValues) {
  const ParametersOf<WanderParameters> wander("driving", "wander");
  EXPECT_EQ("", namesOfUnset(wander.defaults()));
  EXPECT_EQ(Wanderer::Options{}.speed, wander.defaults().speed());
  EXPECT_EQ(Wanderer::Options{}.novelty, wander.values().novelty());
  const ParametersOf<FollowPathParameters> follow("driving", "follow-path");
  EXPECT_EQ("", namesOfUnset(follow.defaults()));
  EXPECT_EQ(PathFollower::Options{}.lookAhead, follow.defaults().look_ahead());
  EXPECT_EQ(
      "", namesOfUnset(ParametersOf<VectorFieldParameters>("obstacle-avoidance", "vector-field").defaults()));
  const ParametersOf<DynamicWindowParameters> window("obstacle-avoidance", "dynamic-window");
  EXPECT_EQ("", namesOfUnset(window.defaults()));
  EXPECT_EQ(DynamicWindow::Options{}.rotations, window.defaults().rotations());
}

TEST(DrivingParameters, whatAFileSaysIsTheDefaultAndTheRestIsBuiltIn) {
  ParametersOf<WanderParameters> wander("driving", "wander", "speed: 0.2\nnovelty: 0\n");
  EXPECT_EQ(0.2, wander.defaults().speed());
  EXPECT_TRUE(wander.defaults().has_novelty());
  EXPECT_EQ(0, wander.defaults().novelty());
  EXPECT_EQ(Wanderer::Options{}.room, wander.defaults().room());
  WanderParameters values;
  values.set_speed(0.1);
  EXPECT_EQ("", wander.set(values));
  EXPECT_EQ(0.1, wander.values().speed());
  EXPECT_EQ(Wanderer::Options{}.novelty, wander.values().novelty());
  EXPECT_EQ(0.2, wander.defaults().speed());
}

TEST(DrivingParameters, zeroIsRefusedWithAReasonWhereItMakesNoSense) {
  ParametersOf<FollowPathParameters> follow("driving", "follow-path");
  FollowPathParameters values = follow.values();
  values.set_look_ahead(0);
  EXPECT_EQ("'look_ahead' has to be more than 0", follow.set(values));
  EXPECT_EQ(PathFollower::Options{}.lookAhead, follow.values().look_ahead());
  values = follow.values();
  values.set_speed(-0.1);
  EXPECT_EQ("'speed' has to be at least 0", follow.set(values));
  ParametersOf<DynamicWindowParameters> window("obstacle-avoidance", "dynamic-window");
  DynamicWindowParameters samples = window.values();
  samples.set_speeds(51);
  EXPECT_EQ("'speeds' has to be between 1 and 50", window.set(samples));
}

TEST(DrivingParameters, whatMakesNoSenseInAnOlderFileOrLogMeansTheBuiltInValueAsItDid) {
  ParametersOf<FollowPathParameters> follow("driving", "follow-path",
                                            "look_ahead: 0\nspeed: -1\nbraking: 0.3\n");
  EXPECT_EQ(PathFollower::Options{}.lookAhead, follow.values().look_ahead());
  EXPECT_EQ(PathFollower::Options{}.speed, follow.defaults().speed());
  EXPECT_EQ(0.3, follow.values().braking());
  FollowPathParameters logged;
  logged.set_speed(0.4);
  logged.set_near(-1);
  EXPECT_EQ("", follow.restore(logged));
  EXPECT_EQ(0.4, follow.values().speed());
  EXPECT_EQ(PathFollower::Options{}.near, follow.values().near());
}

TEST(DrivingParameters, aRobotThatShallWanderAtSpeedZeroStandsOrTurns) {
  const FlatWorld world(roomMap(8, 6));
  RollingRobot robot(world, {.start = {4, 3, 0}, .laser = false});
  OneSolution wander("driving", "wander", OneSolution::Robot(), [](google::protobuf::Message& parameters) {
    static_cast<WanderParameters&>(parameters).set_speed(0);
  });
  for (int i = 0; i < 30; ++i) {
    robot.drive({});
    wander.pass();
    sense(wander, robot, false);
    wander.execute();
    ASSERT_NE(nullptr, wander.sent(robotlink::kBehaviorDrive));
    EXPECT_EQ(0, wander.sent(robotlink::kBehaviorDrive)->velocity().x());
  }
}

}  // namespace
}  // namespace modules
