// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/SeenObstacles.h"

#include <gtest/gtest.h>

#include "modules/navigation/GridPlanner.h"
#include "tests/modules/driving/RollingRobot.h"

namespace modules {
namespace {

using robotlink::fromSeconds;
using robotlink::Instant;
using robotlink::Pose2;
using robotlink::Vector2;

/// Two rooms with a door of a meter at (4, 2), and perhaps a second one at (4, 6).
robotlink::GroundMap twoRooms(bool secondDoor) {
  robotlink::GroundMap map = roomMap(8, 8);
  addWall(map, 4, 0, 4, 1.5);
  if (secondDoor) {
    addWall(map, 4, 2.5, 4, 5.5);
    addWall(map, 4, 6.5, 4, 8);
  } else {
    addWall(map, 4, 2.5, 4, 8);
  }
  return map;
}

void addBox(robotlink::GroundMap& map, double x, double y, double side) {
  const double h = 0.5 * side;
  addWall(map, x - h, y - h, x + h, y - h);
  addWall(map, x + h, y - h, x + h, y + h);
  addWall(map, x + h, y + h, x - h, y + h);
  addWall(map, x - h, y + h, x - h, y - h);
}

std::vector<RangeBeam> scanOf(const robotlink::GroundMap& world, const Pose2& pose) {
  const FlatWorld walls(world);
  return RollingRobot(walls, {.start = pose}).beams();
}

class SeenObstaclesTest : public testing::Test {
 protected:
  void see(const robotlink::GroundMap& world, const Pose2& pose, int times = 5) {
    for (int i = 0; i < times; ++i) {
      now_ += fromSeconds(0.1);
      seen_.see(now_, pose, scanOf(world, pose), {});
    }
  }

  robotlink::GroundMap map_ = twoRooms(true);
  DistanceMap walls_{map_, {}};
  SeenObstacles seen_{walls_};
  Instant now_;
};

TEST_F(SeenObstaclesTest, wallsOfTheMapAreNone) {
  for (const double heading : {0.0, 1.5, 3.1, -1.5}) see(map_, {2, 2, heading});
  EXPECT_TRUE(seen_.places().empty());
}

TEST_F(SeenObstaclesTest, aBoxInTheDoorIsOneUntilItIsGone) {
  robotlink::GroundMap blocked = map_;
  addBox(blocked, 4, 2, 0.5);
  see(blocked, {2, 2, 0});
  ASSERT_FALSE(seen_.places().empty());
  for (const Vector2& place : seen_.places()) {
    EXPECT_NEAR(3.75, place.x(), 0.15);
    EXPECT_NEAR(2, place.y(), 0.4);
  }
  const std::uint64_t before = seen_.generation();
  see(map_, {2, 2, 0}, 15);
  EXPECT_TRUE(seen_.places().empty()) << "rays pass where it was";
  EXPECT_NE(before, seen_.generation());
}

TEST_F(SeenObstaclesTest, whatIsNotSeenAnyMoreIsForgottenAfterAWhile) {
  robotlink::GroundMap blocked = map_;
  addBox(blocked, 4, 2, 0.5);
  see(blocked, {2, 2, 0});
  see(blocked, {2, 2, 3.1});
  EXPECT_FALSE(seen_.places().empty());
  now_ += fromSeconds(SeenObstacles::Options().memory + 1);
  see(blocked, {2, 2, 3.1}, 1);
  EXPECT_TRUE(seen_.places().empty());
}

TEST_F(SeenObstaclesTest, aSingleRayIsNoObstacle) {
  const RangeBeam ray{.sensorInRobot = {}, .range = 1, .maximum = 32, .time = {}};
  seen_.see(now_, {2, 2, 0}, std::span(&ray, 1), {});
  EXPECT_TRUE(seen_.places().empty());
}

TEST_F(SeenObstaclesTest, timeThatGoesBackBeginsAnew) {
  robotlink::GroundMap blocked = map_;
  addBox(blocked, 4, 2, 0.5);
  see(blocked, {2, 2, 0});
  seen_.see(Instant{}, {2, 2, 0}, {}, {});
  EXPECT_TRUE(seen_.places().empty());
}

TEST_F(SeenObstaclesTest, thePlannerGoesThroughTheOtherDoor) {
  robotlink::GroundMap blocked = map_;
  addBox(blocked, 4, 2, 0.5);
  GridPlanner planner(map_, {});
  planner.setGoal({6, 2});
  const PlannedPath straight = planner.path({2, 2});
  EXPECT_LT(straight.length(), 4.5);
  EXPECT_FALSE(straight.around);
  see(blocked, {2, 2, 0});
  planner.setObstacles(seen_.places());
  const PlannedPath around = planner.path({2, 2});
  EXPECT_EQ("", around.reason);
  EXPECT_TRUE(around.around);
  EXPECT_GT(around.length(), 7);
  planner.setObstacles({});
  EXPECT_EQ(straight.points, planner.path({2, 2}).points);
}

TEST_F(SeenObstaclesTest, whereThereIsNoOtherWayThePlannerSaysWhy) {
  const robotlink::GroundMap closed = twoRooms(false);
  const DistanceMap walls(closed, {});
  SeenObstacles seen(walls);
  robotlink::GroundMap blocked = closed;
  addBox(blocked, 4, 2, 0.5);
  for (int i = 0; i < 5; ++i) seen.see(now_, {2, 2, 0}, scanOf(blocked, {2, 2, 0}), {});
  GridPlanner planner(closed, {});
  planner.setGoal({6, 2});
  planner.setObstacles(seen.places());
  EXPECT_EQ("an obstacle that is not on the map blocks every path to the goal", planner.path({2, 2}).reason);
  EXPECT_EQ("an obstacle that is not on the map blocks every path to the goal", planner.path({3.3, 2}).reason)
      << "nor does it begin behind what is in the way";
  planner.setGoal({4, 2});
  EXPECT_EQ("an obstacle that is not on the map is at the goal, or too near to it",
            planner.path({2, 2}).reason);
  planner.setGoal({4, 6});
  EXPECT_EQ("the goal is too near to a wall for this robot", planner.path({2, 2}).reason);
}

}  // namespace
}  // namespace modules
