// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/SceneMessages.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>

#include "app/platforms/simulated/world/WorldObjects.h"
#include "foxglove/Scene.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/app/SimulatedRuns.h"

namespace app {
namespace {

std::string metadata(const foxglove::SceneEntity& entity, const std::string& key) {
  for (const auto& pair : entity.metadata())
    if (pair.key() == key) return pair.value();
  return {};
}

class SceneMessagesTest : public testing::Test {
 protected:
  const simcore::Simulation& simulation() const { return run_->world().simulation(); }
  /// The transforms by their frames.
  std::map<std::string, foxglove::FrameTransform> transforms() const {
    std::map<std::string, foxglove::FrameTransform> all;
    const auto message = transformsMessage(simulation());
    for (const auto& transform : message->transforms()) all[transform.child_frame_id()] = transform;
    EXPECT_EQ(all.size(), static_cast<std::size_t>(message->transforms_size())) << "names are different";
    return all;
  }

  const std::unique_ptr<SimulatedRun> run_ = test::makeRun(test::simulationOptions());
};

TEST_F(SceneMessagesTest, everyShapeIsInAFrameThatHasATransform) {
  const auto frames = transforms();
  const auto scene = sceneMessage(simulation());
  ASSERT_GT(scene->entities_size(), 0);
  std::set<std::string> ids;
  for (const auto& entity : scene->entities()) {
    EXPECT_TRUE(entity.frame_id() == "field" || frames.contains(entity.frame_id())) << entity.frame_id();
    EXPECT_TRUE(ids.insert(entity.id()).second) << entity.id();
    ASSERT_EQ(entity.triangles_size(), 1);
    const auto& triangles = entity.triangles(0);
    EXPECT_EQ(triangles.indices_size() % 3, 0);
    for (const auto index : triangles.indices())
      ASSERT_LT(index, static_cast<unsigned>(triangles.points_size())) << entity.id();
  }
}

TEST_F(SceneMessagesTest, onlyShapesOfModelsThatMoveNameTheirModel) {
  std::set<std::string> models;
  const auto scene = sceneMessage(simulation());
  for (const auto& entity : scene->entities()) {
    const bool isFixed = entity.frame_id() == "field";
    const std::string model = metadata(entity, "model");
    EXPECT_EQ(model.empty(), isFixed) << entity.id();
    if (!model.empty()) models.insert(model);
  }
  EXPECT_THAT(models, testing::ElementsAre("ball", "red1"));
  EXPECT_THAT(movableModels(simulation()), testing::UnorderedElementsAre("ball", "red1"));
}

TEST_F(SceneMessagesTest, shapesAndSolidsNameTheirObjects) {
  std::map<std::string, robotcontrol::WorldObject> objects;
  const auto all = worldObjects(simulation());
  for (const auto& object : all->objects()) objects[object.path()] = object;
  const auto frames = transforms();
  const auto scene = sceneMessage(simulation()), solids = solidsMessage(simulation());
  for (const auto& entity : scene->entities()) {
    const auto object = objects.find(metadata(entity, "object"));
    ASSERT_NE(object, objects.end()) << entity.id();
    EXPECT_EQ(object->second.kind(), robotcontrol::WorldObject::SHAPE);
    EXPECT_EQ(object->second.frame(), entity.frame_id());
  }
  std::set<std::string> known;
  for (const auto& entity : solids->entities()) {
    const auto object = objects.find(metadata(entity, "object"));
    ASSERT_NE(object, objects.end()) << entity.id();
    EXPECT_EQ(object->second.kind(), robotcontrol::WorldObject::SOLID);
    EXPECT_TRUE(entity.frame_id() == "field" || frames.contains(entity.frame_id())) << entity.frame_id();
    EXPECT_EQ(entity.cubes_size() + entity.spheres_size() + entity.cylinders_size() + entity.triangles_size(),
              1);
    known.insert(object->first);
  }
  const auto isSolid = [](const auto& object) { return object.kind() == robotcontrol::WorldObject::SOLID; };
  EXPECT_EQ(static_cast<std::ptrdiff_t>(known.size()), std::ranges::count_if(all->objects(), isSolid));
  EXPECT_GT(known.size(), 10U);
}

TEST_F(SceneMessagesTest, theFrameOfARobotIsOnTheGroundBelowIt) {
  const auto truth = *simulation().modelPose("red1");
  const auto frame = transforms().at("red1");
  EXPECT_EQ(frame.parent_frame_id(), "field");
  EXPECT_NEAR(frame.translation().x(), truth.translation().x(), 1e-9);
  EXPECT_NEAR(frame.translation().y(), truth.translation().y(), 1e-9);
  EXPECT_EQ(frame.translation().z(), 0);
  EXPECT_EQ(frame.rotation().x(), 0);
  EXPECT_EQ(frame.rotation().y(), 0);
}

}  // namespace
}  // namespace app
