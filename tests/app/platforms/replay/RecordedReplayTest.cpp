// SPDX-License-Identifier: GPL-3.0-or-later
// A log that is replayed in the workbench can be recorded like any other platform.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/core/Workbench.h"
#include "robotcontrol/Requests.pb.h"
#include "tests/app/ShortLog.h"
#include "tests/app/TickUntil.h"
#include "tests/logplayer/RecordedMessages.h"

using app::test::ShortLog;
using logplayer::tests::ReadLog;
using logplayer::tests::TestFolder;

namespace {

class RecordedReplayTest : public ::testing::Test {
 protected:
  RecordedReplayTest() : workbench(folder / "home") {
    EXPECT_EQ(ShortLog::write(folder / "log.mcap"), "");
    run("log.open \"" + (folder / "log.mcap").string() + "\"");
    EXPECT_TRUE(waitFor([this] { return workbench.loaded() != nullptr; }));
  }
  template <typename Condition>
  bool waitFor(Condition condition) {
    return app::test::tickUntil(workbench, condition);
  }
  void run(const std::string& line) {
    const auto done = workbench.commands().runLine(line);
    EXPECT_TRUE(done.has_value()) << line << ": " << (done ? "" : done.error().describe());
  }
  /// Runs a command of the log and waits until it is done.
  void runLog(const std::string& line) {
    run(line);
    bool answered = false;
    robotcontrol::Request request;
    request.mutable_control_replay();
    workbench.session().request(request, [&](const auto&) { answered = true; });
    ASSERT_TRUE(waitFor([&] { return answered; }));
  }

  TestFolder folder;
  app::Workbench workbench;
};

}  // namespace

TEST_F(RecordedReplayTest, whatIsPlayedIsRecordedAndAJumpBeginsANewFile) {
  runLog("log.pause");
  run("recording.start-file \"" + (folder / "a.mcap").string() + "\"");
  for (int i = 0; i < 3; ++i) runLog("log.step 1");
  runLog("log.jump 4.5");
  for (int i = 0; i < 2; ++i) runLog("log.step 1");
  run("recording.stop");
  workbench.recording().recorder().finish();
  const ReadLog first = logplayer::tests::readLog(folder / "a.mcap");
  EXPECT_TRUE(first.complete) << first.error;
  EXPECT_EQ(first.count("red1/frames/planner"), 3U);
  EXPECT_GE(first.count("red1/camera/image"), 1U);
  EXPECT_EQ(first.count("replay"), 0U);
  const ReadLog second = logplayer::tests::readLog(folder / "a-2.mcap");
  EXPECT_TRUE(second.complete) << second.error;
  EXPECT_GE(second.count("red1/frames/planner"), 3U);
  EXPECT_GE(second.count("red1/camera/image"), 2U);
  robotlink::Instant last = first.entries.back().time;
  for (const auto& entry : second.entries) {
    if (entry.type != "robotcontrol.FrameInfo") continue;
    EXPECT_GE(entry.time, last);
    last = entry.time;
  }
}
