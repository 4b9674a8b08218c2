// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptCondition.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/session/Session.h"

namespace robotlink {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class ScriptConditionTest : public testing::Test {
 protected:
  ScriptConditionTest() { session_.setRobots({"red1", "blue1"}); }

  void ball(double x, std::chrono::milliseconds time, const std::string& robot = "red1") {
    auto ball = std::make_shared<robotcontrol::BallModel>();
    ball->mutable_position_in_robot()->set_x(x);
    session_.push({robot + "/models/ball", Instant(time), std::move(ball)});
  }
  static bool isTrue(const Result<bool>& result) {
    EXPECT_TRUE(result) << (result ? "" : result.error().text);
    return result && *result;
  }

  const std::string far_ = "models/ball.position_in_robot.x > 2";
  Session session_;
};

TEST_F(ScriptConditionTest, whatIsTrueBetweenTwoLooksIsNotMissed) {
  ball(1, 10ms);
  session_.tick();
  ScriptCondition condition(session_, far_);
  EXPECT_FALSE(isTrue(condition.look()));
  ball(3, 20ms);
  ball(1, 30ms);
  session_.tick();
  EXPECT_FALSE(isTrue(condition.now())) << "it is over";
  EXPECT_TRUE(isTrue(condition.look()));
  EXPECT_FALSE(isTrue(condition.look())) << "only once";
}

TEST_F(ScriptConditionTest, whatWasTrueBeforeDoesNotCount) {
  ball(3, 10ms);
  ball(1, 20ms);
  session_.tick();
  ScriptCondition condition(session_, far_);
  EXPECT_FALSE(isTrue(condition.look()));
}

TEST_F(ScriptConditionTest, whatIsTrueNowCountsAtOnce) {
  ball(3, 10ms);
  session_.tick();
  ScriptCondition condition(session_, far_);
  EXPECT_TRUE(isTrue(condition.look()));
  EXPECT_TRUE(isTrue(condition.now()));
  EXPECT_EQ(condition.values(), "models/ball.position_in_robot.x is 3");
}

TEST_F(ScriptConditionTest, streamsMayStillAppear) {
  ScriptCondition condition(session_, far_);
  EXPECT_FALSE(isTrue(condition.look()));
  const auto missing = condition.now();
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().text, HasSubstr("there is no stream models/ball"));
  EXPECT_THAT(condition.values(), HasSubstr("there is no stream models/ball"));
  ball(3, 10ms);
  session_.tick();
  EXPECT_TRUE(isTrue(condition.look()));
  EXPECT_TRUE(isTrue(condition.now()));
}

TEST_F(ScriptConditionTest, aMissingStreamNamesTheKeyThatPublishesIt) {
  auto keys = std::make_shared<robotcontrol::KeyTable>();
  keys->add_keys()->set_name("package/models/ball");
  session_.push({"red1/tables/keys", Instant(1ms), std::move(keys)});
  session_.tick();
  ScriptCondition condition(session_, far_);
  EXPECT_THAT(condition.values(), HasSubstr("; robot.key package/models/ball has it published"));
}

TEST_F(ScriptConditionTest, whatWillNeverBeUnderstoodFails) {
  for (const char* text : {"models/ball.position_in_robot.x >", "1 +", "(", "simulation.time == )"}) {
    ScriptCondition condition(session_, text);
    EXPECT_FALSE(condition.look()) << text;
    EXPECT_FALSE(condition.now()) << text;
  }
}

TEST_F(ScriptConditionTest, aFieldThatTheMessagesDoNotHaveFails) {
  ball(1, 10ms);
  session_.tick();
  ScriptCondition condition(session_, "models/ball.position_in_robot.q > 2");
  const auto wrong = condition.look();
  ASSERT_FALSE(wrong);
  EXPECT_THAT(wrong.error().text, HasSubstr("q"));
}

TEST_F(ScriptConditionTest, streamsWithoutARobotAreThoseOfTheSelectedOne) {
  ball(1, 10ms, "red1");
  ball(3, 10ms, "blue1");
  session_.tick();
  session_.selectRobot("red1");
  ScriptCondition condition(session_, far_);
  EXPECT_FALSE(isTrue(condition.now()));
  session_.selectRobot("blue1");
  EXPECT_TRUE(isTrue(condition.now()));
}

TEST_F(ScriptConditionTest, theTimeIsThatOfTheSession) {
  ball(0, 1000ms);
  session_.tick();
  ScriptCondition condition(session_, "simulation.time >= 1.5");
  EXPECT_FALSE(isTrue(condition.look()));
  ball(0, 3000ms);
  session_.tick();
  EXPECT_TRUE(isTrue(condition.look()));
}

TEST_F(ScriptConditionTest, theTimeOfAReplayIsInNanoseconds) {
  auto status = std::make_shared<robotcontrol::ReplayStatus>();
  status->set_time(1'500'000'000);
  session_.push({"replay", Instant(1500ms), status});
  session_.tick();
  ScriptCondition condition(session_, "replay.time / 1e9 == 1.5");
  EXPECT_TRUE(isTrue(condition.now()));
}

TEST_F(ScriptConditionTest, anObserverGetsEachValue) {
  ball(1, 10ms);
  session_.tick();
  std::vector<std::pair<double, Instant>> seen;
  ScriptCondition condition(session_, "models/ball.position_in_robot.x",
                            [&](double value, Instant time) { seen.emplace_back(value, time); });
  ball(2, 20ms);
  ball(3, 30ms);
  session_.push({"red1/other", Instant(40ms), std::make_shared<robotcontrol::BallModel>()});
  session_.tick();
  EXPECT_THAT(seen, ElementsAre(Pair(2, Instant(20ms)), Pair(3, Instant(30ms))));
}

TEST_F(ScriptConditionTest, afterARestartOfTheSessionItIsBoundAnew) {
  ball(3, 10ms);
  session_.tick();
  ScriptCondition condition(session_, far_);
  EXPECT_TRUE(isTrue(condition.look()));
  session_.restart();
  session_.setRobots({"red1"});
  EXPECT_FALSE(isTrue(condition.look()));
  ball(3, 5ms);
  session_.tick();
  EXPECT_TRUE(isTrue(condition.look()));
}

}  // namespace
}  // namespace robotlink
