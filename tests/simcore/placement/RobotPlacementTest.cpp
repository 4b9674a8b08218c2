// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/placement/RobotPlacement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <span>

#include "simcore/maps/MapWorld.h"
#include "tests/simcore/HouseMap.h"
#include "tests/simcore/SceneFixture.h"

namespace simcore {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;

constexpr double kRadius = 0.4;

/// A robot like a bucket, whose bottom is 0.1 m below its frame.
std::shared_ptr<const ModelDescription> bucket() {
  auto type = std::make_shared<ModelDescription>();
  type->robot = "bucket";
  CollisionDescription& solid = type->links.emplace_back().collisions.emplace_back();
  solid.shape.kind = Shape::Kind::kCylinder;
  solid.shape.radius = kRadius;
  solid.shape.length = 0.5;
  solid.poseInLink.translation().z() = 0.15;
  return type;
}

GroundMap parsed(const std::string& text) {
  auto map = GroundMap::parse(text, "house.map");
  EXPECT_TRUE(map) << describe(map.error());
  return map.value_or(GroundMap{});
}

/// The robots that a map holds after some were added, or why they were not.
robotlink::Result<std::vector<ModelInstance>> placed(const std::string& text, const RobotsToAdd& robots) {
  const GroundMap map = parsed(text);
  WorldDescription world = mapWorld(map, "house.map").value();
  const std::size_t before = world.models.size();
  const auto added = addRobots(world, &map, bucket(), robots, {}, "house.map");
  if (!added) return tl::unexpected(added.error());
  return std::vector<ModelInstance>(world.models.begin() + static_cast<std::ptrdiff_t>(before),
                                    world.models.end());
}

std::vector<Pose2> placesIn(const std::string& text, const RobotsToAdd& robots) {
  const auto models = placed(text, robots);
  EXPECT_TRUE(models) << models.error().describe();
  std::vector<Pose2> places;
  if (!models) return places;
  for (const ModelInstance& model : *models) places.push_back(robotlink::groundPose(model.poseInWorld));
  return places;
}

}  // namespace

TEST(RobotPlacement, theFirstRobotStandsAtHomeAndTheOthersAreSpread) {
  const std::vector<Pose2> places = placesIn(kHouse, {.count = 6});
  ASSERT_EQ(places.size(), 6U);
  EXPECT_NEAR(places[0].x, 1.5, 1e-6);
  EXPECT_NEAR(places[0].y, 1.5, 1e-6);
  EXPECT_NEAR(places[0].heading, robotlink::kPi / 2, 1e-6);
  EXPECT_GT(leastDistance(places), 2 * kRadius + 0.1);
  for (const Pose2& place : places) {
    EXPECT_TRUE(place.x > kRadius && place.x < 8 - kRadius && place.y > kRadius && place.y < 6 - kRadius)
        << "not outside";
    EXPECT_FALSE(place.x > 5 - kRadius && place.y < 3 + kRadius) << "not where it is forbidden";
    EXPECT_FALSE(std::abs(place.x - 4) < kRadius && place.y < 4) << "not in the wall";
    EXPECT_GT((place.translation() - Vector2(2, 4)).norm(), kRadius) << "not in the pillar";
  }
  EXPECT_TRUE(std::ranges::any_of(places, [](const Pose2& place) { return place.x > 4.5; }))
      << "through the door";
}

TEST(RobotPlacement, robotsStandOnTheFloor) {
  const auto models = placed(kHouse, {.count = 2});
  ASSERT_TRUE(models);
  EXPECT_NEAR(models->back().poseInWorld.translation().z(), 0.1, 1e-9);
}

TEST(RobotPlacement, placesDependOnTheSeedAlone) {
  const RobotsToAdd robots{.count = 5, .seed = 7};
  EXPECT_EQ(placesIn(kHouse, robots), placesIn(kHouse, robots));
  EXPECT_NE(placesIn(kHouse, robots), placesIn(kHouse, {.count = 5, .seed = 8}));
}

TEST(RobotPlacement, namesAreNumberedAndNeverTaken) {
  const auto models = placed(kHouse, {.count = 2});
  ASSERT_TRUE(models);
  EXPECT_EQ(models->at(1).name, "p3at2");
  const GroundMap map = parsed(kHouse);
  WorldDescription world = mapWorld(map, "house.map").value();
  world.models[0].name = "rover1";
  ASSERT_TRUE(addRobots(world, &map, bucket(), {.count = 2, .namePrefix = "rover"}, {}, "house.map"));
  EXPECT_EQ(world.models.at(world.models.size() - 2).name, "rover2");
  EXPECT_EQ(world.models.back().name, "rover3");
}

TEST(RobotPlacement, aRoomWithoutAWayFromHomeStaysEmpty) {
  const std::string closed = replaced(kHouse, "4000 0 4000 4000", "4000 0 4000 6000");
  for (const Pose2& place : placesIn(closed, {.count = 6})) EXPECT_LT(place.x, 4);
}

TEST(RobotPlacement, nobodyCrossesAForbiddenLine) {
  const std::string line = "Cairn: ForbiddenLine 0 0 0 \"\" ICON \"\" 4000 4000 4000 6000\nLINES";
  for (const Pose2& place : placesIn(replaced(kHouse, "LINES", line), {.count = 6})) EXPECT_LT(place.x, 4);
}

TEST(RobotPlacement, forbiddenAreasMayBeTurned) {
  // Turned by 90 degrees about the origin, it covers the left third of the house.
  const std::string turned = replaced(kHouse, "ForbiddenArea 0 0 0 \"\" ICON \"\" 5000 0 8000 3000",
                                      "ForbiddenArea 0 0 90 \"\" ICON \"\" 0 -2500 6000 0");
  for (const Pose2& place : placesIn(turned, {.count = 4})) EXPECT_GT(place.x, 2.5 + kRadius);
}

TEST(RobotPlacement, withoutAHomeTheLargestRoomIsTaken) {
  std::string text = replaced(kHouse, "Cairn: RobotHome 1500 1500 90 \"\" ICON \"Home\"\n", "");
  text = replaced(text, "Cairn: ForbiddenArea 0 0 0 \"\" ICON \"\" 5000 0 8000 3000\n", "");
  text = replaced(text, "4000 0 4000 4000", "3000 0 3000 6000");
  for (const Pose2& place : placesIn(text, {.count = 4})) EXPECT_GT(place.x, 3);
}

TEST(RobotPlacement, anOpenDoorDoesNotLeadRobotsOutOfTheHouse) {
  // The outer wall lacks 2 m at the right, and there is something far away.
  std::string open = replaced(kHouse, "8000 0 8000 6000", "8000 0 8000 4000");
  open += "20000 3000\n-9000 3000\n2000 20000\n";
  for (const Pose2& place : placesIn(open, {.count = 8})) {
    EXPECT_TRUE(place.x > 0 && place.x < 8 && place.y > 0 && place.y < 6) << place.x << " " << place.y;
  }
}

TEST(RobotPlacement, aHomeWithoutRoomIsLeftForTheNextPlace) {
  const std::vector<Pose2> places =
      placesIn(replaced(kHouse, "RobotHome 1500 1500", "RobotHome 100 1500"), {.count = 1});
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(places[0].y, 1.5, 0.1);
  EXPECT_GT(places[0].x, kRadius);
  EXPECT_LT(places[0].x, 0.8);
  EXPECT_NEAR(places[0].heading, robotlink::kPi / 2, 1e-6);
}

TEST(RobotPlacement, eachHomeGetsARobot) {
  const std::string text = replaced(kHouse, "LINES", "Cairn: RobotHome 7000 5000 -90 \"\" ICON \"\"\nLINES");
  const std::vector<Pose2> places = placesIn(text, {.count = 3});
  ASSERT_EQ(places.size(), 3U);
  EXPECT_NEAR(places[1].x, 7, 1e-6);
  EXPECT_NEAR(places[1].heading, -robotlink::kPi / 2, 1e-6);
  EXPECT_GT(leastDistance(places), 2 * kRadius);
}

TEST(RobotPlacement, tooManyRobotsAreRefusedWithTheNumberThatFits) {
  const auto models = placed(kHouse, {.count = 500});
  ASSERT_FALSE(models);
  EXPECT_THAT(models.error().describe(),
              testing::MatchesRegex("house.map: there is room for [0-9]+ of the 500 robots: .*"));
}

TEST(RobotPlacement, robotsOfTeamsAreSharedOutAndStandAtTheTeamsHomes) {
  WorldDescription world = mapWorld(parsed(kHouse), "house.map").value();
  auto field = std::make_shared<ModelDescription>();
  field->isStatic = true;
  field->homes = {{"red", {1.5, 1.5, 0}}, {"blue", {6, 5, 1}}, {"red", {1.5, 5, 0}}};
  ModelInstance& standing = world.models.emplace_back();
  standing.type = field;
  const auto robot = std::make_shared<ModelDescription>(*bucket());
  robot->links[0].visuals.emplace_back().teamColor = true;
  ModelInstance& first = world.models.emplace_back();
  first.name = first.teamColorName = "red";
  first.type = std::make_shared<ModelDescription>();
  const Palette palette{{"red", {200, 0, 0}}, {"blue", {0, 0, 200}}};
  const std::size_t before = world.models.size();
  ASSERT_TRUE(addRobots(world, nullptr, robot, {.count = 3, .teams = {"red", "blue"}}, palette, "field.sdf"));
  const auto added = std::span(world.models).subspan(before);
  EXPECT_EQ(added[0].name, "blue1") << "the red team has one already";
  EXPECT_EQ(added[1].name, "red1");
  EXPECT_EQ(added[2].name, "blue2");
  EXPECT_EQ(added[0].teamColor->b, 200);
  EXPECT_NEAR(robotlink::groundPose(added[0].poseInWorld).x, 6, 1e-6);
  EXPECT_NEAR(robotlink::groundPose(added[0].poseInWorld).heading, 1, 1e-6);
  EXPECT_NEAR(robotlink::groundPose(added[1].poseInWorld).y, 1.5, 1e-6);
  const auto refused =
      addRobots(world, nullptr, robot, {.count = 1, .teams = {"green"}}, palette, "field.sdf");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().describe(),
              testing::HasSubstr("no palette of the scene has the color 'green' of a team"));
}

TEST(RobotPlacement, whatStandsOnTheFloorIsMissed) {
  const GroundMap map = parsed(kHouse);
  WorldDescription world = mapWorld(map, "house.map").value();
  ASSERT_TRUE(addRobots(world, &map, bucket(), {.count = 3}, {}, "house.map"));
  ASSERT_TRUE(addRobots(world, &map, bucket(), {.count = 3, .seed = 2}, {}, "house.map"));
  std::vector<Pose2> places;
  for (std::size_t i = 2; i < world.models.size(); ++i)
    places.push_back(robotlink::groundPose(world.models[i].poseInWorld));
  EXPECT_GT(leastDistance(places), 2 * kRadius);
}

}  // namespace simcore
