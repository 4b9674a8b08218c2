// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/TrueState.h"

#include <gmock/gmock.h>

#include "app/platforms/simulated/SimulatedRun.h"
#include "robotcontrol/Perception.pb.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

using robotcontrol::RobotState;

class TrueStateTest : public testing::Test {
 protected:
  TrueStateTest() {
    RunOptions options = defaultSimulation();
    options.solutions["behavior"] = "stand";
    auto made = SimulatedRun::create(std::move(options), {});
    EXPECT_TRUE(made);
    run_ = std::move(*made);
    run(0.5);
  }
  void run(double seconds) {
    const robotlink::Instant end = run_->world().clock().now() + robotlink::fromSeconds(seconds);
    while (run_->world().clock().now() < end) run_->step();
  }
  simcore::Simulation& simulation() { return run_->world().simulation(); }
  RobotState state() { return trueState(simulation(), "red1"); }
  /// Puts the robot up in the air, tilted, or down.
  void place(double height, double roll, double pitch) {
    ASSERT_TRUE(simulation().placeModel("red1", {-0.5, 0.5, 0}, simcore::ModelPosture{height, roll, pitch}));
    run(0.016);
  }

  std::unique_ptr<SimulatedRun> run_;
};

TEST_F(TrueStateTest, aStandingRobotTouchesNothingButTheFloor) {
  EXPECT_FALSE(state().picked_up());
  EXPECT_FALSE(state().fallen());
  EXPECT_EQ(state().side(), RobotState::UPRIGHT);
  EXPECT_EQ(state().collisions_size(), 0);
  EXPECT_FALSE(trueState(simulation(), "nobody").fallen());
}

TEST_F(TrueStateTest, aRobotInTheAirIsPickedUpAndATiltedOneHasFallen) {
  place(0.4, 0, 0);
  EXPECT_TRUE(state().picked_up());
  EXPECT_FALSE(state().fallen());
  for (const auto& [roll, pitch, side] :
       {std::tuple(-1.6, 0.0, RobotState::ON_LEFT), std::tuple(1.6, 0.0, RobotState::ON_RIGHT),
        std::tuple(0.0, 1.6, RobotState::ON_NOSE), std::tuple(0.0, -1.6, RobotState::ON_TAIL),
        std::tuple(3.1, 0.0, RobotState::ON_BACK)}) {
    place(0.4, roll, pitch);
    EXPECT_TRUE(state().fallen());
    EXPECT_EQ(state().side(), side) << roll << " " << pitch;
  }
}

TEST_F(TrueStateTest, legsThatAreAtAWallHaveCollided) {
  ASSERT_TRUE(simulation().placeModel("red1", {-0.5, 1.15, 0}));
  std::set<std::string> parts;
  for (int i = 0; i < 100 && parts.empty(); ++i) {
    ASSERT_TRUE(simulation().throwModel("red1", {0, 0.5, 0}, {0, 0, 0}));
    run(0.008);
    const RobotState now = state();
    parts.insert(now.collisions().begin(), now.collisions().end());
  }
  EXPECT_THAT(parts, testing::Contains(testing::AnyOf("front left", "hind left")));
  EXPECT_THAT(parts, testing::Each(testing::Not(testing::EndsWith("right"))));
}

TEST(TrueStateOnATableTest, aHopIsNotBeingPickedUp) {
  const TestFolder folder;
  const auto scene = simcore::Scene::load(folder.write(
      "world.sdf",
      "<sdf version='1.9'><world name='w'><include><uri>model://ground_plane</uri></include>"
      "<model name='table'><static>true</static><pose>0 0 0.2 0 0 0</pose><link name='top'>"
      "<collision name='c'><geometry><box><size>1 1 0.4</size></box></geometry></collision></link></model>"
      "<include><uri>model://ers210</uri><pose>0 0 0.5136 0 0 0</pose></include></world></sdf>"));
  ASSERT_TRUE(scene) << robotlink::describe(scene.error());
  const auto simulation = std::move(simcore::Simulation::create(*scene, {.seed = 1, .noise = false}).value());
  const auto wasPickedUp = [&](double speed) {
    EXPECT_TRUE(simulation->throwModel("ers210", {0, 0, speed}, {0, 0, 0}));
    bool isUp = false, flies = false;
    for (int i = 0; i < 10; ++i) {
      simulation->step();
      flies = flies || simulation->heightInAir("ers210") > 0;
      isUp = isUp || trueState(*simulation, "ers210").picked_up();
    }
    EXPECT_TRUE(flies);
    return isUp;
  };
  for (int i = 0; i < 100; ++i) simulation->step();
  EXPECT_FALSE(wasPickedUp(0.2));
  EXPECT_TRUE(wasPickedUp(1.5));
}

}  // namespace
}  // namespace app
