// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/localization/FieldEdgeMap.h"

#include <gtest/gtest.h>

#include <cmath>

#include "modules/modeling/localization/LandmarkMemory.h"
#include "modules/modeling/localization/OdometryBuffer.h"
#include "tests/modules/modeling/FieldWalk.h"

namespace modules {
namespace {

using robotlink::kPi;
using robotlink::Pose2;
using robotlink::Vector2;

TEST(FieldEdges, areLinesAndTheFeetOfWalls) {
  const FieldEdgeMap map(FieldWalk({}).field());
  // The halfway line, the front of a penalty area, the walls and a corner.
  EXPECT_NEAR(map.distance({0.0125, 0.8}, kPi / 2), 0, 0.02);
  EXPECT_NEAR(map.distance({-1.6, 0.2}, kPi / 2), 0, 0.02);
  EXPECT_NEAR(map.distance({0.7, 1.35}, 0), 0, 0.02);
  EXPECT_NEAR(map.distance({2.1, -0.8}, kPi / 2), 0, 0.02);
  EXPECT_NEAR(map.distance({1.95, 1.2}, -kPi / 4), 0, 0.02);
  // Walls end at the goals, in which nothing is white.
  EXPECT_GT(map.distance({2.1, 0.1}, NAN), -1);
  EXPECT_NEAR(map.distance({-0.9, 0}, NAN), FieldEdgeMap::kMaximum, 0.01);
}

TEST(FieldEdges, areFarAwayInAnotherDirection) {
  const FieldEdgeMap map(FieldWalk({}).field());
  EXPECT_GT(map.distance({0.7, 1.35}, kPi / 2), 0.4);
  EXPECT_NEAR(map.distance({0.7, 1.25}, NAN), 0.1, 0.02);
  EXPECT_NEAR(map.distance({0.7, 1.25}, kPi), map.distance({0.7, 1.25}, 0), 1e-9);
  EXPECT_DOUBLE_EQ(map.distance({9, 9}, 0), FieldEdgeMap::kMaximum);
  EXPECT_DOUBLE_EQ(map.distance({NAN, 0}, 0), FieldEdgeMap::kMaximum);
}

TEST(FieldEdges, theNearestOneIsOfASimilarDirection) {
  const FieldEdgeMap map(FieldWalk({}).field());
  const auto edge = map.nearestEdge({0.3, 1.2}, 0.1);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->direction(), 0, 1e-9);
  EXPECT_NEAR(edge->start.y(), 1.35, 1e-9);
  EXPECT_FALSE(map.nearestEdge({0.9, 0.6}, 0.8));
}

TEST(LandmarkMemory, twoLandmarksDetermineThePose) {
  const Pose2 robot{0.4, -0.3, 2.1};
  const Vector2 first(-2.2, 1.45), second(0, 1.45);
  const Pose2 found =
      LandmarkMemory::poseFrom(first, robot.inverse() * first, second, robot.inverse() * second);
  EXPECT_NEAR(found.x, robot.x, 1e-9);
  EXPECT_NEAR(found.y, robot.y, 1e-9);
  EXPECT_NEAR(found.heading, robot.heading, 1e-9);
}

TEST(LandmarkMemory, forgetsWhatItSawLongAgoAndKeepsTheNewestSighting) {
  LandmarkMemory memory;
  const std::vector<LandmarkMeasurement> a{{{1, 0}, 0, 1, 1, false}}, b{{{2, 0}, 0, 2, 1, false}};
  memory.add(0, {}, a, 2);
  memory.add(1, {0.5, 0, 0}, b, 2);
  ASSERT_EQ(memory.sightings().size(), 2U);
  EXPECT_NEAR(memory.sightings()[1].inOdometry.x(), 2.5, 1e-9);
  memory.add(2.5, {1, 0, 0}, b, 2);
  ASSERT_EQ(memory.sightings().size(), 1U);
  EXPECT_NEAR(memory.sightings()[0].inOdometry.x(), 3, 1e-9);
}

TEST(OdometryBuffer, interpolatesBetweenItsPoses) {
  OdometryBuffer buffer;
  EXPECT_EQ(buffer.at(1), Pose2{});
  buffer.add(1, {0, 0, 0});
  buffer.add(2, {1, 0, 0.2});
  buffer.add(1.5, {7, 7, 7});
  EXPECT_NEAR(buffer.at(1.5).x, 0.5, 1e-9);
  EXPECT_NEAR(buffer.at(1.5).heading, 0.1, 1e-9);
  EXPECT_EQ(buffer.at(0), (Pose2{0, 0, 0}));
  EXPECT_NEAR(buffer.at(5).x, 1, 1e-9);
}

}  // namespace
}  // namespace modules
