// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/program/SceneMessages.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "foxglove/Scene.pb.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/Simulation.h"
#include "tests/app/SimulatedRuns.h"

namespace app {
namespace {

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
    EXPECT_EQ(entity.metadata_size(), isFixed ? 0 : 1) << entity.id();
    if (entity.metadata_size() == 1) models.insert(entity.metadata(0).value());
  }
  EXPECT_THAT(models, testing::ElementsAre("ball", "red1"));
  EXPECT_THAT(movableModels(simulation()), testing::UnorderedElementsAre("ball", "red1"));
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
