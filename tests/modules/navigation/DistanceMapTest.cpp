// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/navigation/DistanceMap.h"

#include <gtest/gtest.h>

#include "FlatWorld.h"
#include "modules/navigation/LikelihoodField.h"
#include "modules/navigation/ReachableSpace.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::radians;
using robotlink::Vector2;

GroundMap::Place place(GroundMap::Place::Kind kind, double x1, double y1, double x2, double y2) {
  GroundMap::Place result;
  result.kind = kind;
  result.extent = {{x1, y1}, {x2, y2}};
  return result;
}

TEST(DistanceMap, distancesAreThoseToTheNearestWall) {
  const GroundMap map = roomMap(8, 5);
  const DistanceMap distances(map, {});
  for (const Vector2& at : {Vector2(4, 2.5), Vector2(1, 2), Vector2(7.2, 4.4), Vector2(0.3, 0.4)}) {
    const double expected = std::min({at.x(), 8 - at.x(), at.y(), 5 - at.y()});
    EXPECT_NEAR(expected, distances.at(at), 0.06) << at.transpose();
  }
  EXPECT_EQ(DistanceMap::kFar, distances.at({100, 100}));
}

TEST(DistanceMap, itAgreesWithRaysThatKnowNoGrid) {
  GroundMap map = roomMap(8, 5);
  addWall(map, 2, 1, 3, 4);
  map.points = {{6, 2.5}, {6.02, 2.5}};
  const DistanceMap distances(map, {});
  const FlatWorld world(map);
  for (int i = 0; i < 60; ++i) {
    const Pose2 sensor{4, 2.2, i * radians(6)};
    const double expected = world.ray(sensor, 10);
    // Two ways past a corner are alike; a grid may take the other.
    const double beside =
        std::min(std::abs(world.ray({4, 2.26, sensor.heading}, 10) - distances.range(sensor, 0, 10)),
                 std::abs(world.ray({4, 2.14, sensor.heading}, 10) - distances.range(sensor, 0, 10)));
    EXPECT_LT(std::min(beside, std::abs(expected - distances.range(sensor, 0, 10))), 0.15) << i;
  }
}

TEST(DistanceMap, aRayDoesNotPassBetweenTheCellsOfASlantingWall) {
  // The wall is one cell thick, and its cells touch at their corners only where it slants by 45 degrees.
  for (const double slant : {20.0, 45.0, 70.0, 110.0, 135.0}) {
    GroundMap map = roomMap(8, 8);
    const double c = std::cos(radians(slant)), s = std::sin(radians(slant));
    addWall(map, 4 - 3 * c, 4 - 3 * s, 4 + 3 * c, 4 + 3 * s);
    const DistanceMap distances(map, {});
    const FlatWorld world(map);
    int passed = 0;
    for (int i = 0; i < 2000; ++i) {
      // From many places on one side toward the middle half of the wall.
      const Vector2 aim = Vector2(4, 4) + Vector2(c, s) * (1.5 * std::sin(0.37 * i));
      const double heading = radians(slant) + radians(90 + 55 * std::sin(0.11 * i));
      const double away = 0.3 + 0.0011 * i / 2;
      const Pose2 sensor{aim.x() - away * std::cos(heading), aim.y() - away * std::sin(heading), heading};
      const double expected = world.ray(sensor, 12);
      if (expected < away - 0.2) continue;  // another wall is before it
      if (std::abs(distances.range(sensor, 0, 12) - expected) > 0.15) ++passed;
    }
    EXPECT_EQ(passed, 0) << "at a slant of " << slant << " degrees";
  }
}

TEST(DistanceMap, aConeMeetsWhatIsBesideItsAxis) {
  GroundMap map = roomMap(8, 5);
  addWall(map, 4, 2.8, 4, 4);
  const DistanceMap distances(map, {});
  const Pose2 sensor{2, 2.5, 0};
  EXPECT_NEAR(5, distances.range(sensor, 0, 5), 0.1);
  EXPECT_NEAR(2, distances.range(sensor, radians(30), 5), 0.15);
  EXPECT_EQ(1, distances.range(sensor, radians(30), 1));
}

TEST(DistanceMap, forbiddenLinesAndTurnedAreasAreWallsIfAskedFor) {
  GroundMap map = roomMap(10, 10);
  map.places.push_back(place(GroundMap::Place::Kind::kForbiddenLine, 2, 2, 2, 8));
  // A square of 1 m about (0, 7) in a frame that is turned by 45 degrees.
  GroundMap::Place area = place(GroundMap::Place::Kind::kForbiddenArea, 6.5, -0.5, 7.5, 0.5);
  area.pose.heading = radians(45);
  map.places.push_back(area);
  const DistanceMap without(map, {});
  DistanceMap::Options options;
  options.forbidden = true;
  const DistanceMap with(map, options);
  const Vector2 inArea(7 * std::sqrt(0.5), 7 * std::sqrt(0.5));
  EXPECT_GT(without.at({2, 5}), 1.9);
  EXPECT_LT(with.at({2, 5}), 0.06);
  EXPECT_GT(without.at(inArea), 1);
  EXPECT_EQ(with.at(inArea), 0);
}

TEST(DistanceMap, aPointFarAwayDoesNotCostAllMemory) {
  GroundMap map = roomMap(8, 5);
  map.points = {{3e6, -2e6}};
  DistanceMap::Options options;
  options.mostCells = 10'000;
  const DistanceMap distances(map, options);
  EXPECT_LE(distances.frame().size(), 11'000U);
  EXPECT_GT(distances.frame().cell, 1);
}

TEST(DistanceMap, anEmptyMapHasNoWalls) {
  const DistanceMap distances(GroundMap{}, {});
  EXPECT_EQ(DistanceMap::kFar, distances.at({0, 0}));
  EXPECT_EQ(5, distances.range({0, 0, 0}, radians(30), 5));
  EXPECT_TRUE(ReachableSpace(distances, GroundMap{}, 0.3).empty());
}

TEST(ReachableSpace, isInsideAndAwayFromWalls) {
  const GroundMap map = roomMap(8, 5);
  const DistanceMap distances(map, {});
  const ReachableSpace space(distances, map, 0.3);
  EXPECT_NEAR(7.4 * 4.4, space.area(), 1.5);
  EXPECT_TRUE(space.contains({4, 2}));
  EXPECT_FALSE(space.contains({0.1, 2}));
  EXPECT_FALSE(space.contains({-0.5, 2}));
  robotlink::Random random(1);
  for (int i = 0; i < 200; ++i) EXPECT_TRUE(space.contains(space.draw(random).translation()));
}

TEST(ReachableSpace, aGapInTheWallsDoesNotMakeAllOfTheWorldInside) {
  GroundMap map;
  addWall(map, 0, 0, 8, 0);
  addWall(map, 8, 0, 8, 5);
  addWall(map, 8, 5, 0, 5);
  addWall(map, 0, 5, 0, 3);
  addWall(map, 0, 1.5, 0, 0);
  GroundMap::Place home;
  home.kind = GroundMap::Place::Kind::kHome;
  home.pose = {4, 2.5, 0};
  map.places.push_back(home);
  const DistanceMap distances(map, {});
  const ReachableSpace space(distances, map, 0.3);
  EXPECT_TRUE(space.contains({4, 2.5}));
  EXPECT_FALSE(space.contains({-0.8, 2.2}));
  EXPECT_GT(space.area(), 20);
}

TEST(LikelihoodField, isBestAtWallsAndFallsOffTwiceAsSlowlyForTwiceTheDeviation) {
  const GroundMap map = roomMap(8, 5);
  const DistanceMap distances(map, {});
  LikelihoodField field(distances);
  field.setDeviation(0.1, 0.1);
  const float near = field.logLikelihood(4, 0.025F), away = field.logLikelihood(4, 0.225F);
  EXPECT_NEAR(0, near, 0.05);
  EXPECT_LT(away, -1);
  field.setDeviation(0.2, 0.1);
  EXPECT_GT(field.logLikelihood(4, 0.225F), away);
  EXPECT_NEAR(std::log(0.1), field.logLikelihood(1e30F, std::nanf("")), 1e-3);
}

}  // namespace
}  // namespace modules
