// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/ReplayControl.h"

#include <gtest/gtest.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/session/Session.h"

namespace widgets {
namespace {

using robotcontrol::ControlReplay;

robotlink::Instant instantAt(double seconds) {
  return robotlink::Instant(robotlink::fromSeconds(seconds));
}

std::int64_t nanoseconds(double seconds) {
  return instantAt(seconds).time_since_epoch().count();
}

/// A replay of a log from 10 to 40 s; the test is its other end.
class ReplayControlTest : public testing::Test {
 protected:
  ReplayControlTest() {
    session.setRequestSink([this](const robotcontrol::Request& request) { requests.push_back(request); });
    status.add_logs()->set_path("game.mcap");
    status.set_begin(nanoseconds(10));
    status.set_end(nanoseconds(40));
    status.set_time(nanoseconds(12));
    QObject::connect(&replay, &ReplayControl::refused, &replay,
                     [this](const QString& reason) { refusals.push_back(reason.toStdString()); });
  }
  void publish() {
    session.push({"replay", instantAt(1), std::make_shared<robotcontrol::ReplayStatus>(status)});
    session.tick();
    replay.refresh();
  }
  void answer(bool accepted, const std::string& reason = {}) {
    robotcontrol::RequestResult result;
    result.set_id(requests.back().id());
    result.set_accepted(accepted);
    result.set_reason(reason);
    session.pushResult(result);
    session.tick();
    replay.refresh();
  }
  const ControlReplay& asked() const { return requests.back().control_replay(); }

  std::vector<robotcontrol::Request> requests;
  std::vector<std::string> refusals;
  robotlink::Session session;
  ReplayControl replay{session};
  robotcontrol::ReplayStatus status;
};

TEST_F(ReplayControlTest, isOpenWhileThereAreLogs) {
  replay.refresh();
  EXPECT_FALSE(replay.open());
  publish();
  EXPECT_TRUE(replay.open());
  EXPECT_EQ(replay.shown(), instantAt(12));
  status.clear_logs();
  publish();
  EXPECT_FALSE(replay.open());
}

TEST_F(ReplayControlTest, ofManyJumpsOnlyTheNewestWaitsForTheReplyToTheFirst) {
  publish();
  for (const double time : {15.0, 16.0, 99.0}) replay.jumpTo(instantAt(time));
  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(asked().time(), nanoseconds(15));
  EXPECT_EQ(replay.shown(), instantAt(40)) << "clamped to the end";
  answer(true);
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(asked().time(), nanoseconds(40));
  answer(true);
  EXPECT_EQ(requests.size(), 2U);
  EXPECT_EQ(replay.shown(), instantAt(12)) << "what the replay reports counts again";
}

TEST_F(ReplayControlTest, aReplyThatIsLostDoesNotBlockJumpsForEver) {
  publish();
  replay.jumpTo(instantAt(15));
  replay.jumpTo(instantAt(16));
  for (int tick = 0; tick < 89; ++tick) replay.refresh();
  EXPECT_EQ(requests.size(), 1U);
  for (int tick = 0; tick < 3; ++tick) replay.refresh();
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(asked().time(), nanoseconds(16));
}

TEST_F(ReplayControlTest, refusalsAreSignaledWithTheirReason) {
  publish();
  replay.jumpTo(instantAt(15));
  answer(false, "the log is gone");
  replay.setLoop(true);
  answer(false, "too short");
  EXPECT_EQ(refusals, (std::vector<std::string>{"the log is gone", "too short"}));
}

TEST_F(ReplayControlTest, aRangeIsOrderedAndWithinTheLogs) {
  publish();
  EXPECT_FALSE(replay.range().has_value());
  replay.setRange(instantAt(50), instantAt(20));
  EXPECT_EQ(asked().range().from(), nanoseconds(20));
  EXPECT_EQ(asked().range().to(), nanoseconds(40));
  *status.mutable_range() = asked().range();
  publish();
  EXPECT_EQ(replay.range(), std::pair(instantAt(20), instantAt(40)));
  status.set_time(nanoseconds(30));
  publish();
  replay.beginRangeHere();
  EXPECT_EQ(asked().range().from(), nanoseconds(30));
  EXPECT_EQ(asked().range().to(), nanoseconds(40));
  replay.endRangeHere();
  EXPECT_EQ(asked().range().from(), nanoseconds(20));
  EXPECT_EQ(asked().range().to(), nanoseconds(30));
}

TEST_F(ReplayControlTest, messagesOfTheChosenStreamAreStepped) {
  publish();
  int changes = 0;
  QObject::connect(&replay, &ReplayControl::steppedStreamChanged, &replay, [&changes] { ++changes; });
  replay.setSteppedStream("nao/camera/image");
  replay.setSteppedStream("nao/camera/image");
  EXPECT_EQ(changes, 1);
  replay.stepMessages(-2);
  EXPECT_EQ(asked().action(), ControlReplay::STEP_MESSAGE);
  EXPECT_EQ(asked().count(), -2);
  EXPECT_EQ(asked().stream(), "nao/camera/image");
  replay.stepMessages(1, "nao/joints");
  EXPECT_EQ(asked().stream(), "nao/joints");
}

TEST_F(ReplayControlTest, timesCountFromTheBeginningUnlessTimestampsAreWanted) {
  publish();
  EXPECT_EQ(replay.shownText(instantAt(12.5)).toStdString(), "2.500");
  replay.setShowsTimeStamps(true);
  EXPECT_EQ(replay.shownText(instantAt(12.5)).toStdString(), "12.500");
}

TEST_F(ReplayControlTest, theStartIsTheFirstImageButNotBeforeTheLog) {
  publish();
  EXPECT_EQ(replay.start(), instantAt(10));
  status.set_start(nanoseconds(11));
  publish();
  EXPECT_EQ(replay.start(), instantAt(11));
}

}  // namespace
}  // namespace widgets
