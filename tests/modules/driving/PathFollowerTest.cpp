// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/driving/PathFollower.h"

#include <gtest/gtest.h>

#include "modules/driving/SpeedLimiter.h"
#include "tests/modules/driving/RollingRobot.h"

namespace modules {
namespace {

using robotlink::GroundMap;
using robotlink::Pose2;
using robotlink::Vector2;

/// Drives in an empty world until it is there; the largest distance from the path on the way.
class Follower {
 public:
  explicit Follower(const Pose2& start) : robot_(world_, {.start = start, .skid = 0}) {}
  double run(const std::vector<Vector2>& path, std::optional<double> heading, double seconds) {
    double most = 0;
    for (double time = 0; time < seconds && follower_.state() != PathFollower::State::kThere; time += 0.1) {
      robot_.drive(limiter_.limit(follower_.decide(robot_.pose(), path, heading), robot_.limits(), 0.1));
      fastestNearGoal_ = (robot_.pose().translation() - path.back()).norm() < 0.15
                             ? std::max(fastestNearGoal_, robot_.velocity().forward)
                             : fastestNearGoal_;
      double least = 1e9;
      for (std::size_t i = 1; i < path.size(); ++i)
        for (int share = 0; share <= 50; ++share)
          least = std::min(
              least,
              (path[i - 1] + 0.02 * share * (path[i] - path[i - 1]) - robot_.pose().translation()).norm());
      most = std::max(most, least);
    }
    return most;
  }
  const Pose2& pose() const { return robot_.pose(); }
  PathFollower::State state() const { return follower_.state(); }
  double fastestNearGoal() const { return fastestNearGoal_; }

 private:
  FlatWorld world_{roomMap(40, 40)};
  RollingRobot robot_;
  PathFollower follower_{{}};
  SpeedLimiter limiter_;
  double fastestNearGoal_ = 0;
};

TEST(PathFollower, followsCornersClosely) {
  Follower follower({5, 5, 0});
  const std::vector<Vector2> path{{5, 5}, {9, 5}, {9, 8}, {6, 9}};
  EXPECT_LT(follower.run(path, {}, 60), 0.4);
  EXPECT_EQ(PathFollower::State::kThere, follower.state());
  EXPECT_LT((follower.pose().translation() - path.back()).norm(), 0.2);
}

TEST(PathFollower, slowsDownBeforeTheGoal) {
  Follower follower({5, 5, 0});
  follower.run({{5, 5}, {10, 5}}, {}, 60);
  EXPECT_EQ(PathFollower::State::kThere, follower.state());
  EXPECT_LT(follower.fastestNearGoal(), 0.35);
  EXPECT_NEAR(10, follower.pose().x, 0.2);
}

TEST(PathFollower, turnsOnTheSpotWhereThePathIsBehind) {
  Follower follower({10, 10, 0});
  EXPECT_LT(follower.run({{10, 10}, {6, 10}}, {}, 60), 0.2);
  EXPECT_EQ(PathFollower::State::kThere, follower.state());
}

TEST(PathFollower, takesTheHeadingOfTheGoalAtItsEnd) {
  Follower follower({5, 5, 0});
  follower.run({{5, 5}, {8, 6}}, -2.0, 60);
  EXPECT_EQ(PathFollower::State::kThere, follower.state());
  EXPECT_NEAR(-2.0, follower.pose().heading, 0.1);
}

TEST(PathFollower, withoutAPathItStandsAndANewGoalSetsItGoingAgain) {
  PathFollower follower({});
  EXPECT_EQ(DriveVelocity{}, follower.decide({}, {}, {}));
  EXPECT_EQ(PathFollower::State::kNoPath, follower.state());
  const std::vector<Vector2> here{{0, 0}, {0.05, 0}}, there{{0, 0}, {3, 0}};
  EXPECT_EQ(DriveVelocity{}, follower.decide({}, here, {}));
  EXPECT_EQ(PathFollower::State::kThere, follower.state());
  EXPECT_GT(follower.decide({}, there, {}).forward, 0.2);
  // A single point is a path of no length.
  EXPECT_EQ(DriveVelocity{}, follower.decide({3, 0, 0}, std::vector<Vector2>{{3, 0}}, {}));
}

TEST(PathFollower, neitherDrivesNorTurnsFasterThanItMay) {
  PathFollower::Options options;
  options.speed = 0;
  options.rotation = 0.05;
  PathFollower follower(options);
  const std::vector<Vector2> path{{0, 0}, {2, 0.2}};
  EXPECT_EQ(0, follower.decide({0, 0, 0}, path, {}).forward);
  EXPECT_NEAR(0.05, follower.decide({0, 0, -robotlink::kPi / 2}, path, {}).rotation, 1e-9);
  EXPECT_NEAR(0.05, follower.decide({2, 0.2, 0}, path, 1.0).rotation, 1e-9);
}

}  // namespace
}  // namespace modules
