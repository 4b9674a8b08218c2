// SPDX-License-Identifier: GPL-3.0-or-later
// Values over time of what a session's history has on disk.
#include <gmock/gmock.h>

#include <semaphore>

#include "logplayer/scratch/ScratchLog.h"
#include "logplayer/search/MessageSource.h"
#include "logplayer/search/NumberReader.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotlink/session/Session.h"
#include "tests/Eventually.h"

namespace logplayer {
namespace {

using namespace std::chrono_literals;
using robotlink::Instant;
using robotlink::StreamMessage;

Instant valueTime(double time) {
  return Instant(robotlink::fromSeconds(time));
}

StreamMessage valueMessage(const std::string& path, double time) {
  auto message = std::make_shared<robotcontrol::PlotValue>();
  message->set_value(time);
  return {path, valueTime(time), message};
}

/// Two streams in three pieces; of "slow" each message is older than most of its piece, as one is that held
/// for long.
class ScratchValuesTest : public testing::Test {
 protected:
  static inline const ScratchLog::Options kOptions{.bytes = 100U << 20U, .reserve = 0};

  static void fill(ScratchLog& log) {
    for (int piece = 0; piece < 3; ++piece) {
      std::vector<StreamMessage> messages{valueMessage("red1/slow", 10 * piece + 5)};
      for (int i = 0; i < 10; ++i) messages.push_back(valueMessage("red1/fast", 10 * piece + 10 + i));
      log.add(std::move(messages), {valueTime(10 * piece + 10), valueTime(10 * piece + 20)});
    }
  }
  static std::vector<double> valuesOf(MessageSource& source, const std::vector<std::string>& streams,
                                      double from) {
    std::vector<double> values;
    const auto cursor = source.read(streams, valueTime(from));
    while (const auto time = cursor->nextTime()) {
      const auto message = cursor->next();
      EXPECT_EQ(message->time, *time);
      values.push_back(robotlink::seconds(*time));
    }
    return values;
  }
  static std::vector<double> counted(int from, int to) {
    std::vector<double> all;
    for (int i = from; i < to; ++i) all.push_back(i);
    return all;
  }
};

TEST_F(ScratchValuesTest, messagesOfAllPiecesAreInOrderOfTime) {
  ScratchLog log(kOptions);
  fill(log);
  log.finish();
  const auto pieces = log.pieces();
  ASSERT_EQ(pieces.size(), 3U);
  for (const auto& piece : pieces) EXPECT_TRUE(!piece.file.empty() && piece.messages == nullptr);
  const auto source = historySource(pieces);
  ASSERT_TRUE(source->open({}));
  EXPECT_THAT(source->streams(), testing::ElementsAre("red1/fast", "red1/slow"));
  EXPECT_EQ(valuesOf(*source, {"red1/fast"}, 0), counted(10, 40));
  EXPECT_EQ(valuesOf(*source, {"red1/fast"}, 25), counted(25, 40));
  auto both = counted(10, 40);
  both.insert(both.begin(), 5);
  both.insert(both.begin() + 6, 15);
  both.insert(both.begin() + 17, 25);
  EXPECT_EQ(valuesOf(*source, {"red1/fast", "red1/slow"}, 0), both);
}

TEST_F(ScratchValuesTest, whatWaitsToBeWrittenIsReadFromMemory) {
  std::counting_semaphore<> written{0};
  ScratchLog::Options options = kOptions;
  options.beforeWrite = [&written] { written.acquire(); };
  {
    ScratchLog log(options);
    fill(log);
    const auto source = historySource(log.pieces());
    EXPECT_EQ(valuesOf(*source, {"red1/fast"}, 0), counted(10, 40));
    written.release(3);
    log.finish();
    // What it had in memory it has, whatever became of it.
    log.clear();
    EXPECT_EQ(valuesOf(*source, {"red1/fast"}, 0), counted(10, 40));
  }
}

TEST_F(ScratchValuesTest, filesThatWereRemovedAreLeftOut) {
  ScratchLog log(kOptions);
  fill(log);
  log.finish();
  const auto pieces = log.pieces();
  std::filesystem::remove(pieces[1].file);
  const auto source = historySource(pieces);
  auto rest = counted(10, 20);
  for (const double value : counted(30, 40)) rest.push_back(value);
  EXPECT_EQ(valuesOf(*source, {"red1/fast"}, 0), rest);
}

TEST_F(ScratchValuesTest, numbersAreReadInTheBackground) {
  ScratchLog log(kOptions);
  fill(log);
  log.finish();
  const LogNumber fast{"red1/fast", "value"}, sum{"", "red1/fast.value + red1/slow.value"};
  NumberReader reader(historySource(log.pieces()), 4);
  reader.read({fast, sum});
  std::map<LogNumber, NumberReader::Points> all;
  ASSERT_TRUE(eventually([&] {
    const auto news = reader.take();
    for (const auto& [number, points] : news.points)
      all[number].insert(all[number].end(), points.begin(), points.end());
    return news.complete.size() == 2;
  }));
  ASSERT_EQ(all[fast].size(), 30U);
  EXPECT_EQ(all[fast].back(), (robotlink::Series::Point{39, 39}));
  ASSERT_FALSE(all[sum].empty());
  EXPECT_EQ(all[sum].back(), (robotlink::Series::Point{39, 64}));
}

}  // namespace
}  // namespace logplayer
