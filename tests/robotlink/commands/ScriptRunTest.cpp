// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/commands/ScriptRun.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"

using namespace robotlink;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace {

class ScriptRunTest : public testing::Test {
 protected:
  ScriptRunTest() {
    session_.setRobots({"red1"});
    session_.setRequestSink([this](const robotcontrol::Request& request) { asked_.push_back(request); });
    commands_.add({"say", "Notes a text.", {{"text"}}, [this](const auto& values) -> Result<void> {
                     said_.push_back(std::get<std::string>(values[0]));
                     return {};
                   }});
    commands_.add({"ask", "Sends a request.", {}, [this](const auto&) -> Result<void> {
                     robotcontrol::Request request;
                     request.mutable_stop()->set_engaged(true);
                     session_.request(request);
                     return {};
                   }});
  }

  /// Runs lines of a file as far as they go.
  void run(const std::string& lines) {
    run_.runFile(folder_.write("a.script", lines));
    tick();
  }
  void tick(Duration passed = 0s) {
    now_ += passed;
    session_.tick();
    run_.tick(now_);
  }
  void push(const std::string& path, std::shared_ptr<google::protobuf::Message> value, Duration time) {
    session_.push({path, Instant(time), std::move(value)});
  }
  void pushBall(double x, Duration time) {
    auto ball = std::make_shared<robotcontrol::BallModel>();
    ball->mutable_position_in_robot()->set_x(x);
    push("red1/models/ball", ball, time);
  }
  void answer(bool accepted) {
    robotcontrol::RequestResult result;
    result.set_id(asked_.back().id());
    result.set_accepted(accepted);
    if (!accepted) result.set_reason("it is asleep");
    session_.pushResult(result);
  }
  /// Why it failed, without the folder; empty if it did not.
  std::string failure() const {
    if (!run_.failed()) return {};
    const std::string text = run_.failed()->describe(), folder = folder_.path().string() + "/";
    return text.starts_with(folder) ? text.substr(folder.size()) : text;
  }

  const TestFolder folder_;
  Session session_;
  CommandTable commands_;
  bool opening_ = false;
  std::optional<Error> openingError_;
  ScriptRun run_{{commands_, session_, [this]() -> Result<bool> {
                    if (openingError_) return tl::unexpected(*std::exchange(openingError_, std::nullopt));
                    return opening_;
                  }}};
  std::vector<std::string> said_;
  std::vector<robotcontrol::Request> asked_;
  Instant now_{100s};
};

}  // namespace

TEST_F(ScriptRunTest, linesRunOneAfterTheOther) {
  run("say a\n# nothing\n\nset b 'b c'\nsay \"$b\"\n");
  EXPECT_THAT(said_, ElementsAre("a", "b c"));
  EXPECT_TRUE(run_.isIdle());
  EXPECT_EQ(failure(), "");
}

TEST_F(ScriptRunTest, aRequestIsDoneWhenItIsAccepted) {
  run("ask\nsay done");
  tick(1s);
  EXPECT_THAT(said_, IsEmpty());
  answer(true);
  tick();
  EXPECT_THAT(said_, ElementsAre("done"));
  EXPECT_TRUE(run_.isIdle());
  EXPECT_EQ(failure(), "");
}

TEST_F(ScriptRunTest, whatAnAnswerMakesTheCommandAskIsWaitedForToo) {
  commands_.add({"chain", "Asks, and then asks again.", {}, [this](const auto&) -> Result<void> {
                   session_.request({}, [this](const auto&) { session_.request({}); });
                   return {};
                 }});
  run("chain\nsay done");
  answer(true);
  tick();
  ASSERT_EQ(asked_.size(), 2U);
  EXPECT_THAT(said_, IsEmpty());
  answer(true);
  tick();
  EXPECT_THAT(said_, ElementsAre("done"));
}

TEST_F(ScriptRunTest, whatTheHandlerOfAnAnswerReportsFailsTheLine) {
  commands_.add({"read", "Asks, and cannot use the answer.", {}, [this](const auto&) -> Result<void> {
                   session_.request({},
                                    [this](const auto&) { session_.reportRefusal("read", "no such value"); });
                   return {};
                 }});
  run("read\nsay never");
  answer(true);
  tick();
  EXPECT_EQ(failure(), "a.script:1:1: refused: no such value");
  EXPECT_THAT(said_, IsEmpty());
}

TEST_F(ScriptRunTest, aStreamThatAKeyPublishesIsNamedWithItsKey) {
  auto keys = std::make_shared<robotcontrol::KeyTable>();
  keys->add_keys()->set_name("package/models/ball");
  push("red1/tables/keys", keys, 1s);
  session_.tick();
  run("assert models/ball.known");
  EXPECT_THAT(failure(), HasSubstr("robot.key package/models/ball has it published"));
}

TEST_F(ScriptRunTest, aRefusalFailsTheLine) {
  run("say a\nask\nsay never");
  answer(false);
  tick();
  EXPECT_EQ(failure(), "a.script:2:1: refused: it is asleep");
  EXPECT_THAT(said_, ElementsAre("a"));
  EXPECT_TRUE(run_.isIdle());
}

TEST_F(ScriptRunTest, aRequestThatNobodyAnswersFailsTheLine) {
  run("ask");
  tick(29s);
  EXPECT_FALSE(run_.isIdle());
  tick(1s);
  EXPECT_EQ(failure(), "a.script:1:1: there was no answer for 30 s");
}

TEST_F(ScriptRunTest, whatALineOpensIsOpenBeforeTheNext) {
  opening_ = true;
  run("say open\nsay next");
  tick(1h);
  EXPECT_THAT(said_, ElementsAre("open"));
  opening_ = false;
  tick();
  EXPECT_THAT(said_, ElementsAre("open", "next"));
}

TEST_F(ScriptRunTest, whatCannotBeOpenedFailsTheLine) {
  opening_ = true;
  run("say open\nsay next");
  opening_ = false;
  openingError_ = Error{"x", "it is damaged", {}, {"b.sdf", 3, 0}};
  tick();
  EXPECT_EQ(failure(), "a.script:1: b.sdf:3: it is damaged");
}

TEST_F(ScriptRunTest, itWaitsUntilAConditionIsTrue) {
  run("wait until models/ball.position_in_robot.x > 2 for 10\nsay found");
  pushBall(1, 1s);
  tick(9s);
  EXPECT_THAT(said_, IsEmpty());
  pushBall(3, 2s);
  pushBall(1, 3s);  // it was true for a moment between two ticks
  tick();
  EXPECT_THAT(said_, ElementsAre("found"));
}

TEST_F(ScriptRunTest, itWaitsNoLongerThanItMay) {
  pushBall(1, 1s);
  session_.tick();
  run("wait until models/ball.position_in_robot.x > 2 for 10");
  tick(9s);
  EXPECT_FALSE(run_.isIdle());
  tick(1s);
  EXPECT_EQ(failure(),
            "a.script:1:12: waited 10 s for models/ball.position_in_robot.x > 2: "
            "models/ball.position_in_robot.x is 1");
}

TEST_F(ScriptRunTest, aStreamThatNeverCameIsNamed) {
  run("wait until models/ball.known for 1.5");
  tick(2s);
  EXPECT_THAT(
      failure(),
      StartsWith("a.script:1:12: waited 1.5 s for models/ball.known: there is no stream models/ball"));
}

TEST_F(ScriptRunTest, aFieldThatIsNotThereFailsAtOnce) {
  pushBall(1, 1s);
  session_.tick();
  run("say a\n  wait until models/ball.position_in_robot.q > 2");
  EXPECT_THAT(failure(), StartsWith("a.script:2:"));
  EXPECT_THAT(failure(), HasSubstr("red1/models/ball"));
}

TEST_F(ScriptRunTest, anAssertionSaysWhatWasThere) {
  pushBall(1.25, 1s);
  session_.tick();
  run("assert models/ball.position_in_robot.x > 1\nassert models/ball.position_in_robot.x > 2");
  EXPECT_EQ(
      failure(),
      "a.script:2:8: expected models/ball.position_in_robot.x > 2: models/ball.position_in_robot.x is 1.25");
}

TEST_F(ScriptRunTest, valuesArePrinted) {
  std::vector<std::string> printed;
  run_.setOutput([&](const std::string& text) { printed.push_back(text); });
  pushBall(1.25, 1s);
  session_.tick();
  run("print models/ball.position_in_robot.x\nprint 2 * models/ball.position_in_robot.x\nprint 1 + 1\n"
      "print 487049000000 + 0.5\nprint models/goal.x");
  EXPECT_THAT(printed, ElementsAre("1.25", "2.5", "2", "487049000000.5"));
  EXPECT_THAT(failure(), StartsWith("a.script:5:7: "));
  run("print");
  EXPECT_THAT(failure(), HasSubstr("print needs an expression"));
}

TEST_F(ScriptRunTest, whatIsCancelledDoesNotGoOnAndIsNoFailure) {
  run("wait until 1 > 2 for 1000\nsay never");
  run_.cancel();
  tick(2000s);
  EXPECT_TRUE(run_.isIdle());
  EXPECT_EQ(failure(), "");
  EXPECT_THAT(said_, IsEmpty());
  run("say again");
  EXPECT_THAT(said_, ElementsAre("again"));
}

TEST_F(ScriptRunTest, theTimeIsThatOfTheSession) {
  pushBall(1, 4s);
  session_.tick();
  run("assert simulation.time == 4\nwait until simulation.time >= 6\nwait 2\nsay late");
  EXPECT_EQ(failure(), "");
  for (const Duration time : {5s, 6s, 7s}) {
    pushBall(1, time);
    tick();
    EXPECT_THAT(said_, IsEmpty());
  }
  pushBall(1, 8s);
  tick();
  EXPECT_THAT(said_, ElementsAre("late"));
}

TEST_F(ScriptRunTest, aTimeThatStandsStillFailsTheLine) {
  pushBall(1, 4s);
  session_.tick();
  run("wait 5");
  tick(29s);
  pushBall(1, 5s);
  tick();
  tick(29s);
  EXPECT_FALSE(run_.isIdle()) << "it moved meanwhile";
  tick(1s);
  EXPECT_EQ(failure(), "a.script:1: expected 5 s to pass, but time has stopped at 5 s for 30 s");
}

TEST_F(ScriptRunTest, whatIsPausedIsSaidWithHowItGoesOn) {
  auto simulation = std::make_shared<robotcontrol::SimulationStatus>();
  push("simulation", simulation, 4s);
  session_.tick();
  run("wait 5");
  tick(30s);
  EXPECT_THAT(failure(), HasSubstr("for 30 s: the simulation is paused; simulation.start resumes it"));
  push("replay", std::make_shared<robotcontrol::ReplayStatus>(), 4s);
  session_.tick();
  run("wait 5");
  tick(30s);
  EXPECT_THAT(failure(), HasSubstr("for 30 s: the log is paused; log.play resumes it"));
  auto playing = std::make_shared<robotcontrol::ReplayStatus>();
  playing->set_playing(true);
  push("replay", playing, 4s);
  session_.tick();
  run("wait 5");
  tick(30s);
  EXPECT_THAT(failure(), testing::EndsWith("for 30 s"));
}

TEST_F(ScriptRunTest, loopsOfALogCountAsTimeThatPasses) {
  pushBall(1, 4s);
  session_.tick();
  run("wait 3\nsay done");
  for (const Duration time : std::initializer_list<Duration>{6s, 4s, 4500ms}) {
    pushBall(1, time);
    tick();
    EXPECT_THAT(said_, IsEmpty());
  }
  pushBall(1, 5s);
  tick();
  EXPECT_THAT(said_, ElementsAre("done"));
}

TEST_F(ScriptRunTest, aFileIsIncludedFromBesideTheOneThatIncludesIt) {
  folder_.write("parts/b.script", "say $x\nset y 2\ninclude c.script\n");
  folder_.write("parts/c.script", "say $folder");
  run("set x 1\ninclude parts/b.script\nsay $y");
  EXPECT_THAT(said_, ElementsAre("1", (folder_ / "parts").string(), "2"));
  EXPECT_EQ(failure(), "");
  ASSERT_EQ(run_.outcomes().size(), 3U);
  EXPECT_THAT(run_.outcomes()[2].name, testing::EndsWith("parts/c.script"));
}

TEST_F(ScriptRunTest, whatIsNotSetIsTakenFromTheEnvironment) {
  ::setenv("SCRIPT_TEST_VALUE", "there", 1);
  run("say $SCRIPT_TEST_VALUE\nset SCRIPT_TEST_VALUE here\nsay $SCRIPT_TEST_VALUE\nsay $SCRIPT_TEST_NONE");
  EXPECT_THAT(said_, ElementsAre("there", "here"));
  EXPECT_EQ(failure(),
            "a.script:4:5: there is no variable SCRIPT_TEST_NONE; set SCRIPT_TEST_NONE VALUE defines it");
}

TEST_F(ScriptRunTest, aFileThatIncludesItselfIsRefused) {
  folder_.write("b.script", "include ./a.script");
  run("include b.script");
  EXPECT_THAT(failure(), StartsWith("b.script:1:9: "));
  EXPECT_THAT(failure(), HasSubstr("includes itself"));
}

TEST_F(ScriptRunTest, aFailureOfAnIncludedFileIsOneOfBoth) {
  folder_.write("b.script", "say a\nfly");
  run("\ninclude b.script\nsay never");
  EXPECT_EQ(failure(), "b.script:2:1: there is no command fly");
  ASSERT_EQ(run_.outcomes().size(), 2U);
  EXPECT_THAT(run_.outcomes()[0].failure, HasSubstr("a.script:2: the included script failed"));
  EXPECT_THAT(run_.outcomes()[1].failure, HasSubstr("b.script:2:1: there is no command fly"));
  EXPECT_THAT(said_, ElementsAre("a"));
}

TEST_F(ScriptRunTest, filesThatCannotBeReadAreNamed) {
  run_.runFile(folder_ / "none.script");
  EXPECT_TRUE(run_.isIdle());
  EXPECT_THAT(failure(), HasSubstr("none.script"));
  run("include none.script");
  EXPECT_THAT(failure(), StartsWith("a.script:1:9: cannot include "));
}

TEST_F(ScriptRunTest, linesWithoutAFileKeepTheVariables) {
  run_.runLines({}, "set x 5");
  run_.tick(now_);
  run_.runLines({}, "say $x");
  run_.tick(now_);
  EXPECT_THAT(said_, ElementsAre("5"));
  run_.runLines({}, "fly");
  run_.tick(now_);
  EXPECT_EQ(failure(), "there is no command fly");
  run_.runLines({}, "say again");
  run_.tick(now_);
  EXPECT_EQ(failure(), "") << "the next one starts over";
}

TEST(ScriptReport, isAJUnitFile) {
  EXPECT_EQ(junitXml({{"a.script", 1.5, {}}, {"b.script", 0.25, "b.script:1: expected x < 3 & \"y\""}}),
            R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites>
  <testsuite name="robotcontrol" tests="2" failures="1" errors="0" skipped="0">
    <testcase classname="script" name="a.script" time="1.500"/>
    <testcase classname="script" name="b.script" time="0.250">
      <failure message="b.script:1: expected x &lt; 3 &amp; &quot;y&quot;"/>
    </testcase>
  </testsuite>
</testsuites>
)");
}
