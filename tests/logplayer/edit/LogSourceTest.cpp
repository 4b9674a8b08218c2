// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/edit/LogSource.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/logplayer/LogFixture.h"
#include "tests/logplayer/SampleLog.h"

namespace logplayer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using tests::frameInfo;
using tests::LogFixture;
using tests::plot;

class LogSourceTest : public ::testing::Test {
 protected:
  LogSource source() {
    auto opened = LogSource::open(log_, {}, 16U << 20U);
    if (!opened) throw std::runtime_error(opened.error().describe());
    return std::move(*opened);
  }
  /// "cognition@0.4: red1/plots/a 3, red1/frames/cognition" for each unit: its streams, frames in capitals.
  static std::vector<std::string> units(LogSource& source) {
    std::vector<std::string> all;
    while (const auto unit = source.next()) {
      std::string text = unit->frame ? "frame" : "alone";
      text += "@" + std::to_string(robotlink::seconds(unit->time.time_since_epoch())).substr(0, 4);
      for (const auto& data : unit->messages)
        text += " " + source.reader().channels().at(data.message.channelId).topic;
      all.push_back(text);
    }
    return all;
  }
  void write(const std::vector<std::vector<robotlink::StreamMessage>>& groups) {
    const auto writer = fixture_.write();
    for (const auto& messages : groups) ASSERT_TRUE(writer->write(messages));
    ASSERT_TRUE(writer->container().close());
  }
  static robotlink::StreamMessage value(const std::string& name, double time, std::uint64_t frame) {
    return plot("red1/plots/" + name, time, 1, "cognition", frame);
  }
  static robotlink::StreamMessage end(double time, std::uint64_t frame) {
    return frameInfo("red1", "cognition", time, frame);
  }

  LogFixture fixture_;
  const std::filesystem::path log_ = fixture_.path();
};

TEST_F(LogSourceTest, messagesOfAFrameComeTogetherAndOthersAlone) {
  write({{plot("scores", 0, 1)},
         {value("a", 1, 1), value("b", 1, 1), end(1, 1)},
         {value("a", 2, 2), end(2, 2)}});
  LogSource log = source();
  EXPECT_THAT(units(log),
              ElementsAre("alone@0.00 scores", "frame@1.00 red1/plots/a red1/plots/b red1/frames/cognition",
                          "frame@2.00 red1/plots/a red1/frames/cognition"));
  EXPECT_THAT(log.losses(), IsEmpty());
  EXPECT_THAT(log.robots(), ElementsAre("red1"));
}

TEST_F(LogSourceTest, framesThatAreInterleavedAreTakenApart) {
  write({{value("a", 1, 1), value("a", 1.1, 2), value("b", 1.2, 1), end(1.2, 1), value("b", 1.3, 2),
          end(1.3, 2), value("late", 1.4, 2)}});
  LogSource log = source();
  EXPECT_THAT(units(log), ElementsAre("frame@1.20 red1/plots/a red1/plots/b red1/frames/cognition",
                                      "frame@1.30 red1/plots/a red1/plots/b red1/frames/cognition",
                                      "alone@1.40 red1/plots/late"));
}

TEST_F(LogSourceTest, aFrameIsInARangeIfItsEndIs) {
  write(
      {{value("a", 0.9, 1), end(1, 1)}, {value("a", 1.9, 2), end(2, 2)}, {value("a", 2.9, 3), end(3.1, 3)}});
  LogSource log = source();
  log.choose(tests::at(1), tests::at(3), {});
  EXPECT_THAT(units(log), ElementsAre("frame@1.00 red1/plots/a red1/frames/cognition",
                                      "frame@2.00 red1/plots/a red1/frames/cognition"));
  log.choose(tests::at(2.5), {}, {});
  EXPECT_THAT(units(log), ElementsAre("frame@3.10 red1/plots/a red1/frames/cognition"));
}

TEST_F(LogSourceTest, theEndOfAFrameGoesWithAnyOfItsStreamsUnlessItIsExcluded) {
  write({{value("a", 1, 1), value("b", 1, 1), end(1, 1)}});
  LogSource log = source();
  log.choose({}, {}, {{"*/a"}, {}});
  EXPECT_THAT(units(log), ElementsAre("frame@1.00 red1/plots/a red1/frames/cognition"));
  log.choose({}, {}, {{}, {"*/frames/*", "*/a"}});
  EXPECT_THAT(units(log), ElementsAre("frame@1.00 red1/plots/b"));
  log.choose({}, {}, {{"*/none"}, {}});
  EXPECT_THAT(units(log), IsEmpty());
}

TEST_F(LogSourceTest, framesWithoutTheirEndAreLeftOutAndCounted) {
  std::vector<robotlink::StreamMessage> messages;
  for (std::uint64_t frame = 1; frame <= 12; ++frame) messages.push_back(value("a", 1, frame));
  messages.push_back(end(1, 12));
  write({messages});
  LogSource log = source();
  EXPECT_THAT(units(log), ElementsAre("frame@1.00 red1/plots/a red1/frames/cognition"));
  EXPECT_THAT(log.losses(), ElementsAre(HasSubstr("11 frames left out, of which the end is missing")));
}

TEST_F(LogSourceTest, whatHoldsAtTheStartOfARangeIsItsNewestOfEachStream) {
  SampleLog().write(log_);
  LogSource log = source();
  EXPECT_THAT(log.held(), IsEmpty()) << "the range begins with the log";
  const auto heldAt = [&](int frame) {
    log.choose(sampleTime(frame), {}, {});
    std::vector<std::string> held;
    for (const auto& data : log.held())
      held.push_back(log.reader().channels().at(data.message.channelId).topic + " " +
                     std::string(data.message.data.begin(), data.message.data.end()));
    std::ranges::sort(held);
    return held;
  };
  EXPECT_THAT(heldAt(40), ElementsAre(HasSubstr("before"), HasSubstr("scene")));
  EXPECT_THAT(heldAt(60), ElementsAre(HasSubstr("after"), HasSubstr("scene")));
}

TEST_F(LogSourceTest, messagesThatCannotBeReadAreCounted) {
  SampleLog().write(log_);
  const auto chunks = (*mcap::Reader::open(log_, {}))->chunks();
  fixture_.flipByte(static_cast<std::streamoff>(chunks[1].offset + chunks[1].length - 40));
  LogSource log = source();
  const auto found = units(log);
  EXPECT_THAT(log.losses(), testing::Contains(HasSubstr("messages could not be read")));
  EXPECT_LT(found.size(), 202U);
  EXPECT_GT(found.size(), 150U) << "only one chunk is lost";
}

TEST_F(LogSourceTest, whatIsNoLogIsRefusedWithItsName) {
  std::ofstream(log_) << "some text";
  const auto opened = LogSource::open(log_, {}, 1U << 20U);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().describe(), HasSubstr("log.mcap"));
}

}  // namespace
}  // namespace logplayer
