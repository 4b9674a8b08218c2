// SPDX-License-Identifier: GPL-3.0-or-later
// A simulation that goes on after its scene was edited.
#include <gmock/gmock.h>

#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "simcore/world/WorldDescription.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using robotlink::Vector3;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const char* const kChangedFloor =
    "<model name='floor'><static>true</static><link name='floor'><collision name='c'><geometry><plane>"
    "<normal>0 0 1</normal><size>9 9</size></plane></geometry></collision></link></model>";

std::string ball(const std::string& name, const std::string& pose, const std::string& link = "body") {
  return "<model name='" + name + "'><pose>" + pose + "</pose><link name='" + link +
         "'><inertial><mass>0.3</mass><inertia><ixx>0.0002</ixx><iyy>0.0002</iyy><izz>0.0002</izz></inertia>"
         "</inertial><collision name='c'><geometry><sphere><radius>0.05</radius></sphere></geometry>"
         "</collision></link></model>";
}

std::string box(const std::string& name, const std::string& pose) {
  return "<model name='" + name + "'><static>true</static><pose>" + pose +
         "</pose><link name='l'><collision name='c'><geometry><box><size>0.4 0.4 0.4</size></box></geometry>"
         "</collision></link></model>";
}

class SceneChangeTest : public testing::Test {
 protected:
  std::shared_ptr<const Scene> sceneOf(const std::string& contents) {
    auto scene = Scene::load(folder_.write("room.sdf", worldAround(kChangedFloor + contents)));
    EXPECT_TRUE(scene.has_value()) << (scene ? "" : robotlink::describe(scene.error()));
    return scene ? *scene : nullptr;
  }
  void start(const std::string& contents) {
    simulation_ = std::move(Simulation::create(sceneOf(contents), {.seed = 1, .noise = false}).value());
  }
  void run(int steps) {
    for (int i = 0; i < steps; ++i) simulation_->step();
  }
  Vector3 position(const std::string& model) const { return simulation_->modelPose(model)->translation(); }

  SceneFolder folder_;
  std::unique_ptr<Simulation> simulation_;
};

TEST_F(SceneChangeTest, aSnapshotPutsBackWhatTheEditedSceneStillHas) {
  const std::string stone = ball("stone", "0 0 1 0 0 0");
  start(stone + ball("pebble", "1 0 1 0 0 0") + ball("gone", "2 0 1 0 0 0"));
  run(50);
  const Vector3 before = position("stone");
  const Snapshot snapshot = simulation_->snapshot();
  run(100);
  const auto edited = sceneOf(stone + ball("pebble", "1 1 1 0 0 0") + ball("added", "3 0 0.05 0 0 0"));
  ASSERT_TRUE(simulation_->continueIn(edited).has_value());
  ASSERT_TRUE(simulation_->placeModel("added", {3, 1, 0}));
  run(10);
  const auto restored = simulation_->restore(snapshot);
  ASSERT_TRUE(restored) << restored.error().text;
  EXPECT_THAT(*restored, ElementsAre("pebble"));
  EXPECT_EQ(simulation_->steps(), 50U);
  EXPECT_EQ(position("stone"), before);
  EXPECT_NEAR(position("pebble").z(), 1, 1e-9);
  EXPECT_NEAR(position("added").y(), 1, 1e-3) << "what was added stays where it is";
  EXPECT_FALSE(simulation_->modelPose("gone"));
  run(50);
  EXPECT_LT(position("stone").z(), before.z() - 0.1) << "it goes on falling";
}

TEST_F(SceneChangeTest, aSnapshotLeavesTheCommandsAndChosenErrorsOfWhatWasAdded) {
  const std::string robot =
      "<include><uri>model://ers210</uri><name>dog</name><pose>0 0 0.1136 0 0 0</pose></include>";
  start(ball("stone", "1 0 1 0 0 0"));
  run(50);
  const Snapshot snapshot = simulation_->snapshot();
  ASSERT_TRUE(simulation_->continueIn(sceneOf(ball("stone", "1 0 1 0 0 0") + robot), {.otherPorts = true}));
  const std::string sensor = "dog/headPan/position";
  ASSERT_TRUE(simulation_->setSensorErrors(sensor, {.delay = 0.1}));
  ASSERT_TRUE(simulation_->write("dog/headPan/request", std::vector<double>{0.8}));
  run(400);
  ASSERT_NEAR(simulation_->read(sensor).value()[0], 0.8, 0.02);
  ASSERT_TRUE(simulation_->restore(snapshot));
  EXPECT_EQ(simulation_->steps(), 50U);
  EXPECT_EQ(simulation_->sensorErrors(sensor)->delay, 0.1);
  run(400);
  EXPECT_NEAR(simulation_->read(sensor).value()[0], 0.8, 0.02) << "its servo still holds";
}

TEST_F(SceneChangeTest, anAddedDoorThatIsOpenClosesInTimeAlsoAfterGoingBack) {
  const std::string stone = ball("stone", "1 0 1 0 0 0");
  start(stone);
  run(50);
  const Snapshot snapshot = simulation_->snapshot();
  const std::string door =
      "<include><uri>model://sliding_door</uri><name>door</name><pose>3 3 0 0 0 0</pose></include>";
  ASSERT_TRUE(simulation_->continueIn(sceneOf(stone + door), {.otherPorts = true}));
  run(2000);
  simulation_->moveDoor(0, true);
  run(100);
  ASSERT_TRUE(simulation_->restore(snapshot));
  EXPECT_TRUE(simulation_->isDoorOpen(0));
  run(1000);
  EXPECT_FALSE(simulation_->isDoorOpen(0)) << "after its 3 s, not after those of the other run";
}

TEST_F(SceneChangeTest, aFileOfASnapshotOfAnEditedSceneIsRefusedWithWhatToDo) {
  start(ball("stone", "0 0 1 0 0 0"));
  const auto added = simulation_->scene().with(ModelToAdd{.model = "ers210", .place = {2, 0, 0}});
  ASSERT_TRUE(added);
  ASSERT_TRUE(simulation_->continueIn(*added, {.otherPorts = true}));
  const auto file = Snapshot::decode(simulation_->snapshot().encode(), "edited.snapshot");
  ASSERT_TRUE(file);
  EXPECT_TRUE(simulation_->restore(*file));
  start(ball("stone", "0 0 1 0 0 0"));
  const auto refused = simulation_->restore(*file);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text, HasSubstr("save an edited scene before"));
}

TEST_F(SceneChangeTest, aFallingModelGoesOnFalling) {
  const std::string falling = ball("stone", "0 0 1 0 0 0");
  start(falling);
  run(50);
  const double before = position("stone").z();
  const auto change = simulation_->continueIn(sceneOf(box("crate", "2 0 0.2 0 0 0") + falling));
  ASSERT_TRUE(change.has_value());
  EXPECT_THAT(change->putBack, IsEmpty());
  EXPECT_TRUE(change->hasSamePorts);
  EXPECT_EQ(simulation_->steps(), 50U);
  EXPECT_NEAR(position("stone").z(), before, 1e-9);
  run(1);
  // After 0.2 s of falling it has nearly 2 m/s.
  EXPECT_NEAR(before - position("stone").z(), 0.2 * 9.81 * 0.004, 0.001);
  EXPECT_TRUE(simulation_->modelPose("crate").has_value());
}

TEST_F(SceneChangeTest, anEditThatChangesNothingKeepsAllPoses) {
  const std::string falling = ball("stone", "0 0 0.2 0 0.3 0") + ball("other", "0.3 0 0.3 0 0 0");
  start(falling);
  run(30);
  const std::vector<Pose3> before(simulation_->bodyPoses().begin(), simulation_->bodyPoses().end());
  ASSERT_TRUE(simulation_->continueIn(sceneOf(falling)).has_value());
  const auto after = simulation_->bodyPoses();
  ASSERT_EQ(after.size(), before.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_TRUE(after[i].isApprox(before[i], 1e-9)) << i;
}

TEST_F(SceneChangeTest, aModelThatTheFilePutsElsewhereIsThere) {
  start(ball("stone", "0 0 1 0 0 0") + ball("other", "1 0 1 0 0 0"));
  run(20);
  const auto change =
      simulation_->continueIn(sceneOf(ball("stone", "0 0.5 2 0 0 0") + ball("other", "1 0 1 0 0 0")));
  ASSERT_TRUE(change.has_value());
  EXPECT_THAT(change->putBack, ElementsAre("stone"));
  EXPECT_NEAR(position("stone").z(), 2, 1e-9);
  EXPECT_LT(position("other").z(), 0.99);
}

TEST_F(SceneChangeTest, aModelWithOtherLinksBeginsAnew) {
  start(ball("stone", "0 0 1 0 0 0"));
  run(20);
  const auto change = simulation_->continueIn(sceneOf(ball("stone", "0 0 1 0 0 0", "core")));
  ASSERT_TRUE(change.has_value());
  EXPECT_THAT(change->putBack, ElementsAre("stone"));
  EXPECT_NEAR(position("stone").z(), 1, 1e-9);
}

TEST_F(SceneChangeTest, aModelThatWouldBeInsideANewOneIsPutBack) {
  const std::string falling = ball("stone", "0 0 1 0 0 0");
  start(falling);
  run(250);
  ASSERT_NEAR(position("stone").z(), 0.05, 0.01);
  const auto change = simulation_->continueIn(sceneOf(box("crate", "0 0 0.2 0 0 0") + falling));
  ASSERT_TRUE(change.has_value());
  EXPECT_THAT(change->putBack, ElementsAre("stone"));
  EXPECT_NEAR(position("stone").z(), 1, 1e-9);
}

TEST_F(SceneChangeTest, aSceneThatCannotStartChangesNothing) {
  // Only robots and balls must not start inside of others.
  std::string stone = ball("stone", "0 0 1 0 0 0");
  stone.insert(stone.find("<pose>"), "<robotcontrol:ball>true</robotcontrol:ball>");
  start(stone);
  run(10);
  const std::uint64_t before = simulation_->digest();
  EXPECT_FALSE(simulation_->continueIn(sceneOf(box("crate", "0 0 0.9 0 0 0") + stone)).has_value());
  EXPECT_EQ(simulation_->digest(), before);
  EXPECT_FALSE(simulation_->modelPose("crate").has_value());
}

TEST_F(SceneChangeTest, servosKeepWhatWasRequested) {
  auto simulation = std::move(Simulation::create(shippedScene(), {.seed = 1, .noise = false}).value());
  const auto servos = simulation->servos();
  const auto pan = static_cast<std::size_t>(
      std::ranges::find(servos, "red1/headPan/request", [](const Servo& one) { return one.info.path; }) -
      servos.begin());
  simulation->requestAngle(pan, 0.8);
  for (int i = 0; i < 20; ++i) simulation->step();
  const auto same = Scene::load(shippedScene()->file());
  ASSERT_TRUE(same.has_value());
  const auto change = simulation->continueIn(*same);
  ASSERT_TRUE(change.has_value());
  EXPECT_TRUE(change->hasSamePorts);
  for (int i = 0; i < 400; ++i) simulation->step();
  const auto sensors = simulation->sensors();
  const auto angle = std::ranges::find(sensors, "red1/headPan/position",
                                       [](const Sensor& sensor) { return sensor.info.path; });
  ASSERT_NE(angle, sensors.end());
  EXPECT_NEAR(angle->values[0], 0.8, 0.02);
}

TEST_F(SceneChangeTest, withOtherSensorsOnlyAnotherSimulationCanGoOn) {
  start(ball("stone", "0 0 1 0 0 0"));
  run(20);
  const std::uint64_t before = simulation_->digest();
  const auto wider =
      sceneOf(replaced(ball("stone", "0 0 1 0 0 0"), "</link>",
                       "<sensor name='imu' type='imu'><always_on>true</always_on></sensor></link>"));
  const auto change = simulation_->continueIn(wider);
  ASSERT_TRUE(change.has_value());
  EXPECT_FALSE(change->hasSamePorts);
  EXPECT_EQ(simulation_->digest(), before);
  const auto next = std::move(Simulation::create(wider, {.seed = 1, .noise = false}).value());
  EXPECT_THAT(next->continueFrom(*simulation_), IsEmpty());
  EXPECT_NEAR(next->modelPose("stone")->translation().z(), position("stone").z(), 1e-9);
  EXPECT_EQ(next->steps(), 20U);
}

TEST_F(SceneChangeTest, aModelThatIsAddedHasToFitBetweenThoseThatAreThereNow) {
  start(ball("stone", "0 0 0.05 0 0 0") + box("crate", "2 0 0.2 0 0 0"));
  run(10);
  const auto& stone = simulation_->scene().world().models[1];
  ModelInstance other = stone;
  other.name = "other";
  const auto inside = simulation_->scene().with(other, 99);
  ASSERT_TRUE(inside.has_value());
  const auto refused = simulation_->continueIn(*inside, {.otherPorts = true, .fitsNow = true});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().id, "scene.no-room");
  EXPECT_FALSE(simulation_->modelPose("other").has_value());
  other.poseInWorld.translation().x() = 1;
  const auto beside = simulation_->scene().with(other, 99);
  ASSERT_TRUE(simulation_->continueIn(*beside, {.otherPorts = true, .fitsNow = true}).has_value());
  EXPECT_EQ(simulation_->steps(), 10U);
  EXPECT_NEAR(position("other").x(), 1, 1e-9);
}

TEST_F(SceneChangeTest, whereSomethingStartedIsNotInTheWayWhenItHasMoved) {
  std::string stone = ball("stone", "0 0 0.05 0 0 0");
  stone.insert(stone.find("<pose>"), "<robotcontrol:ball>true</robotcontrol:ball>");
  start(stone);
  run(10);
  const auto crate = sceneOf(stone + box("crate", "0 0 0.2 0 0 0"));
  EXPECT_FALSE(simulation_->continueIn(crate, {.fitsNow = true}).has_value()) << "it is still there";
  ASSERT_TRUE(simulation_->placeModel("stone", {2, 0, 0}).has_value());
  run(10);
  const auto change = simulation_->continueIn(crate, {.fitsNow = true});
  ASSERT_TRUE(change.has_value()) << change.error().text;
  EXPECT_THAT(change->putBack, IsEmpty());
  EXPECT_NEAR(position("stone").x(), 2, 1e-3);
}

TEST_F(SceneChangeTest, whatIsMovedHasToFitBetweenThoseThatAreThereNow) {
  const std::string stone = ball("stone", "0 0 0.05 0 0 0");
  start(stone + box("crate", "2 0 0.2 0 0 0"));
  run(10);
  const auto refused =
      simulation_->continueIn(sceneOf(stone + box("crate", "0.1 0 0.2 0 0 0")), {.fitsNow = true});
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().text,
            "there is no room for 'crate': it would be inside 'stone'; choose another place");
  EXPECT_NEAR(position("crate").x(), 2, 1e-9);
}

TEST_F(SceneChangeTest, aMotionIsOnlyThatOfTheSameModel) {
  const std::string stone = ball("stone", "0 0 1 0 0 0");
  start(stone);
  run(20);
  const auto motion = simulation_->motionOf("stone");
  const double height = position("stone").z();
  ASSERT_TRUE(simulation_->continueIn(sceneOf("")).has_value());
  ASSERT_TRUE(
      simulation_->continueIn(sceneOf(ball("stone", "1 0 1 0 0 0")), {.motions = {{"stone", motion}}}));
  EXPECT_NEAR(position("stone").z(), 1, 1e-9) << "its file puts it elsewhere";
  ASSERT_TRUE(simulation_->continueIn(sceneOf("")).has_value());
  ASSERT_TRUE(simulation_->continueIn(sceneOf(stone), {.motions = {{"stone", motion}}}));
  EXPECT_NEAR(position("stone").z(), height, 1e-9);
}

TEST_F(SceneChangeTest, aChangeCanBeTakenBackBeforeTheNextStep) {
  start(ball("stone", "0 0 1 0 0 0") + ball("other", "1 0 1 0 0 0"));
  run(20);
  const std::uint64_t before = simulation_->digest();
  const auto motion = simulation_->motionOf("other");
  const double height = position("other").z();
  const auto without = simulation_->scene().without("other");
  ASSERT_TRUE(without.has_value());
  ASSERT_TRUE(simulation_->continueIn(*without, {.otherPorts = true, .fitsNow = true}).has_value());
  EXPECT_NE(simulation_->digest(), before);
  simulation_->goBack();
  EXPECT_EQ(simulation_->digest(), before);
  ASSERT_TRUE(simulation_->continueIn(*without, {.otherPorts = true, .fitsNow = true}).has_value());
  run(5);
  simulation_->goBack();
  EXPECT_FALSE(simulation_->modelPose("other").has_value()) << "it went on meanwhile";
  const auto again = simulation_->scene().with(ModelInstance(simulation_->scene().world().models[1]), 1);
  EXPECT_FALSE(again.has_value()) << "its name is taken";
  ModelInstance back = (*simulation_->sharedScene()).world().models[1];
  back.name = "other";
  back.poseInWorld.translation().x() = 1;
  const auto with = simulation_->scene().with(back, 99);
  ASSERT_TRUE(with.has_value());
  ASSERT_TRUE(simulation_->continueIn(*with, {.fitsNow = true, .motions = {{"other", motion}}}).has_value());
  EXPECT_NEAR(position("other").z(), height, 1e-9) << "it falls on from where it was";
}

TEST_F(SceneChangeTest, namesOfAddedModelsAreFree) {
  start(ball("stone", "0 0 1 0 0 0") + ball("dog1", "1 0 1 0 0 0"));
  const Scene& scene = simulation_->scene();
  EXPECT_EQ(scene.freeName("crate", false), "crate");
  EXPECT_EQ(scene.freeName("stone", false), "stone1");
  EXPECT_EQ(scene.freeName("dog", true), "dog2");
  EXPECT_FALSE(scene.without("nobody").has_value());
  const auto unknown = scene.with(ModelToAdd{.model = "unicorn"});
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().front().id, "scene.unknown-model");
}

}  // namespace
}  // namespace simcore
