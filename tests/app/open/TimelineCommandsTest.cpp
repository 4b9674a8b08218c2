// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/TimelineCommands.h"

#include <gmock/gmock.h>

#include "foxglove/Robot.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "tests/app/open/AskedWorkbench.h"

namespace app {
namespace {

using robotlink::Instant;
using std::chrono::seconds;
using testing::HasSubstr;

/// Ten seconds of a robot's texts, one a second from 100 s on.
class TimelineCommandsTest : public testing::Test {
 protected:
  TimelineCommandsTest() {
    session().timeline().setOrigin(Instant(seconds(100)));
    for (int i = 0; i <= 10; ++i) desk_.publish("red1/log", foxglove::Log(), Instant(seconds(100 + i)));
  }
  robotlink::Session& session() { return desk_.workbench.session(); }
  /// The shown time since the origin, s; negative: it follows the newest.
  double shown() {
    session().tick();
    const auto& timeline = session().timeline();
    return timeline.live() ? -1 : robotlink::seconds(timeline.sinceOrigin(timeline.shown()));
  }

  test::AskedWorkbench desk_;
};

TEST_F(TimelineCommandsTest, whatIsShownIsPausedAndGoesOn) {
  EXPECT_EQ(desk_.run("timeline.pause"), "");
  EXPECT_EQ(shown(), 10);
  desk_.publish("red1/log", foxglove::Log(), Instant(seconds(120)));
  EXPECT_EQ(shown(), 10) << "while the robot continues";
  EXPECT_EQ(desk_.run("timeline.live"), "");
  EXPECT_EQ(shown(), -1);
}

TEST_F(TimelineCommandsTest, aTimeIsSinceTheOriginOrBeforeNow) {
  EXPECT_EQ(desk_.run("timeline.seek 4"), "");
  EXPECT_EQ(shown(), 4);
  EXPECT_EQ(desk_.run("timeline.seek -3"), "");
  EXPECT_EQ(shown(), 7);
  EXPECT_EQ(desk_.run("timeline.seek 1e10"), "timeline.time: the time must be a number of seconds");
  EXPECT_EQ(shown(), 7);
}

TEST_F(TimelineCommandsTest, messagesAreSteppedByAWholeNumber) {
  EXPECT_EQ(desk_.run("timeline.seek 4"), "");
  EXPECT_EQ(desk_.run("timeline.step-message red1/log 2"), "");
  EXPECT_EQ(shown(), 6);
  EXPECT_EQ(desk_.run("timeline.step-message red1/log -5"), "");
  EXPECT_EQ(shown(), 1);
  for (const char* count : {"0", "0.5", "1e7"}) {
    EXPECT_THAT(desk_.run("timeline.step-message red1/log " + std::string(count)),
                HasSubstr("the count must be a whole number other than 0"))
        << count;
  }
  EXPECT_NE(desk_.run("timeline.step-message red1/nothing"), "");
}

TEST_F(TimelineCommandsTest, aLogHasCommandsOfItsOwn) {
  desk_.publish("replay", robotcontrol::ReplayStatus());
  EXPECT_EQ(desk_.run("timeline.pause"), "timeline.log: a log is open; use log.pause");
  EXPECT_EQ(desk_.run("timeline.seek 1"), "timeline.log: a log is open; use log.jump SECONDS");
  EXPECT_EQ(desk_.run("timeline.step"), "timeline.log: a log is open; use log.step");
  EXPECT_EQ(desk_.run("timeline.step-message red1/log"),
            "timeline.log: a log is open; use log.step-message STREAM");
  EXPECT_EQ(desk_.run("timeline.live"), "");
}

TEST_F(TimelineCommandsTest, whatIsKeptIsLimitedAndRemembered) {
  HistoryKeeper& history = desk_.workbench.history();
  EXPECT_EQ(desk_.run("timeline.memory 128"), "");
  EXPECT_EQ(desk_.run("timeline.disk 0"), "");
  EXPECT_EQ(history.memory(), std::uint64_t{128} << 20U);
  EXPECT_EQ(history.disk(), 0U);
  for (const char* size : {"-1", "1e10"}) {
    EXPECT_THAT(desk_.run("timeline.disk " + std::string(size)), HasSubstr("must be a number of MiB"));
    EXPECT_THAT(desk_.run("timeline.memory " + std::string(size)), HasSubstr("must be a number of MiB"));
  }
  EXPECT_THAT(desk_.run("timeline.memory 63"), HasSubstr("at least 64 MiB"));
  EXPECT_EQ(history.memory(), std::uint64_t{128} << 20U);
  robotlink::Session another;
  const HistoryKeeper later(another, desk_.home / "history.json");
  EXPECT_EQ(later.memory(), std::uint64_t{128} << 20U);
  EXPECT_EQ(later.disk(), 0U);
}

}  // namespace
}  // namespace app
