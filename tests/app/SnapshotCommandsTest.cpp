// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots, going back and hands in runs of the simulation, with and without robots.
#include <gmock/gmock.h>

#include "app/core/Workbench.h"
#include "app/platforms/simulated/SimulatedRun.h"
#include "app/platforms/simulated/SimulationFeed.h"
#include "foxglove/Geometry.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "tests/TestFolder.h"
#include "tests/app/TickUntil.h"

using namespace app;
using robotcontrol::Request;
using robotcontrol::SimulationStatus;
using testing::HasSubstr;

namespace {

/// A world without any robot: a ball that rolls on a floor.
const char* const kWithoutRobots = R"(<sdf version="1.9"><world name="empty">
<model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane><normal>0 0 1</normal>
  <size>20 20</size></plane></geometry></collision></link></model>
<model name="stone"><pose>0 0 0.5 0 0 0</pose><link name="body"><inertial><mass>1</mass><inertia><ixx>0.01</ixx>
  <iyy>0.01</iyy><izz>0.01</izz></inertia></inertial><collision name="c"><geometry><sphere><radius>0.1</radius></sphere>
  </geometry></collision></link></model></world></sdf>)";

std::unique_ptr<SimulatedRun> runOf(RunOptions options = defaultSimulation()) {
  auto run = SimulatedRun::create(std::move(options), {});
  EXPECT_TRUE(run) << robotlink::describe(run.error());
  return run ? std::move(*run) : nullptr;
}

void stepRun(SimulatedRun& run, int steps) {
  for (int i = 0; i < steps; ++i) run.step();
}

Request placeBall(double x) {
  Request request;
  request.mutable_place_model()->set_model("ball");
  request.mutable_place_model()->mutable_pose_in_field()->set_x(x);
  return request;
}

}  // namespace

TEST(SnapshotsOfRuns, programsComeToTheSameStateByRunningAgain) {
  const auto run = runOf();
  ASSERT_TRUE(run);
  stepRun(*run, 20);
  ASSERT_TRUE(run->changeWorld(placeBall(0.4)));
  Request walk;
  walk.set_robot("red1");
  walk.mutable_motion()->mutable_motion()->set_kind(robotcontrol::MotionRequest::WALK);
  walk.mutable_motion()->mutable_motion()->mutable_walk()->set_x(0.1);
  ASSERT_TRUE(run->request(walk));
  stepRun(*run, 20);
  const simcore::Snapshot snapshot = run->snapshot();
  stepRun(*run, 15);
  const std::uint64_t later = run->world().digest();
  ASSERT_TRUE(run->runAgain(snapshot));
  while (run->ranAgain()) run->step();
  EXPECT_EQ(run->takeRunAgainOutcome(), "");
  EXPECT_EQ(run->world().simulation().steps(), snapshot.step);
  stepRun(*run, 15);
  EXPECT_EQ(run->world().digest(), later) << "the programs do the same as before";
}

TEST(SnapshotsOfRuns, itIsSaidWhyProgramsCannotBeRunAgain) {
  const auto run = runOf();
  ASSERT_TRUE(run);
  stepRun(*run, 3);
  const simcore::Snapshot early = run->snapshot();
  ASSERT_TRUE(run->restore(early));
  const auto refused = run->runAgain(run->snapshot());
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("without the programs"));
  EXPECT_TRUE(run->runAgain(early)) << "that one was taken before";
  run->stopRunningAgain();
  RunOptions quiet = defaultSimulation();
  quiet.world.noise = false;
  const auto other = runOf(quiet);
  const auto different = other->runAgain(early);
  ASSERT_FALSE(different);
  EXPECT_THAT(different.error().text, HasSubstr("noise: on"));
  EXPECT_THAT(different.error().text, HasSubstr("noise: off"));
  EXPECT_TRUE(other->restore(early)) << "but the world can be put there";
}

TEST(SnapshotsOfRuns, inAnEditedSceneTheWorldIsPutBackAsFarAsItIsThere) {
  const auto run = runOf();
  ASSERT_TRUE(run);
  stepRun(*run, 20);
  const simcore::Snapshot snapshot = run->snapshot();
  const auto ball = run->world().simulation().modelPose("ball")->translation();
  ASSERT_TRUE(run->addModel({.model = "burger", .place = {1, 0.6, 0}}));
  ASSERT_TRUE(run->changeWorld(placeBall(0.7)));
  stepRun(*run, 10);
  const auto again = run->runAgain(snapshot);
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().text, HasSubstr("the scene was changed"));
  const auto restored = run->restore(snapshot);
  ASSERT_TRUE(restored) << restored.error().text;
  EXPECT_TRUE(restored->empty());
  EXPECT_EQ(run->world().simulation().steps(), snapshot.step);
  EXPECT_EQ(run->world().simulation().modelPose("ball")->translation(), ball);
  EXPECT_TRUE(run->world().simulation().modelPose("burger1"));
  stepRun(*run, 20);
  EXPECT_EQ(run->world().simulation().steps(), snapshot.step + 40);
}

TEST(SnapshotsOfRuns, inAnEditedSceneCamerasLightAndHeldActuatorsArePutBackToo) {
  const auto run = runOf();
  ASSERT_TRUE(run);
  SimulatedWorld& world = run->world();
  ASSERT_EQ(world.simulation().cameras().size(), 1U);
  world.cameraSetting(0).exposure = 0.5;
  ASSERT_TRUE(world.setLighting({.brightness = 0.7}));
  ASSERT_TRUE(world.held().hold(world.simulation(), "red1/headPan/request", {0.4}));
  const simcore::Snapshot snapshot = run->snapshot();
  ASSERT_TRUE(run->addModel({.model = "ers210", .place = {0.8, 0.3, 3}, .team = "blue"}));
  ASSERT_EQ(world.simulation().cameras().size(), 2U);
  world.cameraSetting(0).exposure = 1;
  world.cameraSetting(1).gain = 3;
  ASSERT_TRUE(world.setLighting({}));
  ASSERT_TRUE(world.held().hold(world.simulation(), "red1/headPan/request", {-0.2}));
  ASSERT_TRUE(world.held().hold(world.simulation(), "red1/legFL1/request", {0}));
  ASSERT_TRUE(world.held().hold(world.simulation(), "blue1/headPan/request", {0.1}));
  ASSERT_TRUE(run->restore(snapshot));
  EXPECT_EQ(world.cameraSetting(0).exposure, 0.5);
  EXPECT_EQ(world.cameraSetting(1).gain, 3) << "what was added stays as it is";
  EXPECT_EQ(world.options().lighting.brightness, 0.7);
  const auto& held = world.held().all();
  ASSERT_EQ(held.size(), 2U);
  EXPECT_EQ(held.at("red1/headPan/request").values, std::vector<double>{0.4});
  EXPECT_EQ(held.at("blue1/headPan/request").values, std::vector<double>{0.1});
}

TEST(SnapshotsOfRuns, theClockOfProgramsGoesOnWhereTheWorldGoesBack) {
  RunOptions options = defaultSimulation();
  options.world.rewindBytes = std::size_t{64} << 20U;
  const auto run = runOf(options);
  ASSERT_TRUE(run);
  stepRun(*run, 50);
  const auto time = run->world().clock().now();
  ASSERT_TRUE(run->rewind(std::chrono::milliseconds(200)));
  EXPECT_EQ(run->world().simulation().steps(), 50U);
  EXPECT_EQ(run->world().clock().now(), time);
  stepRun(*run, 1);
  EXPECT_EQ(run->world().clock().now(), time + SimulatedWorld::kStep);
  EXPECT_FALSE(run->rewind(std::chrono::seconds(9)));
}

TEST(SnapshotsOfRuns, aSceneWithoutRobotsRunsAndIsRestored) {
  const TestFolder folder;
  RunOptions options = defaultSimulation();
  options.scene = folder.write("empty.sdf", kWithoutRobots);
  const auto run = runOf(options), other = runOf(options);
  ASSERT_TRUE(run && other);
  stepRun(*run, 30);
  const auto snapshot = run->snapshot();
  stepRun(*run, 30);
  ASSERT_TRUE(other->restore(snapshot));
  EXPECT_EQ(other->world().clock().now().time_since_epoch(), std::chrono::milliseconds(240));
  stepRun(*other, 30);
  EXPECT_EQ(other->world().digest(), run->world().digest());
  ASSERT_TRUE(run->runAgain(snapshot)) << "there are no programs, so the world is restored";
  EXPECT_FALSE(run->ranAgain());
}

namespace {

/// A workbench with a scene without robots.
class SnapshotCommandsTest : public testing::Test {
 protected:
  SnapshotCommandsTest() : workbench(folder.path() / "user") {
    workbench.onErrors([this](const robotlink::Errors& e) { errors = e; });
    RunOptions options = defaultSimulation();
    options.scene = folder.write("empty.sdf", kWithoutRobots);
    workbench.open(SimulationFeed::opening(options));
    EXPECT_TRUE(waitFor([this] { return workbench.loaded() != nullptr && status() != nullptr; }));
  }
  template <typename Condition>
  bool waitFor(Condition condition) {
    return app::test::tickUntil(workbench, condition);
  }
  template <typename Message>
  const Message* latest(const char* stream) {
    return workbench.session().store().latestAs<Message>(stream, workbench.session().timeline().newest());
  }
  const SimulationStatus* status() { return latest<SimulationStatus>("simulation"); }
  void run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    EXPECT_TRUE(done.has_value()) << line << ": " << (done ? "" : done.error().describe());
  }
  void steps(int count) {
    const std::uint64_t before = status()->steps();
    for (int i = 0; i < count; ++i) run("simulation.step");
    ASSERT_TRUE(waitFor([&] { return status()->steps() == before + 2 * static_cast<std::uint64_t>(count); }));
  }

  TestFolder folder;
  robotlink::Errors errors;
  Workbench workbench;
};

}  // namespace

TEST_F(SnapshotCommandsTest, aSnapshotIsTakenAndRestoredByName) {
  steps(3);
  run("simulation.snapshot early");
  ASSERT_TRUE(waitFor([this] { return status()->snapshots_size() == 1; }));
  EXPECT_EQ(status()->snapshots(0).name(), "early");
  EXPECT_NEAR(status()->snapshots(0).time(), 0.024, 1e-9);
  steps(4);
  run("simulation.restore early");
  ASSERT_TRUE(waitFor([this] { return status()->steps() == 6; }));
  EXPECT_NEAR(status()->world_time(), 0.024, 1e-9);
  EXPECT_NEAR(status()->time(), 0.056, 1e-9) << "the time of messages goes on";
  run("simulation.forget early");
  ASSERT_TRUE(waitFor([this] { return status()->snapshots_size() == 0; }));
  run("simulation.restore early");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_THAT(errors.front().text, HasSubstr("early"));
}

TEST_F(SnapshotCommandsTest, aSnapshotIsAFileWhereItsNameIsOne) {
  steps(2);
  const std::string file = (folder.path() / "a.snapshot").string();
  run("simulation.snapshot '" + file + "'");
  ASSERT_TRUE(waitFor([&] { return std::filesystem::exists(file); }));
  steps(2);
  run("simulation.restore '" + file + "' --programs on");
  EXPECT_TRUE(waitFor([this] { return status()->steps() == 4; }));
  folder.write("broken.snapshot", "RCSNAP");
  run("simulation.restore '" + (folder.path() / "broken.snapshot").string() + "'");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_THAT(errors.front().text, HasSubstr("broken.snapshot"));
}

TEST_F(SnapshotCommandsTest, thePausedSimulationIsRewound) {
  steps(10);
  EXPECT_NEAR(status()->rewindable(), 0.08, 1e-9);
  run("simulation.rewind 0.024");
  ASSERT_TRUE(waitFor([this] { return std::abs(status()->world_time() - 0.056) < 1e-9; }));
  run("simulation.rewind 5");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_THAT(errors.front().text, HasSubstr("go back"));
  EXPECT_FALSE(workbench.commands().runLine("simulation.rewind -1"));
}

TEST_F(SnapshotCommandsTest, handsMoveWhatIsInAScene) {
  run("scene.pin stone");
  ASSERT_TRUE(waitFor([this] { return status()->pinned_size() == 1; }));
  EXPECT_EQ(status()->pinned(0), "stone/link:body");
  run("scene.pin stone off");
  ASSERT_TRUE(waitFor([this] { return status()->pinned_size() == 0; }));
  run("scene.drag stone 1 0 1");
  ASSERT_TRUE(waitFor([this] { return status()->dragged_size() == 1; }));
  run("scene.drop");
  ASSERT_TRUE(waitFor([this] { return status()->dragged_size() == 0; }));
  run("scene.throw stone 1 0 2");
  run("scene.turn stone 0.5");
  run("scene.push stone 1 0 0 --seconds 0.1");
  run("scene.throw rock 1 0 0");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_THAT(errors.front().text, HasSubstr("rock"));
  EXPECT_FALSE(workbench.commands().runLine("scene.throw stone 1000 0 0")) << "too fast";
}

TEST_F(SnapshotCommandsTest, forcesArePublishedWhileSomebodyReadsThem) {
  using robotcontrol::WorldForces;
  steps(60);
  ASSERT_NE(latest<WorldForces>("forces"), nullptr);
  EXPECT_EQ(latest<WorldForces>("forces")->contacts_size(), 0) << "nobody reads them";
  Request request;
  request.mutable_read_forces()->set_seconds(60);
  workbench.session().request(request);
  steps(1);
  ASSERT_TRUE(waitFor([&] { return latest<WorldForces>("forces")->contacts_size() > 0; }));
  const auto& contact = latest<WorldForces>("forces")->contacts(0);
  EXPECT_THAT(contact.first() + contact.second(), HasSubstr("ground"));
  EXPECT_NEAR(std::abs(contact.force().z()), 9.81, 3);
}
