// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/mapping/OccupancyMap.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/modules/mapping/Building.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

RangeBeam rayOf(double heading, double range, double maximum = 32) {
  return {
      .sensorInRobot = {0, 0, heading}, .range = range, .maximum = maximum, .openingAngle = 0, .time = {}};
}

bool isOccupied(const OccupancyMap& map, double x, double y) {
  return map.occupied(map.frame().column(x), map.frame().row(y));
}

int percentAt(const OccupancyMap& map, double x, double y) {
  return map.percent(map.frame().column(x), map.frame().row(y));
}

TEST(OccupancyMap, aRayEndsAtSomethingAndPassesWhatIsFree) {
  OccupancyMap map({});
  const RangeBeam ray = rayOf(0, 2.02);
  ASSERT_TRUE(map.insert({1, 1, 0}, std::span(&ray, 1)));
  EXPECT_TRUE(isOccupied(map, 3.02, 1));
  EXPECT_FALSE(isOccupied(map, 2, 1));
  EXPECT_GT(percentAt(map, 3.02, 1), 50);
  EXPECT_LT(percentAt(map, 2, 1), 50);
  EXPECT_GE(percentAt(map, 2, 1), 0);
  EXPECT_EQ(-1, percentAt(map, 2, 2)) << "nothing has been seen there";
}

TEST(OccupancyMap, itGrowsAndWhatWasThereStays) {
  OccupancyMap map({});
  const RangeBeam near = rayOf(0.3, 1.5), far = rayOf(3.9, 30);
  map.insert({}, std::span(&near, 1));
  const Vector2 end = near.endInRobot();
  ASSERT_TRUE(isOccupied(map, end.x(), end.y()));
  map.insert({}, std::span(&far, 1));
  EXPECT_TRUE(isOccupied(map, end.x(), end.y()));
  EXPECT_TRUE(isOccupied(map, far.endInRobot().x(), far.endInRobot().y()));
}

TEST(OccupancyMap, whatHasGoneAwayIsForgotten) {
  OccupancyMap map({});
  const RangeBeam before = rayOf(0, 2), after = rayOf(0, 4);
  for (int i = 0; i < 100; ++i) map.insert({}, std::span(&before, 1));
  EXPECT_TRUE(isOccupied(map, 2.01, 0.01));
  for (int i = 0; i < 15; ++i) map.insert({}, std::span(&after, 1));
  EXPECT_FALSE(isOccupied(map, 2.01, 0.01));
  EXPECT_TRUE(isOccupied(map, 4.01, 0.01));
}

TEST(OccupancyMap, raysOfAScanDoNotClearWhereOthersOfItEnd) {
  // Rays that nearly graze a wall pass the cells where their neighbors end.
  OccupancyMap map({});
  std::vector<RangeBeam> scan;
  for (double x = 1; x < 8; x += 0.05) scan.push_back(rayOf(std::atan2(0.5, x), std::hypot(0.5, x)));
  map.insert({0, 0.03, 0}, scan);
  for (double x = 1.05; x < 7.9; x += 0.3) EXPECT_TRUE(isOccupied(map, x, 0.53)) << x;
}

TEST(OccupancyMap, changesAreThoseOfTheLastScan) {
  OccupancyMap map({});
  const RangeBeam ray = rayOf(0, 2.02);
  map.insert({}, std::span(&ray, 1));
  ASSERT_EQ(1U, map.changes().size());
  EXPECT_EQ(map.frame().column(2.02), map.changes()[0].column);
  EXPECT_EQ(map.frame().row(0.01), map.changes()[0].row);
  map.insert({}, std::span(&ray, 1));
  EXPECT_TRUE(map.changes().empty());
}

TEST(OccupancyMap, isBoundedWhateverTheRaysSay) {
  OccupancyMap map({.mostCells = 200'000});
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  const RangeBeam far = rayOf(0, 900, 1000), none = rayOf(kNan, 3), wide = rayOf(0, 1e300, 1e301);
  EXPECT_FALSE(map.insert({}, std::span(&far, 1)));
  EXPECT_FALSE(map.insert({}, std::span(&none, 1)));
  EXPECT_FALSE(map.insert({}, std::span(&wide, 1)));
  EXPECT_LE(map.frame().size(), 200'000U);
}

}  // namespace
}  // namespace modules
