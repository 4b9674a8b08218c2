// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/mapping/ScanMatcher.h"

#include <gtest/gtest.h>

#include "tests/modules/mapping/Building.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

/// A map that a robot has made of a building from one place, with the true pose.
class MatcherTest : public testing::Test {
 protected:
  std::vector<RangeBeam> scanAt(const Pose2& pose) const {
    std::vector<RangeBeam> scan;
    const RollingRobot robot(world_, {.start = pose});
    for (const RangeBeam& beam : robot.beams()) {
      if (beam.openingAngle == 0) scan.push_back(beam);
    }
    return scan;
  }
  void add(const Pose2& pose) {
    map_.insert(pose, scanAt(pose));
    matcher_.follow(map_, options_);
  }

  robotlink::GroundMap truth_ = buildingMap();
  FlatWorld world_{truth_};
  OccupancyMap map_{{}};
  ScanMatcher matcher_;
  ScanMatcher::Options options_;
};

TEST_F(MatcherTest, aScanIsPutWhereItFits) {
  for (const double heading : {0.0, 1.6, 3.1, -1.5}) add({3.5, 2, heading});
  const Pose2 pose{3.6, 2.1, 0.2};
  const Pose2 predicted{3.75, 1.98, 0.12};
  const ScanMatcher::Match match = matcher_.match(predicted, scanAt(pose), options_);
  EXPECT_TRUE(match.accepted);
  EXPECT_GT(match.score, 0.7);
  EXPECT_LT((match.robotInMap.translation() - pose.translation()).norm(), 0.03);
  EXPECT_NEAR(pose.heading, match.robotInMap.heading, 0.02);
}

TEST_F(MatcherTest, alongACorridorThePredictionCounts) {
  robotlink::GroundMap corridor;
  addWall(corridor, -40, 1, 40, 1);
  addWall(corridor, -40, -1, 40, -1);
  truth_ = corridor;
  world_ = FlatWorld(truth_);
  for (double x = -3; x <= 3; x += 0.25) add({x, 0, 0});
  const Pose2 predicted{0.4, 0.08, 0.02};
  const ScanMatcher::Match match = matcher_.match(predicted, scanAt({0.5, 0, 0}), options_);
  EXPECT_TRUE(match.accepted);
  EXPECT_NEAR(0, match.robotInMap.y, 0.03);
  EXPECT_NEAR(0.4, match.robotInMap.x, 0.06) << "nothing along the corridor says otherwise";
}

TEST_F(MatcherTest, whatFitsNowhereIsNotAccepted) {
  add({3.5, 2, 0});
  const Pose2 elsewhere{100, 100, 0};
  const ScanMatcher::Match match = matcher_.match(elsewhere, scanAt({3.5, 2, 0}), options_);
  EXPECT_FALSE(match.accepted);
  EXPECT_EQ(elsewhere, match.robotInMap);
}

TEST_F(MatcherTest, aScanThatHitNothingIsNotAccepted) {
  add({3.5, 2, 0});
  std::vector<RangeBeam> scan = scanAt({3.5, 2, 0});
  for (RangeBeam& beam : scan) beam.range = beam.maximum;
  EXPECT_FALSE(matcher_.match({3.5, 2, 0}, scan, options_).accepted);
  EXPECT_FALSE(ScanMatcher().match({3.5, 2, 0}, scanAt({3.5, 2, 0}), options_).accepted) << "without a map";
}

TEST_F(MatcherTest, changesOfTheMapAreFollowedAsIfItWereNew) {
  for (const double heading : {0.0, 1.6, 3.1, -1.5, 0.7}) add({3.5, 2, heading});
  // A wall that was nowhere, and then is gone again.
  const std::vector<RangeBeam> wall(5, {.sensorInRobot = {0, 0, 0}, .range = 1, .maximum = 32, .time = {}});
  map_.insert({3.5, 2, 0}, wall);
  matcher_.follow(map_, options_);
  for (int i = 0; i < 10; ++i) add({3.5, 2, 0});
  ScanMatcher another;
  another.follow(map_, options_);
  const auto scan = scanAt({3.55, 2.05, 0.05});
  const auto followed = matcher_.match({3.5, 2, 0}, scan, options_),
             fresh = another.match({3.5, 2, 0}, scan, options_);
  EXPECT_EQ(fresh.robotInMap, followed.robotInMap);
  EXPECT_EQ(fresh.score, followed.score);
}

}  // namespace
}  // namespace modules
