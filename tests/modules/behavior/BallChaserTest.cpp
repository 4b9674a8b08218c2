// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/behavior/BallChaser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;
using State = BallChaser::State;
using Motion = Intention::Motion;

constexpr double kChaserFrame = 0.04;

/// A robot without inertia that does what the chaser wants, and a ball that moves when it is kicked.
class BallChaserTest : public testing::Test {
 protected:
  Situation situation() {
    Situation now;
    now.time = time_;
    now.fieldSeen = !blind_;
    now.ball = robot_.inverse() * ball_;
    const bool inView = std::abs(std::atan2(now.ball.y(), now.ball.x())) < robotlink::radians(110);
    if (!blind_ && inView && now.ball.norm() < 2) seenAt_ = time_;
    now.ballKnown = seenAt_ >= 0 && time_ - seenAt_ < 4;
    now.ballAge = time_ - seenAt_;
    if (goalKnown_) now.goal = robot_.inverse() * Vector2(2.1, 0);
    now.kicking = time_ < kickEnds_;
    now.stable = !now.kicking;
    now.fallen = fallen_;
    return now;
  }
  Intention step() {
    const Intention wanted = chaser_.decide(situation());
    if (chaser_.changed()) visited_.push_back(chaser_.state());
    if (wanted.motion == Motion::kWalk)
      robot_ = robot_ *
               Pose2{wanted.forward * kChaserFrame, wanted.left * kChaserFrame, wanted.turn * kChaserFrame};
    if (wanted.motion == Motion::kKick && time_ >= kickEnds_) {
      kickEnds_ = time_ + 1;
      ball_ = robot_ * ((robot_.inverse() * ball_) + Vector2(0.6, 0));
      ++kicks_;
    }
    way_ = std::max(way_, robot_.translation().norm());
    time_ += kChaserFrame;
    return wanted;
  }
  void run(double seconds) {
    for (const double end = time_ + seconds; time_ < end && kicks_ == 0;) step();
  }
  bool visited(State state) const { return std::ranges::find(visited_, state) != visited_.end(); }

  BallChaser chaser_{{}};
  Pose2 robot_;
  Vector2 ball_{1, 0};
  double time_ = 0, seenAt_ = -1, kickEnds_ = -1, way_ = 0;
  bool blind_ = false, goalKnown_ = false, fallen_ = false;
  int kicks_ = 0;
  std::vector<State> visited_;
};

TEST_F(BallChaserTest, kicksABallAnywhereAround) {
  for (int i = 0; i < 12; ++i) {
    SetUp();
    chaser_ = BallChaser({});
    robot_ = {};
    time_ = 0, seenAt_ = kickEnds_ = -1, kicks_ = 0;
    ball_ = Vector2(1.2 * std::cos(i * robotlink::kPi / 6), 1.2 * std::sin(i * robotlink::kPi / 6));
    run(40);
    EXPECT_EQ(kicks_, 1) << "direction " << i * 30;
  }
}

TEST_F(BallChaserTest, kicksTowardsTheGoalIfItKnowsWhereThatIs) {
  goalKnown_ = true;
  for (const Vector2& place : {Vector2(1, 0.5), Vector2(-1, 0), Vector2(0.2, -0.9)}) {
    chaser_ = BallChaser({});
    robot_ = {};
    time_ = 0, seenAt_ = kickEnds_ = -1, kicks_ = 0;
    ball_ = place;
    while (time_ < 60 && kicks_ == 0) step();
    ASSERT_EQ(kicks_, 1) << place.transpose();
    const Vector2 goal = robot_.inverse() * Vector2(2.1, 0);
    EXPECT_LT(std::abs(std::atan2(goal.y(), goal.x())), 0.6) << place.transpose();
  }
}

TEST_F(BallChaserTest, looksForTheGoalWhenItIsNearTheBallAndKicksAnywayIfItFindsNone) {
  run(40);
  EXPECT_TRUE(visited(State::kGlance));
  EXPECT_EQ(std::ranges::count(visited_, State::kGlance), 1);
  EXPECT_EQ(kicks_, 1);
}

TEST_F(BallChaserTest, standsStillWhileItIsBlind) {
  blind_ = true;
  for (int i = 0; i < 1500; ++i) EXPECT_EQ(step().motion, Motion::kStand);
  EXPECT_EQ(chaser_.state(), State::kBlind);
}

TEST_F(BallChaserTest, goesOnWhenItSeesAgain) {
  blind_ = true;
  run(5);
  blind_ = false;
  run(30);
  EXPECT_EQ(kicks_, 1);
}

TEST_F(BallChaserTest, turnsBeforeItLeavesItsPlaceToSearch) {
  ball_ = {50, 0};
  run(11);
  EXPECT_TRUE(visited(State::kTurn));
  EXPECT_LT(way_, 0.01);
  run(10);
  EXPECT_TRUE(visited(State::kWander));
  EXPECT_LT(way_, 0.6);
}

TEST_F(BallChaserTest, turnsTowardsTheSideWhereTheBallWasLast) {
  ball_ = {0.6, -0.5};
  run(1);
  ball_ = {50, -50};
  while (time_ < 20 && chaser_.state() != State::kTurn) step();
  EXPECT_LT(step().turn, 0);
}

TEST_F(BallChaserTest, getsUpWhenItFellAndSearchesThen) {
  run(1);
  fallen_ = true;
  EXPECT_EQ(step().motion, Motion::kGetUp);
  fallen_ = false;
  step();
  EXPECT_EQ(chaser_.state(), State::kLookAbout);
}

TEST_F(BallChaserTest, saysWhyItChanges) {
  step();
  EXPECT_TRUE(chaser_.changed());
  EXPECT_FALSE(chaser_.reason().empty());
  EXPECT_STREQ(name(State::kGetUp), "get up");
}

TEST_F(BallChaserTest, givesUpAKickThatNeverEnds) {
  ball_ = {0.155, 0};
  run(6);
  ASSERT_EQ(kicks_, 1);
  kickEnds_ = 1000;
  for (int i = 0; i < 200; ++i) step();
  EXPECT_NE(chaser_.state(), State::kKick);
}

}  // namespace
}  // namespace modules
