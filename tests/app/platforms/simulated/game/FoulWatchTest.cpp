// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/game/FoulWatch.h"

#include <gmock/gmock.h>

#include "app/core/program/RobotFiles.h"
#include "robotlink/config/FieldDescription.h"

using namespace app;
using robotlink::Vector2;
using Robots = std::vector<FoulWatch::Robot>;

namespace {

/// A red robot that moves toward a blue one, which may give way.
class Pushing : public testing::Test {
 protected:
  Pushing() {
    rules_.penalties = {{"pushing", GameRules::Watch::kPushing, std::chrono::seconds(2), {}},
                        {"leaving", GameRules::Watch::kLeaving, std::chrono::seconds(1), {}},
                        {"defending", GameRules::Watch::kDefending, std::chrono::seconds(3), {}},
                        {"holding", GameRules::Watch::kHolding, std::chrono::seconds(4), {}}};
    rules_.holdingDistance = 0.09;
    rules_.pushingSpeed = 0.02;
    rules_.pushingNearBall = 0.25;
    rules_.leavingMargin = 0.1;
    watch_.restart(2);
  }

  /// Seconds until the first foul, at most 10.
  double untilFoul(Robots robots, double speed, double otherSpeed, const Vector2& ball,
                   bool touching = true) {
    const double period = robotlink::seconds(FoulWatch::kEvery);
    for (double time = 0; time < 10; time += period) {
      const auto fouls = watch_.look(robots, ball, [&](auto, auto) { return touching; });
      if (!fouls.empty()) {
        robot_ = fouls.front().robot;
        reason_ = fouls.front().penalty->reason;
        return time;
      }
      robots[0].place.x() += speed * period;
      robots[1].place.x() += otherSpeed * period;
    }
    return 10;
  }
  static Robots both(const Vector2& red = {-0.1, 0}) {
    return {{0, 0, -1, false, red}, {1, 1, 1, false, red + Vector2(0.3, 0)}};
  }

  GameRules rules_;
  std::shared_ptr<const robotlink::FieldDescription> field_ = readField(fieldFile("2002")).value();
  FoulWatch watch_{rules_, *field_};
  std::size_t robot_ = 99;
  std::string reason_;
  const Vector2 farBall_{1.5, 1};
};

}  // namespace

TEST_F(Pushing, whoMovesAnOpponentForTooLongIsPenalized) {
  EXPECT_NEAR(untilFoul(both(), 0.05, 0.05, farBall_), 2, 0.2);
  EXPECT_EQ(robot_, 0U);
  EXPECT_EQ(reason_, "pushing");
}

TEST_F(Pushing, isNothingWhereNobodyGivesWayOrTouches) {
  EXPECT_EQ(untilFoul(both(), 0.05, 0, farBall_), 10) << "the other stands like a wall";
  EXPECT_EQ(untilFoul(both(), 0.05, 0.05, farBall_, false), 10);
  EXPECT_EQ(untilFoul(both(), 0.01, 0.01, farBall_), 10) << "too slow";
}

TEST_F(Pushing, isAllowedNearTheBallAndToAGoalkeeperAtHome) {
  Robots robots = both();
  robots[0].place = {-2, 0};
  robots[1].place = {-1.7, 0};
  robots[0].isGoalie = true;
  EXPECT_EQ(untilFoul(robots, 0.03, 0.03, farBall_), 10);
  Robots others = both();
  EXPECT_EQ(untilFoul(others, 0, 0, others[0].place + Vector2(0.1, 0)), 10);
}

TEST_F(Pushing, thoseOfOneTeamMayPushEachOther) {
  Robots robots = both();
  robots[1].team = 0;
  EXPECT_EQ(untilFoul(robots, 0.05, 0.05, farBall_), 10);
}

TEST_F(Pushing, whoIsOutsideForTooLongHasLeft) {
  EXPECT_NEAR(untilFoul(both({0, 1.6}), 0, 0, farBall_), 1, 0.1);
  EXPECT_EQ(reason_, "leaving");
  watch_.restart(2);
  EXPECT_EQ(untilFoul({{0, 0, -1, false, {2.3, 0}}, {1, 1, 1, false, {0, 0}}}, 0, 0, farBall_), 10)
      << "a robot in a goal is not outside";
}

TEST_F(Pushing, aFieldPlayerMayNotHelpItsGoalkeeperInThePenaltyArea) {
  Robots robots = both();
  robots[1].team = 0;
  robots[1].ownSide = -1;
  robots[0].place = {-1.8, 0};
  robots[1].place = {-1.8, 0.4};
  EXPECT_EQ(untilFoul(robots, 0, 0, farBall_), 10) << "two field players";
  robots[1].isGoalie = true;
  EXPECT_NEAR(untilFoul(robots, 0, 0, farBall_), 3, 0.2);
  EXPECT_EQ(robot_, 0U) << "the goalkeeper may";
  EXPECT_EQ(reason_, "defending");
  robots[1].place = {-1, 0.4};
  EXPECT_EQ(untilFoul(robots, 0, 0, farBall_), 10) << "the goalkeeper has left it";
  robots[1] = {1, 1, 1, true, {-1.8, 0.4}};
  EXPECT_EQ(untilFoul(robots, 0, 0, farBall_), 10) << "it is the goalkeeper of the others";
}

TEST_F(Pushing, aBallMayNotStayUnderARobot) {
  EXPECT_NEAR(untilFoul(both(), 0, 0, both()[1].place + Vector2(0.05, 0.05)), 4, 0.2);
  EXPECT_EQ(robot_, 1U);
  EXPECT_EQ(reason_, "holding");
  watch_.restart(2);
  EXPECT_EQ(untilFoul(both(), 0, 0, both()[1].place + Vector2(0.16, 0)), 10) << "it lies before its paws";
}
