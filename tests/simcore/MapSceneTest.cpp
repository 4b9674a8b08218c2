// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "robotlink/base/GroundMap.h"
#include "simcore/SceneContents.h"
#include "simcore/Simulation.h"
#include "tests/simcore/HouseMap.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;
using testing::HasSubstr;

const std::filesystem::path kMaps = ROBOTCONTROL_SOURCE_DIR "/../shared/data/arcos";

std::vector<Pose2> placesOf(const std::shared_ptr<const Scene>& scene) {
  const auto simulation = Simulation::create(scene, {});
  EXPECT_TRUE(simulation) << simulation.error().describe();
  std::vector<Pose2> places;
  for (const Scene::Robot& robot : scene->robots())
    places.push_back(robotlink::groundPose(*(*simulation)->modelPose(robot.name)));
  return places;
}

class MapScene : public testing::Test {
 protected:
  std::shared_ptr<const Scene> load(const std::string& text, const RobotsToAdd& robots = {}) {
    const auto scene = Scene::load(folder_.write("house.map", text), robots);
    EXPECT_TRUE(scene) << describe(scene.error());
    return scene ? *scene : nullptr;
  }
  std::string errorOf(const std::string& name, const std::string& text, const RobotsToAdd& robots) {
    const auto scene = Scene::load(folder_.write(name, text), robots);
    return scene ? "" : describe(scene.error());
  }
  SceneFolder folder_;
};

TEST_F(MapScene, aMapHasAFloorAndOneModelOfWalls) {
  const auto scene = load(kHouse);
  const WorldDescription& world = scene->contents().world;
  ASSERT_EQ(world.models.size(), 2U);
  EXPECT_EQ(world.models[0].name, "floor");
  EXPECT_EQ(world.models[1].name, "walls");
  EXPECT_TRUE(world.models[1].type->isStatic);
  EXPECT_EQ(world.models[1].type->links[0].collisions.size(), 6U) << "five lines and a pillar";
  EXPECT_TRUE(scene->robots().empty());
  ASSERT_NE(scene->groundMap(), nullptr);
  EXPECT_EQ(scene->groundMap()->name, "house");
  EXPECT_EQ(scene->groundMap()->places.size(), 2U);
}

TEST_F(MapScene, robotsStandOnTheirWheelsAndStayThere) {
  const auto scene = load(kHouse, {.count = 3});
  const auto simulation = std::move(Simulation::create(scene, {}).value());
  const Pose3 before = *simulation->modelPose("p3at2");
  for (int i = 0; i < 125; ++i) simulation->step();
  const Pose3 after = *simulation->modelPose("p3at2");
  EXPECT_LT((after.translation() - before.translation()).norm(), 0.005);
}

TEST_F(MapScene, whatIsNoRobotIsRefused) {
  EXPECT_THAT(errorOf("house.map", kHouse, {.model = "field2002", .count = 1}),
              HasSubstr("'field2002' is not a robot"));
  EXPECT_THAT(errorOf("house.map", kHouse, {.model = "p9", .count = 1}), HasSubstr("there is no model 'p9'"));
  EXPECT_THAT(errorOf("house.map", kHouse, {.model = "../p3at", .count = 1}),
              HasSubstr("there is no model '../p3at'"));
}

TEST_F(MapScene, errorsOfAMapKeepTheirLines) {
  EXPECT_THAT(errorOf("bad.map", "2D-Map\nLINES\n0 0 1\n", {}), HasSubstr("bad.map:3:1: a line of LINES"));
  EXPECT_THAT(errorOf("BAD.MAP", "<sdf/>", {}), HasSubstr("BAD.MAP:1:1: this is not a map"));
}

TEST_F(MapScene, robotsAreAddedToTheFieldToo) {
  const auto scene = Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/field2002.sdf", {.count = 2});
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_EQ((*scene)->groundMap(), nullptr);
  const auto& robots = (*scene)->robots();
  ASSERT_GE(robots.size(), 3U);
  EXPECT_EQ(robots[robots.size() - 2].name, "p3at1");
  EXPECT_EQ(robots.back().name, "p3at2");
  for (const Pose2& place : placesOf(*scene)) EXPECT_LT(place.translation().norm(), 3);
}

TEST_F(MapScene, anOpenFloorIsFloorEnough) {
  const std::string floor =
      "<model name='floor'><static>true</static><link name='floor'><collision "
      "name='floor'><geometry><plane><normal>0 0 1</normal>"
      "<size>9 9</size></plane></geometry></collision></link></model>";
  const auto scene = Scene::load(folder_.write("world.sdf", worldAround(floor)), {.count = 4});
  ASSERT_TRUE(scene) << describe(scene.error());
  EXPECT_GT(leastDistance(placesOf(*scene)), 0.9);
}

TEST_F(MapScene, withoutAFloorNoRobotIsAdded) {
  EXPECT_THAT(errorOf("world.sdf", worldAround(""), {.count = 1}),
              HasSubstr("world.sdf: robots cannot be added here: the scene has no level plane"));
}

TEST_F(MapScene, twentyRobotsStandInsideOfTheShippedHouse) {
  const auto scene = Scene::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/house.map", {.count = 20});
  ASSERT_TRUE(scene) << describe(scene.error());
  const std::vector<Pose2> places = placesOf(*scene);
  ASSERT_EQ(places.size(), 20U);
  EXPECT_NEAR((places[0].translation() - Vector2(1, 5.5)).norm(), 0, 1e-6);  // its home
  EXPECT_GT(leastDistance(places), 0.7);
  for (const Pose2& place : places) {
    EXPECT_TRUE(place.x > 0.3 && place.x < 15.7 && place.y > 0.3 && place.y < 10.7)
        << place.x << " " << place.y;
  }
}

TEST_F(MapScene, loadingReportsItsProgressAndCanBeCanceledAnywhere) {
  const auto file = folder_.write("house.map", kHouse);
  std::vector<double> reported;
  const auto note = [&](double share) {
    reported.push_back(share);
    return true;
  };
  ASSERT_TRUE(Scene::load(file, {.count = 2}, note));
  ASSERT_GE(reported.size(), 4U);
  EXPECT_EQ(reported.front(), 0);
  EXPECT_LE(reported.back(), 1);
  EXPECT_TRUE(std::ranges::is_sorted(reported));
  for (const double last : reported) {
    const auto scene = Scene::load(file, {.count = 2}, [&](double share) { return share < last; });
    ASSERT_FALSE(scene) << last;
    ASSERT_EQ(scene.error().size(), 1U);
    EXPECT_EQ(scene.error()[0].id, "scene.given-up");
  }
}

/// A room of 10 m by 8 m as a laser saw it: points 2 cm apart, every fifth of them with one behind it.
std::string scannedRoom() {
  std::string text = "2D-Map\nResolution: 20\nDATA\n";
  const auto point = [&text](int x, int y) { text += std::to_string(x) + ' ' + std::to_string(y) + '\n'; };
  for (int i = 0; i <= 500; ++i) {
    for (const int depth : {0, 20}) {
      if (depth != 0 && i % 5 != 0) continue;
      point(20 * i, -depth);
      point(20 * i, 8000 + depth);
      if (i > 400) continue;
      point(-depth, 20 * i);
      point(10'000 + depth, 20 * i);
    }
  }
  return text;
}

/// What takes time is bounded by the number of pieces, whatever clock there is.
TEST_F(MapScene, theMapOfAScannedRoomIsMadeOfFewPieces) {
  const auto scene = load(scannedRoom(), {.count = 4});
  ASSERT_NE(scene, nullptr);
  const auto& walls = scene->contents().world.models[1].type->links[0].collisions;
  EXPECT_GT(scene->groundMap()->points.size(), 2000U);
  EXPECT_GE(walls.size(), 4U);
  EXPECT_LT(walls.size(), 500U);
  for (const Pose2& place : placesOf(scene)) {
    EXPECT_TRUE(place.x > 0.3 && place.x < 9.7 && place.y > 0.3 && place.y < 7.7)
        << place.x << " " << place.y;
  }
}

/// What takes time is bounded by the number of pieces, whatever clock there is.
TEST_F(MapScene, theMapOfABuildingIsMadeOfFewPieces) {
  if (!std::filesystem::exists(kMaps / "columbia.map")) GTEST_SKIP() << "../shared/data/arcos is not here";
  const auto scene = Scene::load(kMaps / "columbia.map", {.count = 10});
  ASSERT_TRUE(scene) << describe(scene.error());
  const auto simulation = Simulation::create(*scene, {});
  ASSERT_TRUE(simulation) << simulation.error().describe();
  const auto& walls = (*scene)->contents().world.models[1].type->links[0].collisions;
  EXPECT_GT(walls.size(), 5000U);
  EXPECT_LT(walls.size(), 10'000U);
}

TEST_F(MapScene, aHundredRobotsStandInsideOfTheBuilding) {
  if (!std::filesystem::exists(kMaps / "columbia.map")) GTEST_SKIP() << "../shared/data/arcos is not here";
  const auto scene = Scene::load(kMaps / "columbia.map", {.count = 100});
  ASSERT_TRUE(scene) << describe(scene.error());
  const std::vector<Pose2> places = placesOf(*scene);
  ASSERT_EQ(places.size(), 100U);
  EXPECT_NEAR(places[0].x, -0.182, 1e-6);
  EXPECT_GT(leastDistance(places), 0.9);
  const auto map = (*scene)->groundMap();
  for (const Pose2& place : places) {
    for (const Vector2& point : map->points)
      ASSERT_GT((point - place.translation()).norm(), 0.35) << place.x << " " << place.y;
    // Beyond this line there are only points that a laser saw through windows.
    EXPECT_LT(place.y, 19.5);
  }
}

}  // namespace
}  // namespace simcore
