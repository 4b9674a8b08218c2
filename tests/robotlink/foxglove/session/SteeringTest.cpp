// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/session/Steering.h"

#include <gmock/gmock.h>

#include <set>

namespace robotlink::websocket {
namespace {

using namespace std::chrono_literals;
using robotcontrol::MotionRequest;
using robotcontrol::Request;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Request walk(double speed = 0.1) {
  Request request;
  request.set_robot("red1");
  request.mutable_motion()->mutable_motion()->set_kind(MotionRequest::WALK);
  request.mutable_motion()->mutable_motion()->mutable_walk()->set_x(speed);
  request.mutable_motion()->mutable_head()->set_pan(0.5);
  return request;
}

Request goal(bool cancelled = false) {
  Request request;
  request.set_robot("red1");
  request.mutable_set_goal()->set_cancelled(cancelled);
  request.mutable_set_goal()->mutable_pose_in_field()->set_x(cancelled ? 0 : 3);
  return request;
}

/// A robot that notes in words what is asked of it, and two people.
class SteeringTest : public testing::Test {
 protected:
  SteeringTest() { hear(anna_), hear(ben_); }
  void hear(const ClientInfo& client) { heard_[client.id] = now_; }
  /// Time passes, in which these people are heard.
  void pass(Duration time, std::initializer_list<const ClientInfo*> heard) {
    for (const Instant end = now_ + time; now_ < end; now_ += 10ms) {
      for (const ClientInfo* client : heard) hear(*client);
      steering_.tick(now_);
    }
  }
  std::vector<std::string> asked() { return std::exchange(asked_, {}); }

  Steering::Actions actions() {
    return {
        [this](const Request& request, std::function<void(bool)> isDone) {
          const bool stands = request.motion().motion().kind() == MotionRequest::STAND;
          asked_.push_back(request.has_motion()             ? (stands ? "stand" : "walk")
                           : request.set_goal().cancelled() ? "no goal"
                                                            : "goal");
          isDone(accepts_);
        },
        [this](const std::string&, const Steering::Status& status) { status_ = status; },
        [this](std::uint64_t id) { return heard_.contains(id) ? std::optional(heard_[id]) : std::nullopt; }};
  }

  const ClientInfo anna_{1, "10.0.0.1:100", "Anna"}, ben_{2, "10.0.0.2:100", "Ben"};
  Instant now_{1h};
  std::map<std::uint64_t, Instant> heard_;
  std::vector<std::string> asked_;
  Steering::Status status_;
  bool accepts_ = true;
  Steering steering_{{}, actions()};
};

TEST_F(SteeringTest, theRobotStandsHalfASecondAfterTheLastMotion) {
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
    pass(400ms, {&anna_});
  }
  EXPECT_THAT(asked(), IsEmpty());
  pass(120ms, {&anna_});
  EXPECT_THAT(asked(), ElementsAre("stand"));
  EXPECT_THAT(status_.text, HasSubstr("did not repeat"));
  // Once is enough; and who stands need not repeat it.
  pass(2s, {&anna_});
  Request stand = walk();
  stand.mutable_motion()->mutable_motion()->set_kind(MotionRequest::STAND);
  EXPECT_EQ(steering_.admit(anna_, stand, now_), "");
  pass(2s, {&anna_});
  EXPECT_THAT(asked(), IsEmpty());
}

TEST_F(SteeringTest, aHundredTimesTheRobotStandsInTimeWhenTheLineIsSilentForTwentySeconds) {
  for (int round = 0; round < 100; ++round) {
    // Each time at another moment between two commands, which come every 100 ms.
    for (const Instant end = now_ + 1s + round * 7ms; now_ < end;) {
      EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
      pass(std::min<Duration>(100ms, end - now_), {&anna_});
    }
    EXPECT_THAT(asked(), IsEmpty()) << "round " << round;
    const Instant cut = now_;
    while (asked_.empty() && now_ < cut + 20s) pass(10ms, {});
    EXPECT_LE(now_ - cut, steering_.limits().commandTime + 10ms) << "round " << round;
    pass(2s, {});
    EXPECT_TRUE(status_.isSilent) << "round " << round;
    pass(18s, {});
    EXPECT_THAT(std::set<std::string>(asked_.begin(), asked_.end()), ElementsAre("stand"));
    asked();
  }
}

TEST_F(SteeringTest, standingIsAskedAgainUntilItIsAccepted) {
  steering_.admit(anna_, walk(), now_);
  accepts_ = false;
  pass(1s, {&anna_});
  EXPECT_GE(asked().size(), 3U);
  accepts_ = true;
  pass(200ms, {&anna_});
  EXPECT_THAT(asked(), ElementsAre("stand"));
  pass(1s, {&anna_});
  EXPECT_THAT(asked(), IsEmpty());
  // A newer motion of the person counts more than what was not accepted.
  steering_.admit(anna_, walk(), now_);
  accepts_ = false;
  pass(600ms, {&anna_});
  asked();
  steering_.admit(anna_, walk(), now_);
  accepts_ = true;
  pass(300ms, {&anna_});
  EXPECT_THAT(asked(), IsEmpty());
}

TEST_F(SteeringTest, aGoalHoldsAsLongAsTheLinkLivesAndComesBackWithIt) {
  EXPECT_EQ(steering_.admit(anna_, goal(), now_), "");
  pass(1min, {&anna_});
  EXPECT_THAT(asked(), IsEmpty());
  pass(990ms, {});
  EXPECT_THAT(asked(), IsEmpty());
  pass(40ms, {});
  EXPECT_THAT(asked(), ElementsAre("no goal"));
  EXPECT_TRUE(status_.isSilent);
  pass(20s, {});
  EXPECT_THAT(asked(), IsEmpty());
  pass(20ms, {&anna_});
  EXPECT_THAT(asked(), ElementsAre("goal"));
  EXPECT_FALSE(status_.isSilent);
}

TEST_F(SteeringTest, theSamePersonOnANewConnectionGoesOnButNotAfterAMinute) {
  const ClientInfo again{3, "10.0.0.1:777", "Anna"}, stranger{4, "10.0.0.9:777", "Anna"};
  for (const Duration silence : {Duration(20s), Duration(70s)}) {
    steering_.admit(anna_, goal(), now_);
    heard_.erase(anna_.id);
    pass(silence, {});
    EXPECT_THAT(asked(), ElementsAre("no goal"));
    hear(stranger), steering_.joined(stranger);
    pass(100ms, {&stranger});
    EXPECT_THAT(asked(), IsEmpty());
    hear(again), steering_.joined(again);
    pass(100ms, {&again});
    EXPECT_EQ(asked(), silence < 1min ? std::vector<std::string>{"goal"} : std::vector<std::string>{});
    steering_.giveUp(again, "red1", now_);
    pass(100ms, {&anna_});
    asked();
  }
}

TEST_F(SteeringTest, oneSteersUntilItGivesUpGoesIsIdleOrSomebodyTakesOver) {
  const auto isBen = [&] { return steering_.admit(ben_, walk(), now_).empty(); };
  EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
  EXPECT_EQ(status_.who, "Anna at 10.0.0.1:100");
  EXPECT_EQ(status_.client, 1U);
  EXPECT_THAT(steering_.admit(ben_, walk(), now_), HasSubstr("steered by Anna at 10.0.0.1:100: take over"));
  steering_.takeOver(ben_, "red1", now_);
  EXPECT_EQ(status_.client, 2U);
  pass(20ms, {&anna_, &ben_});
  EXPECT_THAT(asked(), ElementsAre("stand"));
  EXPECT_NE(steering_.admit(anna_, walk(), now_), "");
  EXPECT_TRUE(isBen());
  steering_.giveUp(ben_, "red1", now_);
  EXPECT_EQ(status_.who, "");
  EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
  pass(9s, {&anna_, &ben_});
  EXPECT_FALSE(isBen());
  pass(2s, {&anna_, &ben_});
  EXPECT_TRUE(isBen());
  steering_.takeOver(anna_, "red1", now_);
  heard_.erase(anna_.id);
  EXPECT_TRUE(isBen());
}

TEST_F(SteeringTest, whoOnlyLetsTheRobotStandDoesNotSteer) {
  Request stand;
  stand.set_robot("red1");
  stand.mutable_motion();
  EXPECT_EQ(steering_.admit(anna_, stand, now_), "");
  EXPECT_EQ(status_.who, "");
  EXPECT_EQ(steering_.admit(ben_, walk(), now_), "");
  EXPECT_THAT(steering_.admit(anna_, stand, now_), HasSubstr("steered by Ben"));
  // The client that steers goes on with it.
  pass(8s, {&anna_, &ben_});
  EXPECT_EQ(steering_.admit(ben_, stand, now_), "");
  pass(8s, {&anna_, &ben_});
  EXPECT_EQ(status_.client, ben_.id);
}

TEST_F(SteeringTest, theSamePersonSteersOverANewConnectionAlsoIfTheOldOneIsHeardLate) {
  const ClientInfo again{3, "10.0.0.1:777", "Anna"};
  for (const Duration silence : {Duration(5s), Duration(20s)}) {
    steering_.takeOver(anna_, "red1", now_);
    EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
    pass(silence, {});
    hear(again), steering_.joined(again);
    // What the line held back.
    hear(anna_);
    EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
    pass(20ms, {&anna_, &again, &ben_});
    EXPECT_NE(steering_.admit(ben_, walk(), now_), "");
    EXPECT_EQ(steering_.admit(again, walk(), now_), "");
    EXPECT_EQ(status_.client, again.id);
    EXPECT_NE(steering_.admit(anna_, walk(), now_), "");
  }
}

TEST_F(SteeringTest, aSecondConnectionOfThePersonWhoSteersIsRefused) {
  const ClientInfo second{3, "10.0.0.1:777", "Anna"};
  EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
  pass(100ms, {&anna_, &second});
  EXPECT_NE(steering_.admit(second, walk(), now_), "");
  // Its silence was not noticed yet.
  now_ += 2s;
  EXPECT_EQ(steering_.admit(second, walk(), now_), "");
}

TEST_F(SteeringTest, peopleAtTheRobotsMachineNeedNotAsk) {
  steering_.admit(anna_, walk(), now_);
  steering_.noteLocal(walk(), now_);
  EXPECT_EQ(status_.who, "this machine");
  EXPECT_EQ(status_.client, 0U);
  EXPECT_NE(steering_.admit(anna_, walk(), now_), "");
  pass(3s, {&anna_});
  EXPECT_THAT(asked(), IsEmpty());
  steering_.takeOver(anna_, "red1", now_);
  EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
}

TEST_F(SteeringTest, onlyWhatMovesARobotIsSteering) {
  Request request;
  request.mutable_control_drive()->set_sonar(true);
  EXPECT_FALSE(Steering::isSteering(request));
  request.mutable_control_drive()->set_motors(true);
  EXPECT_TRUE(Steering::isSteering(request));
  request.mutable_stop()->set_engaged(false);
  EXPECT_FALSE(Steering::isSteering(request));
  EXPECT_TRUE(Steering::isSteering(walk()));
  EXPECT_TRUE(Steering::isSteering(goal()));
}

TEST_F(SteeringTest, whenTheLinkEndsSteeredRobotsStand) {
  steering_.admit(anna_, walk(), now_);
  steering_.admit(anna_, goal(), now_);
  steering_.end();
  EXPECT_THAT(asked(), ElementsAre("stand", "no goal"));
}

TEST_F(SteeringTest, somebodyAtTheRobotTakesOver) {
  steering_.admit(anna_, walk(), now_);
  steering_.takeOverHere("red1", now_);
  EXPECT_EQ(status_.who, "this machine");
  EXPECT_EQ(status_.client, 0U);
  pass(20ms, {&anna_});
  EXPECT_THAT(asked(), ElementsAre("stand"));
  EXPECT_THAT(steering_.admit(anna_, walk(), now_), HasSubstr("this machine"));
  steering_.giveUpHere("red1");
  EXPECT_EQ(status_.text, "nobody steers");
  EXPECT_EQ(steering_.admit(anna_, walk(), now_), "");
  // Only what is one's own is given up.
  steering_.giveUpHere("red1");
  EXPECT_THAT(status_.who, HasSubstr("Anna"));
}

}  // namespace
}  // namespace robotlink::websocket
