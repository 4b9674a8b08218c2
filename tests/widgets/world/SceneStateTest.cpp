// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/world/SceneState.h"

#include <gtest/gtest.h>

#include "foxglove/Geometry.pb.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/widgets/streams/StoredMessages.h"

namespace widgets::test {
namespace {

using Names = std::vector<std::string>;

void addEntity(foxglove::SceneUpdate& update, const char* id, const char* model,
               const char* frame = "field") {
  auto& entity = *update.add_entities();
  entity.set_id(id);
  entity.set_frame_id(frame);
  if (*model == 0) return;
  auto& pair = *entity.add_metadata();
  pair.set_key("model");
  pair.set_value(model);
}

class SceneStateTest : public testing::Test {
 protected:
  void update(double time = 100) { scene.update(stored.store, atSeconds(time)); }
  void addTransform(const char* child, const char* parent, double x, double y = 0) {
    auto& transform = *transforms.add_transforms();
    transform.set_child_frame_id(child);
    transform.set_parent_frame_id(parent);
    transform.mutable_translation()->set_x(x);
    transform.mutable_translation()->set_y(y);
  }
  /// Where a frame is along x; -1000 if it is nowhere.
  double xOf(const char* frame, const char* robot = "") const {
    const auto pose = scene.framePose(frame, robot);
    return pose ? pose->translation().x() : -1000;
  }
  Names ids() const {
    Names all;
    for (const auto& [id, item] : scene.items()) all.push_back(id);
    return all;
  }

  StoredMessages stored;
  foxglove::FrameTransforms transforms;
  SceneState scene;
};

TEST_F(SceneStateTest, entitiesStayUntilTheyAreReplacedOrDeleted) {
  foxglove::SceneUpdate first, second, third;
  addEntity(first, "a", "box");
  addEntity(first, "b", "");
  second.add_deletions()->set_id("a");
  second.add_deletions()->set_id("unknown");
  addEntity(second, "b", "ball");
  addEntity(second, "c", "");
  third.add_deletions()->set_type(foxglove::SceneEntityDeletion::ALL);
  addEntity(third, "d", "");
  stored.add("scene", 1, first);
  stored.add("scene", 2, second);
  stored.add("scene", 3, third);
  update(1.5);
  EXPECT_EQ(ids(), (Names{"a", "b"}));
  update(2);
  EXPECT_EQ(ids(), (Names{"b", "c"}));
  EXPECT_EQ(scene.items().at("b").model, "ball");
  update(10);
  EXPECT_EQ(ids(), Names{"d"}) << "what came before the deletion is gone";
  update(1);
  EXPECT_EQ(ids(), (Names{"a", "b"})) << "the timeline may go back";
}

TEST_F(SceneStateTest, beforeTheHistoryTheOldestSceneCounts) {
  foxglove::SceneUpdate first, second;
  addEntity(first, "a", "");
  addEntity(second, "b", "");
  stored.add("scene", 5, first);
  stored.add("scene", 6, second);
  update(1);
  EXPECT_EQ(ids(), Names{"a"});
}

TEST_F(SceneStateTest, withoutAnySceneThereIsNothing) {
  update();
  EXPECT_TRUE(scene.items().empty());
  EXPECT_TRUE(scene.models().empty());
  EXPECT_EQ(xOf(""), 0) << "the field is where it is";
  EXPECT_EQ(xOf("field"), 0);
  EXPECT_EQ(xOf("red1"), -1000);
  EXPECT_FALSE(scene.modelPose("ball"));
  EXPECT_FALSE(scene.modelPose(""));
}

TEST_F(SceneStateTest, parentsMayFollowTheirChildren) {
  addTransform("red1/head", "red1", 0.5);
  addTransform("red1/camera", "red1/head", 0.25);
  addTransform("red1", "field", 2);
  stored.add("transforms", 1, transforms);
  update();
  EXPECT_DOUBLE_EQ(xOf("red1"), 2);
  EXPECT_DOUBLE_EQ(xOf("red1/camera"), 2.75);
}

TEST_F(SceneStateTest, framesWithoutAWayToTheFieldAreNowhere) {
  addTransform("a", "b", 1);
  addTransform("b", "a", 1);
  addTransform("c", "unknown", 1);
  addTransform("d", "field", 4);
  stored.add("transforms", 1, transforms);
  update();
  for (const char* frame : {"a", "b", "c", "unknown"}) EXPECT_EQ(xOf(frame), -1000) << frame;
  EXPECT_EQ(xOf("d"), 4);
}

TEST_F(SceneStateTest, framesThatAreNotPublishedAnyMoreAreGone) {
  addTransform("red1", "field", 1);
  stored.add("transforms", 1, transforms);
  transforms.Clear();
  addTransform("blue1", "field", 2);
  stored.add("transforms", 2, transforms);
  update(1);
  EXPECT_EQ(xOf("red1"), 1);
  update(2);
  EXPECT_EQ(xOf("red1"), -1000);
  EXPECT_EQ(xOf("blue1"), 2);
}

TEST_F(SceneStateTest, framesOfOtherProgramsAreThoseOfTheirRobot) {
  addTransform("base", "map", 3);
  stored.add("red1/tf", 1, transforms);
  transforms.Clear();
  addTransform("base", "map", 4);
  stored.add("blue1/tf", 1, transforms);
  update();
  EXPECT_EQ(xOf("base", "red1"), 3);
  EXPECT_EQ(xOf("base", "blue1"), 4);
  EXPECT_EQ(xOf("base"), -1000) << "nobody knows whose";
}

TEST_F(SceneStateTest, modelsAreThoseOfTheSimulationAndOfTheSceneEachOnce) {
  foxglove::SceneUpdate objects;
  addEntity(objects, "1", "red1");
  addEntity(objects, "2", "red1");
  addEntity(objects, "3", "ball");
  addEntity(objects, "4", "");
  robotcontrol::SimulationStatus status;
  for (const char* model : {"red1", "crate"}) status.add_models(model);
  stored.add("scene", 1, objects);
  update();
  EXPECT_EQ(scene.models(), (Names{"ball", "red1"}));
  stored.add("simulation", 2, status);
  update();
  EXPECT_EQ(scene.models(), (Names{"ball", "crate", "red1"}));
  foxglove::SceneUpdate more;
  addEntity(more, "5", "desk");
  stored.add("scene", 3, more);
  update();
  EXPECT_EQ(scene.models(), (Names{"ball", "crate", "desk", "red1"})) << "the status is the same";
}

TEST_F(SceneStateTest, aModelIsAtTheFrameOfItsNameOrAtThatOfItsFirstEntity) {
  foxglove::SceneUpdate objects;
  addEntity(objects, "1", "red1", "red1/body");
  addEntity(objects, "2", "ball", "ball-frame");
  stored.add("scene", 1, objects);
  addTransform("red1", "field", 1);
  addTransform("red1/body", "red1", 1);
  addTransform("ball-frame", "field", 5);
  stored.add("transforms", 1, transforms);
  update();
  EXPECT_EQ(scene.modelFrame("red1"), "red1");
  EXPECT_EQ(scene.modelFrame("ball"), "ball-frame");
  EXPECT_EQ(scene.modelFrame("none"), "");
  EXPECT_DOUBLE_EQ(scene.modelPose("ball")->translation().x(), 5);
}

TEST_F(SceneStateTest, metadataAreFoundByTheirKeys) {
  foxglove::SceneUpdate objects;
  addEntity(objects, "1", "red1");
  auto& pair = *objects.mutable_entities(0)->add_metadata();
  pair.set_key("object");
  pair.set_value("red1/link:head");
  stored.add("scene", 1, objects);
  update();
  EXPECT_EQ(*scene.items().at("1").object, "red1/link:head");
  EXPECT_EQ(metadataOf(objects.entities(0), "color"), nullptr);
}

}  // namespace
}  // namespace widgets::test
