// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayFeed.h"

#include <gmock/gmock.h>

#include "app/core/Workbench.h"
#include "foxglove/Image.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/TestFolder.h"
#include "tests/app/ShortLog.h"
#include "tests/app/TickUntil.h"
#include "tests/game/Data.h"
#include "tests/game/Log.h"

using namespace app;
using app::test::ShortLog;
using robotcontrol::ReplayStatus;
using testing::HasSubstr;

namespace {

constexpr double kGap = 3;  // s, in the middle of the log

/// A workbench in which a log is open, ticked until something holds.
class ReplayFeedTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TestFolder>();
    EXPECT_EQ(ShortLog::write(logFile()), "");
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::filesystem::path logFile() { return *folder_ / "replay-feed.mcap"; }

  ReplayFeedTest() : workbench(*folder_ / "workbench") {
    workbench.onErrors(
        [this](const robotlink::Errors& reported) { errors += robotlink::describe(reported); });
    run("log.open \"" + logFile().string() + "\"");
    EXPECT_TRUE(waitFor([this] { return workbench.loaded() != nullptr && status() != nullptr; })) << errors;
    EXPECT_TRUE(settle());
  }

  template <typename Condition>
  bool waitFor(Condition condition) {
    return app::test::tickUntil(workbench, condition);
  }
  const ReplayStatus* status() {
    auto& session = workbench.session();
    return session.store().latestAs<ReplayStatus>("replay", session.timeline().newest());
  }
  void run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    EXPECT_TRUE(done.has_value()) << line << ": " << (done ? "" : done.error().describe());
  }
  /// Waits until all that was asked for is done: requests are fulfilled in their order.
  bool settle() {
    bool answered = false;
    robotcontrol::Request request;
    request.mutable_control_replay();
    workbench.session().request(request, [&](const auto&) { answered = true; });
    return waitFor([&] { return answered && !workbench.loading(); });
  }
  void runAll(const std::string& line) {
    run(line);
    ASSERT_TRUE(settle());
  }
  /// Which frame of the log is shown, from 0; -1 if that is not one.
  int shownFrame() {
    const auto time = status()->time();
    for (int frame = 0; frame < ShortLog::kFrames; ++frame) {
      if (ShortLog::time(frame).time_since_epoch().count() == time) return frame;
    }
    return -1;
  }
  /// The time of the newest message of a stream, as a frame of the log; -1: there is none.
  int newest(const std::string& stream) {
    const auto* message = workbench.session().store().latest(stream, workbench.session().timeline().newest());
    for (int frame = 0; message != nullptr && frame < ShortLog::kFrames; ++frame) {
      if (ShortLog::time(frame) == message->time) return frame;
    }
    return -1;
  }
  static double secondsOf(int frame) { return robotlink::seconds(ShortLog::time(frame) - ShortLog::time(0)); }
  static std::string jumpTo(int frame) { return "log.jump " + std::to_string(secondsOf(frame)); }

  static inline std::unique_ptr<TestFolder> folder_;
  Workbench workbench;
  std::string errors;
};

}  // namespace

TEST_F(ReplayFeedTest, aLogOpensPausedAtItsFirstImage) {
  EXPECT_FALSE(status()->playing());
  EXPECT_EQ(status()->speed(), 1);
  EXPECT_EQ(shownFrame(), 1);
  EXPECT_EQ(status()->step_process(), "red1/planner");
  EXPECT_EQ(status()->frame(), ShortLog::kFirstNumber + 1);
  EXPECT_EQ(newest("red1/camera/image"), 1);
  EXPECT_EQ(workbench.session().robots(), std::vector<std::string>{"red1"});
  EXPECT_EQ(workbench.loaded()->name(), "replay-feed.mcap");
  ASSERT_EQ(workbench.loaded()->sources.size(), 1U);
  EXPECT_EQ(errors, "");
}

TEST_F(ReplayFeedTest, itAdvancesToATimeAndKeepsItsHistory) {
  const auto generation = workbench.session().store().generation();
  robotcontrol::Request request;
  request.mutable_control_replay()->set_action(robotcontrol::ControlReplay::ADVANCE_TO_TIME);
  request.mutable_control_replay()->set_time(ShortLog::time(4).time_since_epoch().count() + 1);
  workbench.session().request(request);
  ASSERT_TRUE(settle());
  EXPECT_EQ(newest("red1/frames/planner"), 4);
  EXPECT_EQ(workbench.session().store().generation(), generation) << "it was stepped";
}

TEST_F(ReplayFeedTest, itIsPlayedAtItsSpeedUntilItIsPaused) {
  run("log.speed 0.5");
  const auto start = std::chrono::steady_clock::now();
  run("log.play");
  ASSERT_TRUE(waitFor([this] { return newest("red1/frames/planner") >= 4; }));
  EXPECT_TRUE(status()->playing());
  ASSERT_TRUE(waitFor([this] { return newest("red1/frames/planner") >= 9; }));
  const double real = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(real, (secondsOf(newest("red1/frames/planner")) - secondsOf(1)) / 0.5 - 0.1)
      << "it is never ahead of its speed, however busy the machine is";
  runAll("log.pause");
  const int paused = newest("red1/frames/planner");
  EXPECT_FALSE(status()->playing());
  ASSERT_TRUE(settle()) << "what is asked in the pause is answered";
  EXPECT_EQ(newest("red1/frames/planner"), paused);
  EXPECT_EQ(shownFrame(), paused);
}

TEST_F(ReplayFeedTest, atTheEndItPausesAndPlaysFromTheStartAgain) {
  run("log.speed 50");
  run("log.play");
  ASSERT_TRUE(waitFor([this] { return shownFrame() == ShortLog::kFrames - 1 && !status()->playing(); }));
  run("log.speed 0.05");
  run("log.play");
  ASSERT_TRUE(settle());
  EXPECT_TRUE(status()->playing());
  EXPECT_LE(newest("red1/frames/planner"), 3);
  EXPECT_EQ(newest("red1/planner/notes"), -1) << "what was later is forgotten";
}

TEST_F(ReplayFeedTest, stopGoesToTheStart) {
  runAll(jumpTo(30));
  run("log.play");
  runAll("log.stop");
  EXPECT_FALSE(status()->playing());
  EXPECT_EQ(shownFrame(), 1);
}

TEST_F(ReplayFeedTest, engagingStopPausesIt) {
  run("log.speed 0.05");
  runAll("log.play");
  ASSERT_TRUE(status()->playing());
  const auto answerTo = [this](const std::string& robot, bool engaged) {
    std::optional<bool> accepted;
    robotcontrol::Request request;
    request.set_robot(robot);
    request.mutable_stop()->set_engaged(engaged);
    workbench.session().request(request, [&](const auto& result) { accepted = result.accepted(); });
    EXPECT_TRUE(waitFor([&] { return accepted.has_value(); }));
    return accepted;
  };
  EXPECT_EQ(answerTo("red1", false), true);
  EXPECT_TRUE(status()->playing());
  EXPECT_EQ(answerTo("blue7", true), false);
  EXPECT_EQ(answerTo("red1", true), true);
  EXPECT_FALSE(status()->playing());
}

TEST_F(ReplayFeedTest, framesAreSteppedForwardsAndBackwards) {
  runAll("log.step 1");
  EXPECT_EQ(shownFrame(), 2);
  EXPECT_EQ(newest("red1/camera/image"), 1);
  runAll("log.step 3");
  EXPECT_EQ(shownFrame(), 5);
  EXPECT_EQ(status()->frame(), ShortLog::kFirstNumber + 5);
  EXPECT_EQ(status()->frame_index(), 6U);
  runAll("log.step -1");
  EXPECT_EQ(shownFrame(), 4);
  EXPECT_EQ(newest("red1/frames/planner"), 4);
  EXPECT_EQ(newest("red1/camera/image"), 3);
  runAll("log.step -100");
  EXPECT_EQ(shownFrame(), 0);
  runAll("log.step 100");
  EXPECT_EQ(shownFrame(), ShortLog::kFrames - 1);
  runAll("log.step 1");
  EXPECT_EQ(shownFrame(), ShortLog::kFrames - 1);
}

TEST_F(ReplayFeedTest, messagesOfAStreamAreSteppedTo) {
  runAll("log.step-message red1/planner/notes 1");
  EXPECT_EQ(shownFrame(), 10);
  runAll("log.step-message red1/planner/notes 1");
  EXPECT_EQ(shownFrame(), 40);
  runAll("log.step-message red1/planner/notes -1");
  EXPECT_EQ(shownFrame(), 10);
  EXPECT_EQ(newest("red1/planner/notes"), 10);
  EXPECT_EQ(errors, "");
  runAll("log.step-message red1/nothing 1");
  EXPECT_THAT(errors, HasSubstr("no message of red1/nothing"));
  EXPECT_EQ(shownFrame(), 10);
}

TEST_F(ReplayFeedTest, aStepPausesWhatIsPlayed) {
  run("log.speed 0.05");
  run("log.play");
  runAll("log.step 1");
  EXPECT_FALSE(status()->playing());
}

TEST_F(ReplayFeedTest, afterAJumpEveryStreamShowsItsNewestMessageBeforeThatTime) {
  runAll(jumpTo(44));
  EXPECT_EQ(newest("red1/frames/planner"), 44);
  EXPECT_EQ(newest("red1/camera/image"), 43);
  EXPECT_EQ(newest("red1/planner/notes"), 40);
  runAll(jumpTo(20));
  EXPECT_EQ(newest("red1/frames/planner"), 20);
  EXPECT_EQ(newest("red1/camera/image"), 19);
  EXPECT_EQ(newest("red1/planner/notes"), 10);
  runAll(jumpTo(5));
  EXPECT_EQ(newest("red1/planner/notes"), -1);
  EXPECT_TRUE(workbench.session().timeline().live());
  EXPECT_EQ(errors, "");
}

TEST_F(ReplayFeedTest, aFrameIsJumpedToByItsNumber) {
  runAll("log.jump-frame 131");
  EXPECT_EQ(shownFrame(), 30);
  EXPECT_EQ(status()->frame(), 131U);
  runAll("log.jump-frame 7");
  EXPECT_THAT(errors, HasSubstr("no frame 7 of red1/planner"));
  EXPECT_EQ(shownFrame(), 30);
}

TEST_F(ReplayFeedTest, whilePlayedItGoesOnFromWhereOneJumpsTo) {
  run("log.speed 0.05");
  run("log.play");
  runAll(jumpTo(20));
  EXPECT_TRUE(status()->playing());
  EXPECT_GE(newest("red1/frames/planner"), 20);
  EXPECT_LE(newest("red1/frames/planner"), 21);
}

TEST_F(ReplayFeedTest, jumpsThatComeFasterThanTheyAreDoneAreAllAnsweredAndTheNewestCounts) {
  constexpr int kJumps = 300;
  int answers = 0, accepted = 0;
  for (int i = 0; i < kJumps; ++i) {
    robotcontrol::Request request;
    request.mutable_control_replay()->set_action(robotcontrol::ControlReplay::JUMP_TO_TIME);
    request.mutable_control_replay()->set_time(
        ShortLog::time(i % ShortLog::kFrames).time_since_epoch().count());
    workbench.session().request(request, [&](const auto& result) {
      ++answers;
      accepted += result.accepted() ? 1 : 0;
    });
  }
  ASSERT_TRUE(waitFor([&] { return answers == kJumps; }));
  EXPECT_EQ(accepted, kJumps);
  ASSERT_TRUE(settle());
  EXPECT_EQ(shownFrame(), (kJumps - 1) % ShortLog::kFrames);
}

TEST_F(ReplayFeedTest, aRangeIsPlayedInALoop) {
  run("log.range " + std::to_string(secondsOf(5)) + " " + std::to_string(secondsOf(10)));
  run("log.loop on");
  run("log.speed 5");
  run("log.play");
  int low = 1000, high = -1, returns = 0, last = -1;
  ASSERT_TRUE(waitFor([&] {
    const int frame = newest("red1/frames/planner");
    if (frame < 5 && high < 0) return false;  // before the jump into the range
    low = std::min(low, frame);
    high = std::max(high, frame);
    returns += frame < last ? 1 : 0;
    last = frame;
    return returns == 3;
  }));
  EXPECT_EQ(low, 5);
  EXPECT_LE(high, 10);
  EXPECT_GE(high, 9);
  EXPECT_EQ(status()->range().from(), ShortLog::time(5).time_since_epoch().count());
  runAll("log.range 0 0");
  EXPECT_FALSE(status()->has_range());
}

TEST_F(ReplayFeedTest, gapsAreSkippedOnRequest) {
  runAll("log.skip-gaps on");
  EXPECT_TRUE(status()->skip_gaps());
  runAll(jumpTo(24));
  run("log.speed 0.05");
  run("log.play");
  EXPECT_TRUE(waitFor([this] { return newest("red1/frames/planner") >= 25; }))
      << "at this speed the gap would take a minute";
}

TEST_F(ReplayFeedTest, inAGapTheTimeGoesOn) {
  runAll(jumpTo(24));
  run("log.play");
  const auto gap = ShortLog::time(24).time_since_epoch().count();
  ASSERT_TRUE(waitFor([&] { return status()->time() > gap + 250'000'000; }));
  EXPECT_EQ(newest("red1/frames/planner"), 24);
}

TEST_F(ReplayFeedTest, whatCannotBeSetIsRefusedAndChangesNothing) {
  const auto refusal = [this](const std::function<void(robotcontrol::ControlReplay&)>& fill) {
    robotcontrol::Request request;
    fill(*request.mutable_control_replay());
    std::string reason;
    bool answered = false;
    workbench.session().request(request, [&](const auto& result) {
      reason = result.reason();
      answered = true;
    });
    EXPECT_TRUE(waitFor([&] { return answered; }));
    return reason;
  };
  EXPECT_THAT(refusal([](auto& control) { control.set_speed(60); }), HasSubstr("between 0.05 and 50"));
  EXPECT_THAT(refusal([](auto& control) { control.set_step_process("red1/nobody"); }),
              HasSubstr("red1/nobody"));
  EXPECT_THAT(refusal([](auto& control) { control.add_offsets()->set_log("other.mcap"); }),
              HasSubstr("other.mcap is not open"));
  EXPECT_EQ(status()->speed(), 1);
  EXPECT_EQ(status()->step_process(), "red1/planner");
  EXPECT_EQ(shownFrame(), 1);
}

TEST_F(ReplayFeedTest, whatIsForSimulationsDoesNothingToALog) {
  runAll("simulation.reset");
  EXPECT_THAT(errors, HasSubstr("a log is open"));
  EXPECT_EQ(shownFrame(), 1);
  runAll("log.step 1");
  EXPECT_EQ(shownFrame(), 2);
}

TEST_F(ReplayFeedTest, aRequestToARobotIsAnsweredWhilePaused) {
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_send_tables();
  int answers = 0;
  workbench.session().request(request, [&](const auto&) { ++answers; });
  request.set_robot("nobody");
  workbench.session().request(request, [&](const auto& result) { answers += result.accepted() ? 100 : 1; });
  EXPECT_TRUE(waitFor([&] { return answers == 2; }));
  EXPECT_EQ(shownFrame(), 1);
}

TEST_F(ReplayFeedTest, keysThatAreOnAreKeptOverJumps) {
  const auto mode = [this] {
    const auto* table = workbench.session().store().latestAs<robotcontrol::KeyTable>(
        "red1/tables/keys", workbench.session().timeline().newest());
    for (int i = 0; table != nullptr && i < table->keys_size(); ++i) {
      if (table->keys(i).name() == "segmentation/classes") return table->keys(i).mode().kind();
    }
    return robotcontrol::KeyMode::OFF;
  };
  EXPECT_EQ(mode(), robotcontrol::KeyMode::OFF);
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_set_key()->set_name("segmentation/classes");
  request.mutable_set_key()->mutable_mode()->set_kind(robotcontrol::KeyMode::ALWAYS);
  int answers = 0;
  workbench.session().request(request, [&](const auto& result) { answers += result.accepted() ? 1 : 0; });
  ASSERT_TRUE(waitFor([&] { return answers == 1; }));
  EXPECT_EQ(mode(), robotcontrol::KeyMode::ALWAYS) << "also while paused";
  EXPECT_TRUE(waitFor([this] { return newest("red1/images/segmentation/classes") == 1; }))
      << "what is asked for is shown without going on";
  for (const int frame : {40, 3}) {
    runAll(jumpTo(frame));
    EXPECT_EQ(mode(), robotcontrol::KeyMode::ALWAYS);
    EXPECT_EQ(newest("red1/images/segmentation/classes"), newest("red1/camera/image"));
  }
}

TEST_F(ReplayFeedTest, oneMoreLogIsAddedWhereOneStands) {
  run("log.speed 2");
  runAll(jumpTo(20));
  const auto before = status()->time();
  run("log.add \"" + logFile().string() + "\" 0.5");
  ASSERT_TRUE(waitFor([this] { return !workbench.loading(); }));
  EXPECT_EQ(errors, "");
  EXPECT_EQ(workbench.session().robots(), (std::vector<std::string>{"red1", "red1-2"}));
  ASSERT_TRUE(settle());
  EXPECT_EQ(status()->time(), before);
  EXPECT_EQ(status()->speed(), 2);
  ASSERT_EQ(status()->logs_size(), 2);
  EXPECT_EQ(status()->logs(1).offset(), 500'000'000);
  EXPECT_EQ(status()->end(), ShortLog::time(ShortLog::kFrames - 1).time_since_epoch().count() + 500'000'000);
  EXPECT_EQ(newest("red1/frames/planner"), 20);
}

TEST_F(ReplayFeedTest, aSolutionThatWasChosenIsKeptByAnotherLayoutAndByOneMoreLog) {
  const auto segmentation = [this] {
    const auto* table = workbench.session().store().latestAs<robotcontrol::SolutionTable>(
        "red1/tables/solutions", workbench.session().timeline().newest());
    for (int i = 0; table != nullptr && i < table->tasks_size(); ++i) {
      if (table->tasks(i).name() == "segmentation")
        return table->tasks(i).active() + ", not " + table->tasks(i).default_solution();
    }
    return std::string("no table");
  };
  robotcontrol::Request request;
  request.set_robot("red1");
  request.mutable_select_solution()->set_task("segmentation");
  request.mutable_select_solution()->set_solution("whole-image");
  bool accepted = false;
  workbench.session().request(request, [&](const auto& result) { accepted = result.accepted(); });
  ASSERT_TRUE(waitFor([&] { return accepted; }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(segmentation(), "whole-image, not scan-lines");
  run("layout.open parallel");
  ASSERT_TRUE(
      waitFor([this] { return !workbench.loading() && workbench.loaded()->layout.stem() == "parallel"; }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(segmentation(), "whole-image, not scan-lines");
  run("log.add \"" + logFile().string() + "\" 0.5");
  ASSERT_TRUE(waitFor([this] { return !workbench.loading() && workbench.session().robots().size() == 2; }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(segmentation(), "whole-image, not scan-lines");
  EXPECT_EQ(errors, "");
}

TEST_F(ReplayFeedTest, aSimulationEndsTheLogAndALogTheSimulation) {
  run("simulation.open field2002");
  ASSERT_TRUE(waitFor([this] { return workbench.loaded()->isSimulated(); })) << errors;
  workbench.tick();
  const auto& store = workbench.session().store();
  EXPECT_EQ(store.find("replay"), nullptr);
  EXPECT_NE(store.find("simulation"), nullptr);
  errors.clear();
  run("log.play");
  ASSERT_TRUE(waitFor([this] { return !errors.empty(); }));
  EXPECT_THAT(errors, HasSubstr("no log is open"));
  run("log.open \"" + logFile().string() + "\"");
  ASSERT_TRUE(waitFor([this] { return workbench.loaded()->isLogged(); })) << errors;
  workbench.tick();
  EXPECT_NE(store.find("replay"), nullptr);
  EXPECT_EQ(store.find("simulation"), nullptr);
  EXPECT_EQ(store.find("scene"), nullptr);
}

TEST_F(ReplayFeedTest, whatCannotBeOpenedLeavesTheLogAsItWas) {
  runAll("log.step 2");
  for (const char* line :
       {"log.open /no/such/file.mcap", "simulation.open /no/such/scene.sdf", "log.layout /no/such.yaml"}) {
    errors.clear();
    run(line);
    ASSERT_TRUE(waitFor([this] { return !workbench.loading(); }));
    EXPECT_THAT(errors, HasSubstr("/no/such")) << line;
  }
  EXPECT_EQ(shownFrame(), 3);
  runAll("log.step 1");
  EXPECT_EQ(shownFrame(), 4);
}

TEST_F(ReplayFeedTest, afterItIsClosedNothingIsShown) {
  run("log.close");
  ASSERT_TRUE(waitFor([this] { return !workbench.loaded()->isLogged(); }));
  EXPECT_TRUE(waitFor([this] { return workbench.session().store().streams().empty(); }));
  EXPECT_TRUE(workbench.session().robots().empty());
  EXPECT_EQ(workbench.loaded()->name(), "");
  EXPECT_FALSE(workbench.commands().runLine("log.close").has_value());
}

/// The parameter is the source of a whole log of 2009.
class WholeLogFeed : public ReplayFeedTest, public testing::WithParamInterface<std::string> {};

TEST_P(WholeLogFeed, opensAtItsFirstImage) {
  const auto file = game::dataOf(GetParam()) / "logs/bhuman2009.log";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the real log is not at " << file;
  run("log.open \"" + file.string() + "\"");
  ASSERT_TRUE(waitFor([this] { return !workbench.loading(); }));
  ASSERT_TRUE(settle());
  EXPECT_EQ(workbench.session().robots(), std::vector<std::string>{"nao"});
  const robotlink::Instant first =
      GetParam() == "real" ? robotlink::Instant(std::chrono::milliseconds(486'749)) : game::Log::imageTime(0);
  EXPECT_EQ(status()->time(), first.time_since_epoch().count()) << "the time stamp of the first image";
  EXPECT_FALSE(status()->playing());
  const auto imageTime = [this] {
    const auto* image =
        workbench.session().store().latest("nao/camera/image", workbench.session().timeline().newest());
    return image != nullptr ? image->time.time_since_epoch().count() : 0;
  };
  EXPECT_EQ(imageTime(), status()->time());
  EXPECT_TRUE(waitFor([this] {
    return workbench.session().store().find("nao/drawings/image/ball-percept/disc") != nullptr;
  })) << "the program runs on it, with the keys that are on at the start";
  for (const int count : {1, 1, 1, -2}) {
    const auto before = imageTime();
    runAll("log.step-message nao/camera/image " + std::to_string(count));
    EXPECT_EQ(imageTime() > before, count > 0);
  }
  EXPECT_EQ(errors, "");
}

INSTANTIATE_TEST_SUITE_P(Logs, WholeLogFeed, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });
