// SPDX-License-Identifier: GPL-3.0-or-later
// The ball of a simulation is the one that the scene says it is, whatever it is called.
#include <gmock/gmock.h>

#include "app/platforms/SceneMessages.h"
#include "app/platforms/simulated/BallTrials.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Packages.h"
#include "simcore/Scene.h"
#include "tests/TestFolder.h"
#include "tests/app/Requests.h"
#include "tests/app/SimulatedRuns.h"

namespace app {
namespace {

using robotlink::kOracleWorld;

/// The shipped scene with a ball of another name.
std::filesystem::path sceneWithOrange(const TestFolder& folder) {
  std::string text = robotlink::readFile(robotlink::resource("scenes/field2002.sdf")).value();
  const std::string ball = "<uri>model://ball</uri>";
  text.insert(text.find(ball) + ball.size(), "<name>orange</name>");
  return folder.write("orange.sdf", text);
}

TEST(SceneBall, itsNameIsThatInTheScene) {
  const TestFolder folder;
  RunOptions options = test::simulationOptions();
  options.scene = sceneWithOrange(folder);
  options.solutions["ball-model"] = "oracle";
  robotcontrol::OracleWorld truth;
  SimulatedRun::Listeners listeners;
  listeners.queue = [&](const std::string&, const auto& queue) {
    for (const auto& message : queue->messages)
      if (const auto* world = message.template as<robotcontrol::OracleWorld>()) truth = *world;
  };
  const auto run = test::makeRun(options, listeners);
  ASSERT_NE(run, nullptr);
  EXPECT_THAT(movableModels(run->world().simulation()), testing::ElementsAre("red1", "orange"));
  ASSERT_TRUE(run->world().simulation().placeModel("orange", {1, 0.5, 0}));
  ASSERT_TRUE(run->request(test::keyRequest("red1", std::string("package/") + kOracleWorld.name)));
  test::play(*run, 0.5);
  EXPECT_NEAR(truth.ball_in_field().x(), 1, 0.05);
  EXPECT_NEAR(truth.ball_in_field().y(), 0.5, 0.05);

  BallTrials trials;
  trials.run = options;
  trials.count = 1;
  trials.seconds = 0.1;
  const auto played = trials.play();
  ASSERT_TRUE(played) << robotlink::describe(played.error());
  EXPECT_EQ(played->size(), 1U);
}

TEST(SceneBall, trialsNeedOne) {
  BallTrials trials;
  trials.run.scene = robotlink::resource("scenes/house.map");
  trials.run.robots = simcore::RobotsToAdd{.model = "burger", .count = 1};
  const auto played = trials.play();
  ASSERT_FALSE(played);
  EXPECT_EQ(played.error().front().id, "trials.no-ball");
}

}  // namespace
}  // namespace app
