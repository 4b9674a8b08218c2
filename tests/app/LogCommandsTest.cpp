// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/LogCommands.h"

#include <gmock/gmock.h>

#include <future>
#include <thread>

#include "app/core/Workbench.h"
#include "logplayer/file/LogFile.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "tests/TestFolder.h"
#include "tests/app/ShortLog.h"
#include "tests/app/TickUntil.h"
#include "tests/game/Log.h"

using namespace app;
using robotcontrol::ControlReplay;
using testing::HasSubstr;

namespace {

/// A workbench whose requests are seen, with the status of a log of ten seconds that begins at 486 s.
class LogCommandsTest : public testing::Test {
 protected:
  LogCommandsTest() {
    workbench.session().setRequestSink(
        [this](const robotcontrol::Request& request) { asked.push_back(request); });
    workbench.onErrors([this](const robotlink::Errors& reported) { errors = robotlink::describe(reported); });
  }
  void openLog() {
    auto status = std::make_shared<robotcontrol::ReplayStatus>();
    status->set_begin(486'000'000'000);
    status->set_end(496'000'000'000);
    status->add_packages()->set_package("nao/models/ball");
    status->add_logs()->set_path("/logs/a.mcap");
    workbench.session().push({"replay", robotlink::Instant(std::chrono::seconds(486)), status});
    workbench.session().setRobots({"nao"});
    workbench.tick();
  }
  void reportOpen(const std::filesystem::path& log) {
    auto status = std::make_shared<robotcontrol::ReplayStatus>();
    status->add_logs()->set_path(log.string());
    workbench.session().push({"replay", robotlink::Instant(std::chrono::seconds(10)), status});
    workbench.tick();
  }
  /// Searches the open logs to the end. Returns the id of the error; empty if there is none.
  std::string search(const std::string& expression, const std::filesystem::path& table) {
    const auto begun = workbench.commands().run("log.search", {expression, table.string()});
    EXPECT_TRUE(begun) << begun.error().describe();
    auto working = workbench.working();
    while (working && *working) {
      std::this_thread::yield();
      working = workbench.working();
    }
    return working ? std::string() : working.error().id;
  }
  /// What a line asks for, or why it is refused.
  std::string run(const std::string& line) {
    asked.clear();
    const auto done = workbench.commands().runLine(line);
    if (!done) return done.error().text;
    if (asked.size() != 1 || !asked[0].robot().empty()) return "not one request";
    return asked[0].control_replay().ShortDebugString();
  }

  const TestFolder home;
  Workbench workbench{home.path()};
  std::vector<robotcontrol::Request> asked;
  std::string errors;
};

}  // namespace

TEST_F(LogCommandsTest, playingIsAskedFor) {
  EXPECT_EQ(run("log.play"), "action: PLAY");
  EXPECT_EQ(run("log.pause"), "action: PAUSE");
  EXPECT_EQ(run("log.stop"), "action: STOP");
  EXPECT_EQ(run("log.speed 0.05"), "speed: 0.05");
  EXPECT_EQ(run("log.speed 50"), "speed: 50");
  EXPECT_EQ(run("log.loop on"), "loop: true");
  EXPECT_EQ(run("log.skip-gaps off"), "skip_gaps: false");
}

TEST_F(LogCommandsTest, cancelingIsForAllThatIsStillToBeOpened) {
  std::promise<void> mayGoOn;
  const auto opening = [going = mayGoOn.get_future().share()](const char* file) {
    PlatformOpening log;
    log.file = file;
    log.make = [going](const PlatformContext& context) -> PlatformOpening::Made {
      going.wait();
      const bool wanted = context.progress(0.5);
      return tl::unexpected(
          robotlink::Errors{{wanted ? "log.no-log" : "log.given-up", "not opened", {}, {}}});
    };
    return log;
  };
  workbench.open(opening("/logs/first.mcap"));
  workbench.open(opening("/logs/second.mcap"));
  EXPECT_EQ(workbench.openingName(), "first.mcap");
  ASSERT_TRUE(workbench.commands().runLine("log.cancel"));
  mayGoOn.set_value();
  ASSERT_TRUE(test::tickUntil(workbench, [&] { return !workbench.loading(); }));
  EXPECT_EQ(errors, "");
}

TEST_F(LogCommandsTest, aLogIsNotShiftedOutOfTheRangeOfTimes) {
  openLog();
  EXPECT_THAT(run("log.offset a.mcap 1.5"), HasSubstr("offset: 1500000000"));
  EXPECT_THAT(run("log.offset a.mcap -1e300"), HasSubstr("at most 100 years"));
  EXPECT_THAT(run("log.add b.mcap 1e10"), HasSubstr("at most 100 years"));
}

TEST_F(LogCommandsTest, stepsGoForwardsAndBackwards) {
  EXPECT_EQ(run("log.step 1"), "action: STEP_FRAME count: 1");
  EXPECT_EQ(run("log.step -5"), "action: STEP_FRAME count: -5");
  EXPECT_EQ(run("log.step-message nao/camera/image -1"),
            "action: STEP_MESSAGE count: -1 stream: \"nao/camera/image\"");
  EXPECT_EQ(run("log.step-process nao/motion"), "step_process: \"nao/motion\"");
  EXPECT_EQ(run("log.jump-frame 434"), "action: JUMP_TO_FRAME frame: 434");
}

TEST_F(LogCommandsTest, secondsAreThoseSinceTheBegin) {
  openLog();
  EXPECT_EQ(run("log.jump 0"), "action: JUMP_TO_TIME time: 486000000000");
  EXPECT_EQ(run("log.jump 2.5"), "action: JUMP_TO_TIME time: 488500000000");
  EXPECT_EQ(run("log.jump 10"), "action: JUMP_TO_TIME time: 496000000000");
  EXPECT_EQ(run("log.range 3 1"), "range { from: 487000000000 to: 489000000000 }");
  EXPECT_EQ(run("log.range 0 0"), "range { from: 486000000000 to: 486000000000 }");
}

TEST_F(LogCommandsTest, packagesAreChosenWithOrWithoutTheirRobot) {
  openLog();
  EXPECT_EQ(run("log.package models/ball recomputed"),
            "packages { package: \"nao/models/ball\" source: RECOMPUTED }");
  EXPECT_EQ(run("log.package nao/models/ball logged"),
            "packages { package: \"nao/models/ball\" source: AS_LOGGED }");
  EXPECT_EQ(run("log.package models/ball automatic"), "packages { package: \"nao/models/ball\" }");
}

TEST_F(LogCommandsTest, aLogIsShiftedByItsPathOrName) {
  openLog();
  EXPECT_EQ(run("log.offset /logs/a.mcap -1.5"), "offsets { log: \"/logs/a.mcap\" offset: -1500000000 }");
  EXPECT_EQ(run("log.offset a.mcap 2"), "offsets { log: \"/logs/a.mcap\" offset: 2000000000 }");
  EXPECT_EQ(run("log.offset b.mcap 2"), "offsets { log: \"b.mcap\" offset: 2000000000 }");
}

TEST_F(LogCommandsTest, whatIsWrongIsSaidWithWhatIsAllowed) {
  openLog();
  for (const char* line : {"log.speed 0.04", "log.speed 51", "log.speed 0", "log.speed -1"}) {
    EXPECT_THAT(run(line), HasSubstr("between 0.05 and 50")) << line;
  }
  for (const char* line : {"log.step 0", "log.step 1.5", "log.step-message a 1e12"}) {
    EXPECT_THAT(run(line), HasSubstr("whole number")) << line;
  }
  for (const char* line : {"log.jump -1", "log.jump 10.5", "log.range 0 11"}) {
    EXPECT_THAT(run(line), HasSubstr("between 0 and 10")) << line;
  }
  EXPECT_THAT(run("log.jump-frame -1"), HasSubstr("whole number, 0 or more"));
  EXPECT_THAT(run("log.package models/ball computed"), HasSubstr("logged, recomputed or automatic"));
  EXPECT_THAT(run("log.loop perhaps"), HasSubstr("on or off"));
  EXPECT_THAT(run("log.open"), HasSubstr("takes 1 argument"));
}

TEST_F(LogCommandsTest, withoutALogThereIsNothingToJumpIn) {
  for (const char* line :
       {"log.jump 1", "log.range 1 2", "log.close", "log.layout compact", "log.package a logged"}) {
    EXPECT_THAT(run(line), HasSubstr("no log is open; open one first")) << line;
  }
  EXPECT_TRUE(asked.empty());
}

TEST_F(LogCommandsTest, whatIsRefusedLaterArrivesAsAnError) {
  run("log.play");
  ASSERT_EQ(asked.size(), 1U);
  robotcontrol::RequestResult result;
  result.set_id(asked[0].id());
  result.set_reason("there is no log");
  workbench.session().pushResult(result);
  workbench.tick();
  EXPECT_EQ(errors, "there is no log");
}

TEST_F(LogCommandsTest, partsOfTheOpenLogsAreCutAndExported) {
  const auto cut = home / "cut.mcap", texts = home / "texts.txt", table = home / "table.csv";
  EXPECT_THAT(run("log.cut " + cut.string() + " 0 1"), HasSubstr("no log is open"));
  const auto log = home / "short.mcap";
  ASSERT_EQ(app::test::ShortLog::write(log), "");
  // The log lies 100 s later on the time line than by its own times.
  auto status = std::make_shared<robotcontrol::ReplayStatus>();
  status->set_begin(110'000'000'000);
  status->set_end(115'000'000'000);
  status->add_logs()->set_path(log.string());
  status->mutable_logs(0)->set_offset(100'000'000'000);
  workbench.session().push({"replay", robotlink::Instant(std::chrono::seconds(110)), status});
  workbench.tick();
  const auto write = [&](const std::string& line) {
    if (const auto begun = workbench.commands().runLine(line); !begun) return begun.error().id;
    auto working = workbench.working();
    while (working && *working) {
      std::this_thread::yield();
      working = workbench.working();
    }
    return working ? std::string() : working.error().id;
  };
  EXPECT_EQ(write("log.export texts '*' " + texts.string() + " --to 1"), "");
  EXPECT_THAT(robotlink::readFile(texts).value_or(""),
              testing::AllOf(HasSubstr("frame 10"), testing::Not(HasSubstr("frame 40"))));
  EXPECT_NE(write("log.export texts '*' " + texts.string()), "") << "the file exists";
  EXPECT_EQ(write("log.export csv red1/planner/notes " + table.string() + " 1 end --log short.mcap"), "");
  EXPECT_THAT(robotlink::readFile(table).value_or(""),
              testing::AllOf(HasSubstr("frame 40"), testing::Not(HasSubstr("frame 10"))));
  EXPECT_EQ(write("log.cut " + cut.string() + " 0 1 --streams 'red1/*,-*/camera/*'"), "");
  const auto written = logplayer::LogFile::open(cut, {});
  ASSERT_TRUE(written);
  std::vector<std::string> paths;
  for (const auto& stream : (*written)->streams()) paths.push_back(stream.path);
  EXPECT_THAT(paths, testing::Contains("red1/planner/notes"));
  EXPECT_THAT(paths, testing::Not(testing::Contains("red1/camera/image")));
  EXPECT_EQ(write("log.cut " + (home / "b.mcap").string() + " 0 11"), "log.time");
  EXPECT_EQ(write("log.cut " + (home / "b.mcap").string() + " soon 1"), "log.time");
  EXPECT_EQ(write("log.export texts '*' " + (home / "b.txt").string() + " --log b.mcap"), "log.unknown");
}

TEST_F(LogCommandsTest, theOpenLogsAreSearchedWithoutPlayingThem) {
  const auto table = home / "found.csv";
  EXPECT_EQ(run("log.search 'log.message =~ \"frame\"' " + table.string()),
            "no log is open; open one first: log.open FILE");
  const auto log = home / "short.mcap";
  app::test::ShortLog::write(log);
  reportOpen(log);
  const auto search = [&](const std::string& expression) { return this->search(expression, table); };
  EXPECT_EQ(search("planner/notes.message =~ \"frame 4\""), "");
  EXPECT_EQ(robotlink::readFile(table).value_or(""),
            "log,robot,from,until,text\r\nshort.mcap,red1,4.600000,4.600000,frame 40\r\n");
  EXPECT_EQ(search("planner/notes.message =~ \"nobody\""), "log.not-found");
  EXPECT_EQ(search("no/such.field > 1"), "expression.stream");
}

TEST_F(LogCommandsTest, whatTheOpenLogsLackIsComputedForTheirSearch) {
  const auto table = home / "found.csv", log = home / "game.log";
  game::Log::write(log);
  reportOpen(log);
  EXPECT_EQ(search("models/ball.known >= 0", table), "");
  const auto opened = logplayer::LogFile::open(log, {});
  ASSERT_TRUE(opened);
  const double from = robotlink::seconds(game::Log::imageTime(0) - (*opened)->begin());
  EXPECT_EQ(robotlink::readFile(table).value_or(""),
            "log,robot,from,until,text\r\ngame.log,nao," + std::to_string(from) + ",,\r\n");
}
