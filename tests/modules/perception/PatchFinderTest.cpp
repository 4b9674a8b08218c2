// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/PatchFinder.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/modules/perception/FieldCamera.h"

namespace modules {
namespace {

using robotlink::Vector2;

class PatchFinderTest : public testing::Test {
 protected:
  PatchFinder finder_{{}};
  CameraView view_ = FieldCamera::view({robotlink::radians(-10), 0, 0});
  std::array<int, 2> teams_{1, 2};

  /// A square patch of a class around a point in space.
  colortool::Region patch(int colorClass, const Vector2& place, int size) const {
    const Vector2 at = view_.pixelOf({place.x(), place.y(), 0.13}).value();
    const int left = static_cast<int>(at.x()) - size / 2, top = static_cast<int>(at.y()) - size / 2;
    return {colorClass, size * size, left, top, left + size, top + size, at.x(), at.y()};
  }
};

TEST_F(PatchFinderTest, placesAPatchByItsHeightOnTheBody) {
  const std::array regions{patch(2, {0.8, 0.2}, 8)};
  const auto robots = finder_.findPatches(regions, teams_, view_);
  ASSERT_EQ(robots.size(), 1U);
  EXPECT_EQ(robots[0].teamClass, 2);
  EXPECT_NEAR((robots[0].positionInRobot - Vector2(0.8, 0.2)).norm(), 0, 0.01);
}

TEST_F(PatchFinderTest, joinsThePatchesOfOneRobotButNotOfTwoTeams) {
  const std::array regions{patch(1, {0.8, 0.2}, 8), patch(1, {0.9, 0.2}, 8), patch(1, {0.8, -0.4}, 6),
                           patch(2, {0.85, 0.2}, 8)};
  EXPECT_EQ(finder_.findPatches(regions, teams_, view_).size(), 4U);
  const auto robots = finder_.findClusters(regions, teams_, view_);
  ASSERT_EQ(robots.size(), 3U);
  EXPECT_NEAR((robots[0].positionInRobot - Vector2(0.85, 0.2)).norm(), 0, 0.01);
  EXPECT_GT(robots[0].confidence, robots[1].confidence);
}

TEST_F(PatchFinderTest, ignoresSpecksOtherColorsAndItself) {
  const std::array regions{patch(1, {0.8, 0}, 2), patch(3, {0.8, 0}, 9), patch(1, {0.2, 0}, 9)};
  EXPECT_TRUE(finder_.findPatches(regions, teams_, view_).empty());
}

TEST_F(PatchFinderTest, seesARedRobotOnTheField) {
  FieldCamera world;
  world.putBall({0, 40});
  const std::array<int, 2> teams{world.classes().index("red"), world.classes().index("blue")};
  world.putRobot({0.7, 0.1, 1.2});
  world.look({0, 0, 0}, view_);
  const auto robots = finder_.findClusters(world.regions(), teams, view_);
  ASSERT_GE(robots.size(), 1U);
  EXPECT_EQ(robots[0].teamClass, teams[0]);
  EXPECT_LT((robots[0].positionInRobot - Vector2(0.7, 0.1)).norm(), 0.2);
}

}  // namespace
}  // namespace modules
