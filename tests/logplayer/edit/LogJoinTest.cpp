// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogJoin.h"

#include <gmock/gmock.h>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Logging.pb.h"
#include "tests/logplayer/LogFixture.h"

namespace logplayer {
namespace {

using namespace std::chrono_literals;
using robotlink::StreamMessage;
using testing::HasSubstr;
using tests::at;
using tests::plot;

StreamMessage programOf(const std::string& robot, double time, const std::string& layout) {
  auto setup = std::make_shared<robotcontrol::ProgramSetup>();
  setup->mutable_layout()->set_name("layout.yaml");
  setup->mutable_layout()->set_text(layout);
  return {robot + "/program", at(time), setup};
}

/// Two logs that may be parts of one, and what of the later one the earlier one already has.
class LogJoinTest : public testing::Test {
 protected:
  LogSource source(const std::string& name, const std::vector<StreamMessage>& messages) {
    std::filesystem::remove(logs_.path(name));
    const auto writer = logs_.write(name);
    for (const StreamMessage& message : messages) EXPECT_TRUE(writer->write({message}));
    EXPECT_TRUE(writer->container().close());
    auto opened = LogSource::open(logs_.path(name), {}, std::size_t{1} << 20U);
    EXPECT_TRUE(opened) << opened.error().describe();
    return std::move(*opened);
  }
  std::string whyNot(const std::vector<StreamMessage>& earlier, const std::vector<StreamMessage>& later,
                     robotlink::Duration offset = {}) {
    LogSource first = source("first.mcap", earlier), second = source("second.mcap", later);
    return whyNotJoined({first}, {second, offset});
  }
  /// The paths and times (in s) of the messages of the later log that are repeated.
  std::vector<std::string> repeated(const std::vector<StreamMessage>& earlier,
                                    const std::vector<StreamMessage>& later,
                                    robotlink::Duration offset = {}) {
    LogSource first = source("first.mcap", earlier), second = source("second.mcap", later);
    const LogSeam seam({first}, {second, offset});
    std::vector<std::string> found;
    mcap::Reader& reader = second.reader();
    reader.readAll([&](const mcap::Message& message) {
      const mcap::Channel& channel = reader.channels().at(message.channelId);
      if (seam.isRepeated(channel, reader.schemas().at(channel.schemaId).name, message))
        found.push_back(channel.topic + " " + std::to_string(message.logTime.time_since_epoch() / 1s));
      return true;
    });
    return found;
  }

  const tests::LogFixture logs_;
};

TEST_F(LogJoinTest, aLogContinuesOneThatEndsBeforeIt) {
  EXPECT_EQ(whyNot({plot("red1/a", 0, 1), plot("red1/a", 10, 1)}, {plot("red1/a", 10, 2)}), "");
  EXPECT_EQ(whyNot({plot("red1/a", 0, 1), plot("red1/a", 10, 1)}, {plot("red1/a", 500, 2)}), "")
      << "after any pause";
}

TEST_F(LogJoinTest, aSmallOverlapIsToleratedAndALargerOneNamesBothLogs) {
  const std::vector<StreamMessage> earlier = {plot("red1/a", 0, 1), plot("red1/a", 10, 1)};
  const auto from = [&](double time) {
    return whyNot(earlier, {plot("red1/a", time, 2), plot("red1/a", time + 10, 2)});
  };
  EXPECT_EQ(from(9.6), "") << "a twentieth of 10 s is half a second";
  EXPECT_EQ(from(9.4), "the times of first.mcap and second.mcap overlap");
}

TEST_F(LogJoinTest, anOffsetMovesALogBehindAnother) {
  const std::vector<StreamMessage> earlier = {plot("red1/a", 0, 1), plot("red1/a", 10, 1)};
  const std::vector<StreamMessage> later = {plot("red1/a", 0, 2), plot("red1/a", 10, 2)};
  EXPECT_THAT(whyNot(earlier, later), HasSubstr("overlap"));
  EXPECT_EQ(whyNot(earlier, later, 10s), "");
}

TEST_F(LogJoinTest, aRobotRunsTheSameProgramInBoth) {
  const auto with = [&](const std::string& before, const std::string& after) {
    return whyNot({programOf("red1", 0, before), plot("red1/plots/a", 1, 1)},
                  {programOf("red1", 2, after), plot("red1/plots/a", 3, 1)});
  };
  EXPECT_EQ(with("tasks: a", "tasks: a"), "");
  EXPECT_EQ(with("tasks: a", "tasks: b"), "red1 runs a different program in second.mcap than in first.mcap");
}

TEST_F(LogJoinTest, theLastProgramOfTheEarlierLogCountsAndTheFirstOfTheLater) {
  EXPECT_EQ(whyNot({programOf("red1", 0, "x"), programOf("red1", 1, "a")},
                   {programOf("red1", 2, "a"), programOf("red1", 3, "y")}),
            "");
}

TEST_F(LogJoinTest, aRobotThatIsNewHasAnyProgram) {
  EXPECT_EQ(whyNot({programOf("red1", 0, "a")}, {programOf("red1", 1, "a"), programOf("red2", 2, "b")}), "");
}

TEST_F(LogJoinTest, messagesAtTheInstantOfTheCutAreRepeatedIfTheyAreEqual) {
  const auto found =
      repeated({plot("red1/a", 1, 1), plot("red1/a", 5, 2), plot("red1/b", 5, 3)},
               {plot("red1/a", 5, 2), plot("red1/b", 5, 4), plot("red1/c", 5, 3), plot("red1/a", 6, 2)});
  EXPECT_THAT(found, testing::ElementsAre("red1/a 5"))
      << "another value, another stream and a later time are new";
}

TEST_F(LogJoinTest, theSeamIsFoundInTheTimeOfBothLogs) {
  EXPECT_THAT(repeated({plot("red1/a", 1, 1), plot("red1/a", 5, 2)},
                       {plot("red1/a", 0, 2), plot("red1/a", 1, 2)}, 5s),
              testing::ElementsAre("red1/a 0"));
}

TEST_F(LogJoinTest, messagesOfOtherFramesAreNoRepetition) {
  EXPECT_THAT(repeated({plot("red1/a", 5, 2, "cognition", 7)}, {plot("red1/a", 5, 2, "cognition", 8)}),
              testing::IsEmpty());
  EXPECT_THAT(repeated({plot("red1/a", 5, 2, "cognition", 7)}, {plot("red1/a", 5, 2, "cognition", 7)}),
              testing::ElementsAre("red1/a 5"));
}

}  // namespace
}  // namespace logplayer
