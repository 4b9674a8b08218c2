// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/world/TrueState.h"

#include <gmock/gmock.h>

#include "app/core/simulated/SimulatedRun.h"
#include "robotcontrol/Perception.pb.h"
#include "simcore/Simulation.h"

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

}  // namespace
}  // namespace app
