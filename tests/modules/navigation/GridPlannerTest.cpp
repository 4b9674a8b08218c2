// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/GridPlanner.h"

#include <gtest/gtest.h>

#include "FlatWorld.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Vector2;

/// Two rooms side by side, 6 x 6 m each, and a door of 1 m in the wall between them.
GroundMap twoRooms() {
  GroundMap map = roomMap(12, 6);
  addWall(map, 6, 0, 6, 4);
  addWall(map, 6, 5, 6, 6);
  return map;
}

void forbid(GroundMap& map, GroundMap::Place::Kind kind, double x1, double y1, double x2, double y2) {
  GroundMap::Place place;
  place.kind = kind;
  place.extent = {{x1, y1}, {x2, y2}};
  map.places.push_back(place);
}

/// m, the least distance of a path from the walls of a map.
double clearanceOf(const PlannedPath& path, const GroundMap& map) {
  const DistanceMap distances(map, {});
  double least = 10;
  for (std::size_t i = 1; i < path.points.size(); ++i)
    for (int share = 0; share <= 100; ++share)
      least = std::min(
          least, distances.at(path.points[i - 1] + 0.01 * share * (path.points[i] - path.points[i - 1])));
  return least;
}

TEST(GridPlanner, whereNothingIsInTheWayItGoesStraight) {
  GridPlanner planner(roomMap(10, 10), {});
  planner.setGoal({8, 7});
  const PlannedPath path = planner.path({2, 3});
  ASSERT_FALSE(path.blocked()) << path.reason;
  EXPECT_EQ(2U, path.points.size());
  EXPECT_EQ(Vector2(2, 3), path.points.front());
  EXPECT_EQ(Vector2(8, 7), path.points.back());
  EXPECT_NEAR(std::hypot(6, 4), path.length(), 1e-9);
}

TEST(GridPlanner, itGoesThroughTheDoorAndKeepsAwayFromWalls) {
  const GroundMap map = twoRooms();
  GridPlanner planner(map, {});
  planner.setGoal({10, 1});
  const PlannedPath path = planner.path({2, 1});
  ASSERT_FALSE(path.blocked()) << path.reason;
  EXPECT_GT(clearanceOf(path, map), 0.3);
  const double shortest = std::hypot(4, 3.4) * 2;
  EXPECT_LT(path.length(), 1.15 * shortest);
  EXPECT_LT(path.points.size(), 12U);
}

TEST(GridPlanner, aDoorThatIsTooNarrowIsNone) {
  GroundMap map = roomMap(12, 6);
  addWall(map, 6, 0, 6, 4);
  addWall(map, 6, 4.6, 6, 6);
  GridPlanner planner(map, {});
  planner.setGoal({10, 1});
  EXPECT_EQ("no path to the goal is wide enough and outside of forbidden areas", planner.path({2, 1}).reason);
}

TEST(GridPlanner, forbiddenLinesAreNotCrossed) {
  GroundMap map = roomMap(12, 6);
  forbid(map, GroundMap::Place::Kind::kForbiddenLine, 6, 0, 6, 4.5);
  GridPlanner planner(map, {});
  planner.setGoal({10, 1});
  const PlannedPath path = planner.path({2, 1});
  ASSERT_FALSE(path.blocked());
  GroundMap fenced = map;
  addWall(fenced, 6, 0, 6, 4.5);
  EXPECT_GT(clearanceOf(path, fenced), 0.3);
  forbid(map, GroundMap::Place::Kind::kForbiddenLine, 6, 4.5, 6, 6);
  GridPlanner closed(map, {});
  closed.setGoal({10, 1});
  EXPECT_TRUE(closed.path({2, 1}).blocked());
}

TEST(GridPlanner, forbiddenAreasAreGoneAroundAndAreNoGoals) {
  GroundMap map = roomMap(12, 6);
  forbid(map, GroundMap::Place::Kind::kForbiddenArea, 5, 0, 7, 4);
  GridPlanner planner(map, {});
  planner.setGoal({10, 1});
  const PlannedPath path = planner.path({2, 1});
  ASSERT_FALSE(path.blocked());
  for (const Vector2& point : path.points) EXPECT_FALSE(point.x() > 5 && point.x() < 7 && point.y() < 4);
  planner.setGoal({6, 2});
  EXPECT_EQ("the goal is forbidden: it lies in a forbidden area, or too near to one",
            planner.path({2, 1}).reason);
}

TEST(GridPlanner, goalsInWallsAndOffTheMapAreToldFromEachOther) {
  GridPlanner planner(twoRooms(), {});
  planner.setGoal({6, 2});
  EXPECT_EQ("the goal is too near to a wall for this robot", planner.path({2, 1}).reason);
  planner.setGoal({600, 2});
  EXPECT_EQ("the goal is not on the map", planner.path({2, 1}).reason);
}

TEST(GridPlanner, aRobotTooNearToAWallFindsOut) {
  const GroundMap map = twoRooms();
  GridPlanner planner(map, {});
  planner.setGoal({2, 3});
  const PlannedPath path = planner.path({5.9, 0.15});
  ASSERT_FALSE(path.blocked()) << path.reason;
  EXPECT_EQ(Vector2(5.9, 0.15), path.points.front());
  EXPECT_EQ(Vector2(2, 3), path.points.back());
  // Not through the wall that is next to it.
  for (const Vector2& point : path.points) EXPECT_LT(point.x(), 6);
}

TEST(GridPlanner, theWaveIsNearestAtTheGoal) {
  GridPlanner planner(twoRooms(), {});
  EXPECT_TRUE(planner.wave(100).empty());
  planner.setGoal({2, 3});
  const auto wave = planner.wave(300);
  EXPECT_GT(wave.size(), 50U);
  EXPECT_LT(wave.size(), 700U);
  const auto nearest = std::ranges::min_element(wave, {}, &GridPlanner::WavePoint::share);
  EXPECT_LT((nearest->place - Vector2(2, 3)).norm(), 0.6);
}

TEST(GridPlanner, inTheShippedHouseItFindsEveryRoomButNotTheStairs) {
  const auto map = GroundMap::load(ROBOTCONTROL_SOURCE_DIR "/resources/scenes/house.map");
  ASSERT_TRUE(map) << describe(map.error());
  GridPlanner planner(*map, {});
  const Vector2 home = map->find(GroundMap::Place::Kind::kHome)->pose.translation();
  for (const char* room : {"Study", "Kitchen", "Workshop", "Bedroom", "Living room", "Library"}) {
    planner.setGoal(map->find(room)->pose.translation());
    const PlannedPath path = planner.path(home);
    ASSERT_FALSE(path.blocked()) << room << ": " << path.reason;
    EXPECT_GT(clearanceOf(path, *map), 0.25) << room;
  }
  planner.setGoal({9.85, 10.3});  // the stairs
  EXPECT_TRUE(planner.path(home).blocked());
}

TEST(GridPlanner, inALargeBuildingItFindsTheWorkshopButNotWhatIsForbidden) {
  const GroundMap map = sharedMap("columbia.map");
  if (map.lines.empty()) GTEST_SKIP() << "needs ../shared/data/arcos/columbia.map";
  GridPlanner planner(map, {});
  const GroundMap::Place* home = map.find(GroundMap::Place::Kind::kHome);
  ASSERT_NE(nullptr, home);
  planner.setGoal(map.find("Workshop")->pose.translation());
  const PlannedPath path = planner.path(home->pose.translation());
  ASSERT_FALSE(path.blocked()) << path.reason;
  EXPECT_GT(path.length(), 18);
  EXPECT_LT(path.length(), 60);
  EXPECT_GT(clearanceOf(path, map), 0.25);
  planner.setGoal(map.find("Inside Forbidden Area")->pose.translation());
  EXPECT_TRUE(planner.path(home->pose.translation()).blocked());
}

}  // namespace
}  // namespace modules
