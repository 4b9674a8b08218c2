// SPDX-License-Identifier: GPL-3.0-or-later
// Both ways to avoid obstacles, with and without a laser.
#include <gtest/gtest.h>

#include "tests/modules/driving/Ride.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::radians;

struct Case {
  const char* name;
  Avoidance avoidance;
  bool laser;
};

class AvoidanceTest : public testing::TestWithParam<Case> {
 protected:
  RollingRobot::Options robotAt(const Pose2& start) { return {.start = start, .laser = GetParam().laser}; }
  static Ride::Desired always(const DriveVelocity& desired) {
    return [desired](auto) { return desired; };
  }
};

TEST_P(AvoidanceTest, whereNothingIsInTheWayItDoesAsWished) {
  const FlatWorld world(roomMap(30, 30));
  Ride ride(world, robotAt({10, 15, 0}), GetParam().avoidance);
  ride.run(8, always({0.4, 0}));
  EXPECT_NEAR(0.4, ride.robot().velocity().forward, 0.05);
  EXPECT_LT(std::abs(ride.robot().pose().y - 15), 0.4);
  ride.run(3, always({0, 0.5}));
  EXPECT_NEAR(0.5, ride.robot().velocity().rotation, 0.05);
  ride.run(3, always({}));
  EXPECT_EQ(DriveVelocity{}, ride.request());
}

TEST_P(AvoidanceTest, aWishAgainstAWallDrivesItAlongIt) {
  const FlatWorld world(roomMap(8, 8));
  Ride ride(world, robotAt({2, 4, 0.3}), GetParam().avoidance);
  ride.run(60, always({0.7, 0}));
  EXPECT_GT(ride.robot().nearest(), 0.04);
  EXPECT_GT(ride.robot().way(), 8);
}

TEST_P(AvoidanceTest, backwardsItStopsBeforeTheWall) {
  const FlatWorld world(roomMap(8, 8));
  Ride ride(world, robotAt({2, 4, 0}), GetParam().avoidance);
  ride.run(20, always({-0.4, 0}));
  EXPECT_GT(ride.robot().nearest(), 0.05);
  EXPECT_LT(ride.robot().pose().x, 0.9);
}

TEST_P(AvoidanceTest, itKeepsToTheCorridorAndGetsThrough) {
  GroundMap map = roomMap(20, 1.6);
  const FlatWorld world(map);
  Ride ride(world, robotAt({1, 0.7, radians(10)}), GetParam().avoidance);
  EXPECT_TRUE(ride.runUntil(90, always({0.5, 0}), [&] { return ride.robot().pose().x > 15; }));
  EXPECT_GT(ride.robot().nearest(), 0.08);
}

TEST_P(AvoidanceTest, itGetsAroundAPillar) {
  GroundMap map = roomMap(12, 6);
  addWall(map, 5, 2.7, 5.4, 2.7);
  addWall(map, 5, 3.3, 5.4, 3.3);
  addWall(map, 5, 2.7, 5, 3.3);
  addWall(map, 5.4, 2.7, 5.4, 3.3);
  const FlatWorld world(map);
  Ride ride(world, robotAt({2, 3.05, 0}), GetParam().avoidance);
  // Whoever wishes aims for the far end of the room.
  const auto desired = [&](auto) {
    const auto goal = ride.robot().pose().inverse() * robotlink::Vector2(11, 3);
    return DriveVelocity{0.45, std::clamp(std::atan2(goal.y(), goal.x()), -0.6, 0.6)};
  };
  EXPECT_TRUE(ride.runUntil(90, desired, [&] { return ride.robot().pose().x > 7; }));
  EXPECT_GT(ride.robot().nearest(), 0.06);
}

TEST_P(AvoidanceTest, itComesOutOfADeadEnd) {
  GroundMap map = roomMap(10, 6);
  addWall(map, 5, 2.2, 9, 2.2);
  addWall(map, 5, 3.8, 9, 3.8);
  addWall(map, 9, 2.2, 9, 3.8);
  const FlatWorld world(map);
  Ride ride(world, robotAt({6, 3, 0}), GetParam().avoidance);
  EXPECT_TRUE(ride.runUntil(120, always({0.4, 0}), [&] { return ride.robot().pose().x < 4.5; }));
  EXPECT_GT(ride.robot().nearest(), 0.04);
}

TEST_P(AvoidanceTest, itComesOutOfACorner) {
  const FlatWorld world(roomMap(6, 6));
  Ride ride(world, robotAt({5.4, 5.4, radians(45)}), GetParam().avoidance);
  EXPECT_TRUE(ride.runUntil(60, always({0.4, 0}),
                            [&] { return ride.robot().pose().x < 4.5 || ride.robot().pose().y < 4.5; }));
  EXPECT_GT(ride.robot().nearest(), 0.03);
}

TEST_P(AvoidanceTest, aTurnThatHasNoRoomIsMadeWhereThereIsRoom) {
  // Beside a wall, nearer than its corners need.
  const FlatWorld world(roomMap(8, 8));
  Ride ride(world, robotAt({4, 0.38, 0}), GetParam().avoidance);
  EXPECT_TRUE(ride.runUntil(60, always({0, 0.5}), [&] { return std::abs(ride.robot().pose().heading) > 2; }));
  EXPECT_GT(ride.robot().nearest(), 0.02);
}

TEST_P(AvoidanceTest, aDoorOfNinetyCentimetersIsWideEnough) {
  GroundMap map = roomMap(10, 5);
  addWall(map, 5, 0, 5, 2.05);
  addWall(map, 5, 2.95, 5, 5);
  const FlatWorld world(map);
  Ride ride(world, robotAt({2.5, 2.4, 0}), GetParam().avoidance);
  const auto desired = [&](auto) {
    const auto goal = ride.robot().pose().inverse() * robotlink::Vector2(6.5, 2.5);
    return DriveVelocity{0.35, std::clamp(std::atan2(goal.y(), goal.x()), -0.6, 0.6)};
  };
  EXPECT_TRUE(ride.runUntil(120, desired, [&] { return ride.robot().pose().x > 5.8; }));
  EXPECT_GT(ride.robot().nearest(), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Ways, AvoidanceTest,
                         testing::Values(Case{"vectorField", Avoidance::kVectorField, true},
                                         Case{"vectorFieldBySonar", Avoidance::kVectorField, false},
                                         Case{"dynamicWindow", Avoidance::kDynamicWindow, true},
                                         Case{"dynamicWindowBySonar", Avoidance::kDynamicWindow, false}),
                         [](const auto& which) { return std::string(which.param.name); });

}  // namespace
}  // namespace modules
