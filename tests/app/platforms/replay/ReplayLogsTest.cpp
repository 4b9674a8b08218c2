// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/ReplayLogs.h"

#include <gtest/gtest.h>

#include "logplayer/file/LogFile.h"
#include "robotlink/debugging/Streams.h"
#include "tests/TestFolder.h"
#include "tests/app/ShortLog.h"

namespace app {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;
using robotlink::StreamMessage;
using test::ShortLog;

StreamMessage textAt(const std::string& path, std::chrono::milliseconds time) {
  auto message = std::make_shared<foxglove::Log>();
  robotlink::assign(*message->mutable_timestamp(), Instant(time));
  return {path, Instant(time), std::move(message), "process"};
}

class ReplayLogsTest : public testing::Test {
 protected:
  /// Adds a log that exists; its robots get these names in the replay.
  ReplayLogs::Source& add(const std::string& name, robotlink::Duration offset,
                          const std::map<std::string, std::string>& robots) {
    given_.push_back(std::make_unique<ReplayLog>(ReplayLog{folder_ / name, offset}));
    auto file = logplayer::LogFile::open(folder_ / name, {});
    EXPECT_TRUE(file) << (file ? "" : file.error().describe());
    ReplayLogs::Source& source = logs_.add(*given_.back(), *file);
    for (const auto& [logName, robot] : robots) {
      source.robots.push_back(std::make_unique<ReplayRobot>(*file, logName, robot, ReplayChoices{},
                                                            ProgramOverrides{}, RobotHost::Listeners{}));
      source.byLogName[logName] = source.robots.back().get();
    }
    return source;
  }
  void addShortLog(robotlink::Duration offset, const std::string& robot = "red1") {
    const std::string name = robot + ".mcap";
    ASSERT_EQ(ShortLog::write(folder_ / name), "");
    add(name, offset, {{"red1", robot}});
  }
  /// Writes a log of texts on these paths.
  void write(const std::string& name,
             const std::vector<std::pair<std::string, std::chrono::milliseconds>>& texts) const {
    auto writer = logplayer::LogWriter::create(folder_ / name, {});
    ASSERT_TRUE(writer) << writer.error().describe();
    for (const auto& [path, time] : texts) ASSERT_TRUE((*writer)->write({textAt(path, time)}));
    ASSERT_TRUE((*writer)->container().close());
  }

  const TestFolder folder_;
  std::vector<std::unique_ptr<ReplayLog>> given_;
  ReplayLogs logs_;
};

TEST_F(ReplayLogsTest, logsShareATimeLine) {
  addShortLog(0ms);
  addShortLog(-15s, "red1-2");
  EXPECT_EQ(logs_.begin(), ShortLog::time(0) - 15s);
  EXPECT_EQ(logs_.end(), ShortLog::time(ShortLog::kFrames - 1));
  for (const auto& source : logs_.sources()) source->reader.seek(Instant::min());
  EXPECT_EQ(logs_.nextTime(), ShortLog::time(0) - 15s);
  logs_.sources()[1]->reader.seek(Instant::max());
  EXPECT_EQ(logs_.nextTime(), ShortLog::time(0));
  logs_.sources()[0]->reader.seek(Instant::max());
  EXPECT_EQ(logs_.nextTime(), std::nullopt);
}

TEST_F(ReplayLogsTest, robotsOfEqualNamesGetNumbers) {
  EXPECT_EQ(logs_.freeName("red1"), "red1");
  addShortLog(0ms);
  EXPECT_EQ(logs_.freeName("red1"), "red1-2");
  addShortLog(0ms, "red1-2");
  EXPECT_EQ(logs_.freeName("red1"), "red1-3");
  EXPECT_EQ(logs_.freeName("blue1"), "blue1");
  ASSERT_EQ(logs_.robots().size(), 2U);
  EXPECT_EQ(logs_.find("red1-2"), logs_.robots()[1]);
  EXPECT_EQ(logs_.find("red1-3"), nullptr);
}

TEST_F(ReplayLogsTest, streamsAreFoundByTheNamesOfTheReplay) {
  addShortLog(0ms);
  addShortLog(1h, "red1-2");
  EXPECT_EQ(logs_.firstTime("red1/planner/notes"), ShortLog::time(10));
  EXPECT_EQ(logs_.firstTime("red1-2/planner/notes"), ShortLog::time(10) + 1h);
  EXPECT_EQ(logs_.firstTime(std::string("red1-2/") + robotlink::streams::kLogged + "planner/notes"),
            ShortLog::time(10) + 1h)
      << "as logged, beside what is computed";
  EXPECT_EQ(logs_.firstTime("red1/planner/nothing"), std::nullopt);
  EXPECT_EQ(logs_.firstTime("blue1/planner/notes"), std::nullopt);
  EXPECT_EQ(logs_.firstTime(""), std::nullopt);
}

TEST_F(ReplayLogsTest, messagesAreCountedFromTheOneThatIsShown) {
  addShortLog(0ms);
  const auto after = [&](int count, Instant now) {
    return logs_.countedTime("red1/camera/image", count, now);
  };
  // Every second frame has an image: 1, 3, 5.
  EXPECT_EQ(after(1, ShortLog::time(1)), ShortLog::time(3));
  EXPECT_EQ(after(2, ShortLog::time(1)), ShortLog::time(5));
  EXPECT_EQ(after(-1, ShortLog::time(5)), ShortLog::time(3));
  EXPECT_EQ(after(-2, ShortLog::time(5)), ShortLog::time(1));
  EXPECT_EQ(after(0, ShortLog::time(5)), ShortLog::time(5));
  // Between two images the earlier one is shown.
  EXPECT_EQ(after(1, ShortLog::time(4)), ShortLog::time(5));
  EXPECT_EQ(after(0, ShortLog::time(4)), ShortLog::time(3));
  EXPECT_EQ(after(-1, ShortLog::time(4)), ShortLog::time(1));
}

TEST_F(ReplayLogsTest, countingEndsAtTheEndsOfTheStream) {
  addShortLog(0ms);
  const auto after = [&](int count, Instant now) {
    return logs_.countedTime("red1/camera/image", count, now);
  };
  EXPECT_EQ(after(1000, ShortLog::time(1)), ShortLog::time(49));
  EXPECT_EQ(after(1, ShortLog::time(49)), ShortLog::time(49));
  EXPECT_EQ(after(-1000, ShortLog::time(49)), ShortLog::time(1));
  EXPECT_EQ(after(-1, ShortLog::time(0) - 1s), ShortLog::time(1));
  EXPECT_EQ(logs_.countedTime("red1/nothing", 1, ShortLog::time(1)), std::nullopt);
}

TEST_F(ReplayLogsTest, messagesAtOneInstantCountOnce) {
  write("twice.mcap", {{"red1/say", 10ms}, {"red1/say", 20ms}, {"red1/say", 20ms}, {"red1/say", 30ms}});
  add("twice.mcap", 0ms, {{"red1", "red1"}});
  const auto after = [&](int count, std::chrono::milliseconds now) {
    return logs_.countedTime("red1/say", count, Instant(now));
  };
  EXPECT_EQ(after(1, 10ms), Instant(20ms));
  EXPECT_EQ(after(2, 10ms), Instant(30ms));
  EXPECT_EQ(after(-1, 30ms), Instant(20ms));
  EXPECT_EQ(after(-2, 30ms), Instant(10ms));
}

TEST_F(ReplayLogsTest, framesAreFoundByTheirNumbers) {
  addShortLog(1s);
  EXPECT_EQ(logs_.timeOfFrame("red1/planner", 101), ShortLog::time(0) + 1s);
  EXPECT_EQ(logs_.timeOfFrame("red1/planner", 150), ShortLog::time(49) + 1s);
  EXPECT_EQ(logs_.timeOfFrame("red1/platform", 102), ShortLog::time(1) + 1s);
  EXPECT_EQ(logs_.timeOfFrame("red1/platform", 103), std::nullopt) << "a frame that is not in the log";
  EXPECT_EQ(logs_.timeOfFrame("red1/planner", 100), std::nullopt);
  EXPECT_EQ(logs_.timeOfFrame("red1/planner", 151), std::nullopt);
  EXPECT_EQ(logs_.timeOfFrame("red1/nobody", 101), std::nullopt);
  EXPECT_EQ(logs_.timeOfFrame("planner", 101), std::nullopt);
}

TEST_F(ReplayLogsTest, theStreamOfFramesIsNamedAfterTheProcess) {
  EXPECT_EQ(ReplayLogs::framesOf("red1/planner"), "red1/frames/planner");
  EXPECT_EQ(ReplayLogs::framesOf("planner"), "");
}

TEST_F(ReplayLogsTest, theFirstProcessIsSteppedWhereNoneWaitsForImages) {
  EXPECT_EQ(logs_.stepProcess(), "");
  addShortLog(0ms);
  addShortLog(0ms, "red1-2");
  EXPECT_EQ(logs_.stepProcess(), "red1/planner");
}

TEST_F(ReplayLogsTest, onlyTheFirstLogWithASceneShowsItsWorld) {
  const std::string scene = robotlink::streams::kScene;
  write("none.mcap", {{"weather", 30ms}});
  write("first.mcap", {{scene, 10ms}, {"weather", 20ms}});
  write("second.mcap", {{scene, 5ms}, {"weather", 5ms}});
  EXPECT_TRUE(add("none.mcap", 0ms, {}).publishesWorld);
  EXPECT_TRUE(add("first.mcap", 0ms, {}).publishesWorld);
  EXPECT_FALSE(add("second.mcap", 0ms, {}).publishesWorld);
  EXPECT_EQ(logs_.firstTime(scene), Instant(10ms));
  EXPECT_EQ(logs_.firstTime("weather"), Instant(30ms)) << "of the first log that has it";
}

TEST_F(ReplayLogsTest, theirDescriptionHasTimesRobotsAndProcesses) {
  addShortLog(2s);
  robotcontrol::ReplayStatus status;
  logs_.describe(status);
  EXPECT_EQ(Instant(robotlink::Duration(status.begin())), ShortLog::time(0) + 2s);
  EXPECT_EQ(Instant(robotlink::Duration(status.end())), ShortLog::time(49) + 2s);
  ASSERT_EQ(status.logs_size(), 1);
  EXPECT_EQ(status.logs(0).path(), (folder_ / "red1.mcap").string());
  EXPECT_EQ(robotlink::Duration(status.logs(0).offset()), 2s);
  EXPECT_EQ(status.logs(0).damage(), "");
  ASSERT_EQ(status.logs(0).robots_size(), 1);
  ASSERT_EQ(status.processes_size(), 2);
  EXPECT_EQ(status.processes(0).name(), "red1/planner");
  EXPECT_EQ(status.processes(0).frames(), 50U);
  EXPECT_EQ(status.processes(1).frames(), 25U);
}

TEST_F(ReplayLogsTest, theFrameThatIsShownHasAnIndexAndANumber) {
  addShortLog(0ms);
  const auto shown = [&](Instant now) {
    robotcontrol::ReplayStatus status;
    logs_.describeFrame("red1/planner", now, status);
    return std::pair(status.frame_index(), status.frame());
  };
  EXPECT_EQ(shown(ShortLog::time(0) - 1ns), std::pair(std::uint64_t{0}, std::uint64_t{0}));
  EXPECT_EQ(shown(ShortLog::time(0)), std::pair(std::uint64_t{1}, std::uint64_t{101}));
  EXPECT_EQ(shown(ShortLog::time(3) + 1ms), std::pair(std::uint64_t{4}, std::uint64_t{104}));
  EXPECT_EQ(shown(ShortLog::time(49) + 1h), std::pair(std::uint64_t{50}, std::uint64_t{150}));
}

}  // namespace
}  // namespace app
