// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/RangeMemory.h"

#include <gtest/gtest.h>

#include "tests/modules/driving/RollingRobot.h"

namespace modules {
namespace {

using robotlink::Instant;
using robotlink::Pose2;
using robotlink::radians;
using robotlink::Vector2;

Instant at(double seconds) {
  return Instant(robotlink::fromSeconds(seconds));
}

RangeBeam cone(double bearing, double range, double time) {
  return {{0, 0, bearing}, range, 5, radians(30), at(time)};
}

/// A scan of 91 rays from -45 to 45 degrees, all alike.
std::vector<RangeBeam> scan(double range, double time) {
  std::vector<RangeBeam> rays;
  for (int i = -45; i <= 45; ++i) rays.push_back({{0, 0, radians(i)}, range, 8, 0, at(time)});
  return rays;
}

double nearestBearing(const std::vector<Vector2>& points, double bearing) {
  double least = 10;
  for (const Vector2& point : points)
    least = std::min(least, std::abs(robotlink::normalizedAngle(std::atan2(point.y(), point.x()) - bearing)));
  return least;
}

class RangeMemoryTest : public testing::Test {
 protected:
  void stand(double seconds, const Pose2& pose = {}) { odometry_.add(at(seconds), pose); }
  void see(const std::vector<RangeBeam>& beams) { memory_.see(beams, odometry_); }
  OdometryHistory odometry_;
  RangeMemory memory_{{}};
};

TEST_F(RangeMemoryTest, pointsStayWhereTheyWereSeenWhileTheRobotMoves) {
  stand(0);
  see({cone(0, 2, 0)});
  const auto points = memory_.pointsInRobot({1, 0, 0});
  ASSERT_FALSE(points.empty());
  for (const Vector2& point : points) EXPECT_NEAR(1, point.x(), 0.05);
}

TEST_F(RangeMemoryTest, aReadingIsPlacedWhereTheRobotWasThen) {
  stand(0, {0, 0, 0});
  stand(0.1, {0.1, 0, 0});
  see({cone(0, 1, 0.05)});
  EXPECT_NEAR(1.05, memory_.pointsInRobot({}).front().x(), 0.02);
}

TEST_F(RangeMemoryTest, withoutOdometryForItsTimeAReadingIsLeftOut) {
  see({cone(0, 1, 0)});
  EXPECT_TRUE(memory_.pointsInRobot({}).empty());
  EXPECT_FALSE(memory_.newest().has_value());
  stand(100);
  see({cone(0, 1, 5)});
  EXPECT_TRUE(memory_.pointsInRobot({}).empty());
}

TEST_F(RangeMemoryTest, aNewScanReplacesTheOldOneWithinItsAngleOnly) {
  stand(0);
  see(scan(1, 0));
  // The robot turns by 60 degrees: 30 of the 90 are still seen.
  stand(0.5, {0, 0, radians(60)});
  see(scan(3, 0.5));
  int near = 0, far = 0;
  for (const Vector2& point : memory_.pointsInRobot({0, 0, radians(60)})) (point.norm() < 2 ? near : far)++;
  EXPECT_GT(far, 50);
  EXPECT_GT(near, 15);
  EXPECT_LT(near, 31);
}

TEST_F(RangeMemoryTest, aLongerEchoClearsWhatAShorterOneSaw) {
  stand(0);
  see({cone(0, 1, 0)});
  see({cone(0, 3, 0.1)});
  for (const Vector2& point : memory_.pointsInRobot({})) EXPECT_GT(point.norm(), 2.5);
}

TEST_F(RangeMemoryTest, whatOtherConesFoundFreeTellsWhereAnEchoCameFrom) {
  stand(0);
  // The one ahead finds nothing for 3 m; that at its left has an echo at 1 m, so it came from further left.
  see({cone(0, 3, 0), cone(radians(20), 1, 0.04)});
  double least = 10;
  for (const Vector2& point : memory_.pointsInRobot({}))
    if (point.norm() < 2) least = std::min(least, std::atan2(point.y(), point.x()));
  EXPECT_GT(least, radians(14));
  EXPECT_LT(least, radians(35));
}

TEST_F(RangeMemoryTest, anEchoOfWhatTheLaserSeesIsTheLasers) {
  stand(0);
  see(scan(1, 0));
  const std::size_t before = memory_.pointsInRobot({}).size();
  see({cone(radians(30), 1.1, 0.05)});
  EXPECT_EQ(before, memory_.pointsInRobot({}).size());
  // Something low stands before it.
  see({cone(radians(30), 0.5, 0.1)});
  EXPECT_GT(memory_.pointsInRobot({}).size(), before);
}

TEST_F(RangeMemoryTest, itForgetsWhatIsOldOrFarButNotWhatALaserSawNearByAtOnce) {
  stand(0);
  see(scan(1, 0));
  see({cone(radians(180), 2, 0)});
  memory_.forget(at(5), {});
  EXPECT_LT(nearestBearing(memory_.pointsInRobot({}), 0), 0.05);
  EXPECT_GT(nearestBearing(memory_.pointsInRobot({}), radians(180)), 1);
  memory_.forget(at(11), {});
  EXPECT_TRUE(memory_.pointsInRobot({}).empty());
  see(scan(1, 0));
  memory_.forget(at(0.1), {20, 0, 0});
  EXPECT_TRUE(memory_.pointsInRobot({}).empty());
}

TEST_F(RangeMemoryTest, whatItTouchesIsRememberedLongest) {
  memory_.touch({0.32, 0}, {}, at(0));
  memory_.forget(at(5.5), {});
  EXPECT_EQ(1U, memory_.pointsInRobot({}).size());
  memory_.forget(at(7), {});
  EXPECT_TRUE(memory_.pointsInRobot({}).empty());
}

TEST_F(RangeMemoryTest, memoryIsBounded) {
  for (int i = 0; i < 20'000; ++i) {
    stand(0.001 * i);
    memory_.see(std::vector{cone(0.001 * i, 0.5 + 0.0002 * i, 0.001 * i)}, odometry_);
  }
  EXPECT_LE(memory_.pointsInRobot({}).size(), 3000U);
}

}  // namespace
}  // namespace modules
